// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "math/frame.h"

namespace qrelief {

/// Pose of a model on the printer.
enum class BuildPose : std::uint8_t {
  AsModelled,  ///< its +Z is up
  CodeUp,      ///< the code lies flat and faces up
  CodeUpright  ///< the code is upright like a wall, its top up
};

/// Returns "as-modelled", "code-up" or "code-upright". Scripts rely on these names.
const char* buildPoseName(BuildPose pose);

/// Angle between a surface's normal and the printer's vertical beyond which plastic sags or needs supports: the usual
/// rule of thumb, 45° below horizontal.
inline constexpr double kSteepestOverhangDeg = 135;

struct BuildDirection {
  BuildPose pose = BuildPose::AsModelled;
  std::optional<Vec3> up = {};  ///< the printer's vertical in the model's space, any length > 0; none: set by the pose

  /// Returns the printer's vertical for a code in that frame.
  Vec3 resolve(const ProjectionFrame& frame) const;

  bool operator==(const BuildDirection&) const = default;
};

}  // namespace qrelief
