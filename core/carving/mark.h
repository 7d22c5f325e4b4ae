// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace qrelief {

/// Technique for the dark modules.
enum class Mark : std::uint8_t {
  Shadow,  ///< pockets of the model's own material, dark by their shade
  Inlay,   ///< a flush body of a second material, of even depth
  Paint    ///< the model's own facets, cut along the modules' outlines and given a second material; nothing is carved
};

/// Returns "shadow", "inlay" or "paint". Scripts rely on these names.
constexpr std::string_view markName(Mark mark) {
  constexpr std::array<std::string_view, 3> kNames = {"shadow", "inlay", "paint"};
  return kNames[static_cast<std::size_t>(mark)];
}

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
