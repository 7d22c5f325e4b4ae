// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "study/carved_code.h"
#include "study/spot.h"

namespace qrelief::study {

/// The search of Peng, Liu, Lu, Sharf, Liu, Lischinski, Chen, "Fabricable Unobtrusive 3D-QR-Codes with Directional
/// Light", CGF 39(5), 2020: every dark submodule gets as deep as the shadow that one lamp casts into it needs.
///
/// From the authors' own program of 2018 (directional_light.cpp, module_adapter.cpp):
///   grey level  g = int(19.6 · (0.87 · (24a + 456d))^0.3441 + 21.24), a the share of the sky (dark: 1, light: by 500
///               rays), d = L·n where the lamp is seen, else 0
///   wanted      g ≤ white − 255 · 0.20, white the mean of the brightest tenth of the light submodules
///   lamp        elevation 50°, and 40° for modules that are to be dark under the lower lamp alone; from the left
///   step        a fifth of a submodule's edge
/// The runs of dark modules along the lamp's rows are broken up before (breakUpRuns2020).
///
/// Chosen where it is silent: the lamp is asked for at 32 points of a submodule, as floors are steps here and each
/// step shades the next; light modules that the lamp does not reach are no reason to give up.
struct OneLightOptions {
  double contrast = 0.20;  ///< of the grey scale
  double upperElevationDeg = 50, lowerElevationDeg = 40;
  double azimuthDeg = 180;  ///< 180: the lamp stands on the left
  bool lock = false;        ///< add modules that are dark under the lower lamp alone (lockedModules2020)
  double stepSubmodules = 0.2;
  double maxDepthModules = kPublishedMaxDepthModules;
  int rays = 500;
  int maxPasses = 300;
  std::uint64_t seed = 1;
};

/// Points of a submodule at which the lamp is asked for: the first of the Halton sequence.
inline constexpr int kLampPoints = 32;

/// Grey level of a share of the sky and L·n where the lamp is seen, else 0.
int oneLightGrey(double sky, double lamp);

/// Breaks up horizontal runs of more than three dark modules: from its left end on, the third module, or the middle one
/// of runs below six, is made light if its block can afford it, by the same budget as in symbol_flips_2019.h.
void breakUpRuns2020(Symbol& symbol);

/// Light data modules of block 0 whose four neighbours are light, so many that the block cannot be restored if all are
/// dark: what locks the code to the upper lamp. Row-major 0 or 1; empty where the symbol has too few.
std::vector<std::uint8_t> lockedModules2020(const Symbol& symbol);

Result<CarvedCode> carveOneLight2020(const Spot& spot, const Symbol& symbol, const SubmoduleMask& mask,
                                     const OneLightOptions& options);

}  // namespace qrelief::study
