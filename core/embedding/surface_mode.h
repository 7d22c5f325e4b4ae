// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace qrelief {

/// What the surface of the symbol's square is made of, where it is carved and where it is not [Papp 2022, §5].
enum class SurfaceMode : std::uint8_t {
  Preserved,  ///< the model's own facets, cut by the pockets' outlines; only facets that a pocket meets are touched
  Resampled   ///< a grid through the submodules' corners, projected on the surface; joined to the facets it cuts
};

/// Names as on the command line.
constexpr std::string_view surfaceModeName(SurfaceMode mode) {
  return mode == SurfaceMode::Preserved ? "preserved" : "resampled";
}

}  // namespace qrelief
