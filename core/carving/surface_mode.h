// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace qrelief {

/// Surface of the symbol's square, carved and uncarved [Papp 2022, §5].
enum class SurfaceMode : std::uint8_t {
  Preserved,  ///< the model's own facets, cut by the pockets' outlines; only facets under a pocket change
  Resampled   ///< a grid through the submodules' corners, projected on the surface and joined to the facets it cuts
};

/// Returns the name used on the command line.
constexpr std::string_view surfaceModeName(SurfaceMode mode) {
  return mode == SurfaceMode::Preserved ? "preserved" : "resampled";
}

}  // namespace qrelief
