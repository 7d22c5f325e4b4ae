// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "study/carved_code.h"
#include "study/spot.h"

namespace qrelief::study {

/// The search of Peng, Liu, Lu, Sharf, Liu, Lischinski, Chen, "Fabricable Unobtrusive 3D-QR-Codes with Directional
/// Light", CGF 39(5), 2020: makes every dark submodule as deep as it must be for the shadow of one lamp.
///
/// From the authors' own program of 2018 (directional_light.cpp, module_adapter.cpp):
///   grey level  g = int(19.6 · (0.87 · (24a + 456d))^0.3441 + 21.24), a the share of the sky (dark: 1, light: by 500
///               rays), d = L·n where the lamp is visible, else 0
///   wanted      g ≤ white − 255 · 0.20, white the mean of the brightest tenth of the light submodules
///   lamp        elevation 50°, and 40° for modules that must be dark under the lower lamp alone; from the left
///   step        a fifth of a submodule's edge
/// Before the search, runs of dark modules along the lamp's rows are broken up (breakUpRuns2020).
///
/// Our choices where the program says nothing: the lamp is tested at 32 points of a submodule, because floors are steps
/// here and each step shades the next; light modules that the lamp does not reach do not stop the search.
struct OneLightOptions {
  double contrast = 0.20;  ///< of the grey scale
  double upperElevationDeg = 50, lowerElevationDeg = 40;
  double azimuthDeg = 180;  ///< 180: the lamp is on the left
  bool lock = false;        ///< add modules that are dark under the lower lamp alone (lockedModules2020)
  double stepSubmodules = 0.2;
  double maxDepthModules = kPublishedMaxDepthModules;
  std::size_t rays = 500;
  int maxPasses = 300;
  std::uint64_t seed = 1;
};

/// Number of points at which the lamp is tested in a submodule: the first of the Halton sequence.
inline constexpr int kLampPoints = 32;

/// Returns the grey level for a share of the sky and L·n where the lamp is visible, else 0.
int oneLightGrey(double sky, double lamp);

/// Breaks up horizontal runs of more than three dark modules. Counting from the run's left end, makes the third module
/// light, or the middle module if the run is shorter than six. Does so only if the module's block can afford it, by the
/// same budget as in symbol_flips_2019.h.
void breakUpRuns2020(Symbol& symbol);

/// Returns the modules that lock the code to the upper lamp: light data modules of block 0 with four light neighbours,
/// so many that the block cannot be restored if all of them are dark. Row-major 0 or 1; empty if the symbol has too
/// few.
std::vector<std::uint8_t> lockedModules2020(const Symbol& symbol);

Result<CarvedCode> carveOneLight2020(const StudyPlacement& spot, const Symbol& symbol, const SubmoduleMask& mask,
                                     const OneLightOptions& options);

}  // namespace qrelief::study
