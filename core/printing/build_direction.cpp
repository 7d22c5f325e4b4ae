// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/build_direction.h"

#include <array>

namespace qrelief {

const char* buildPoseName(BuildPose pose) {
  constexpr std::array kNames = {"as-modelled", "code-up", "code-upright"};
  return kNames[static_cast<std::size_t>(pose)];
}

Vec3 BuildDirection::resolve(const ProjectionFrame& frame) const {
  if (up) return *up;
  switch (pose) {
    case BuildPose::AsModelled:
      break;
    case BuildPose::CodeUp:
      return frame.normal;
    case BuildPose::CodeUpright:
      return frame.up;
  }
  return {0, 0, 1};
}

}  // namespace qrelief
