// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "math/frame.h"

namespace qrelief {

/// How a model stands on the printer.
enum class BuildPose : std::uint8_t {
  AsModelled,  ///< its +Z is up
  CodeUp,      ///< the code lies and looks up
  CodeUpright  ///< the code stands like a wall, its top up
};

/// "as-modelled", "code-up", "code-upright": names that scripts rely on.
const char* buildPoseName(BuildPose pose);

/// Angle between a surface's normal and the printer's vertical beyond which plastic sags or stands on supports: the
/// rule of thumb of printers, 45° below the level.
inline constexpr double kSteepestOverhangDeg = 135;

struct BuildDirection {
  BuildPose pose = BuildPose::AsModelled;
  std::optional<Vec3> up = {};  ///< the printer's vertical in the model's space, of any length > 0; none: by the pose

  /// The printer's vertical, for a code that lies there.
  Vec3 resolve(const ProjectionFrame& frame) const;

  bool operator==(const BuildDirection&) const = default;
};

}  // namespace qrelief
