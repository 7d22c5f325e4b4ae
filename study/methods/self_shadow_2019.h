// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "study/carved_code.h"
#include "study/spot.h"

namespace qrelief::study {

/// The search of Peng, Lu, Liu, Sharf, Chen, "Fabricating QR codes on 3D objects using self-shadows", CAD 114 (2019).
///
/// Every dark submodule starts one step deep. Rays from its middle measure how much sky it sees, and a model fitted to
/// photographs converts that to a grey level. Every submodule that is not darker than the white modules by a fifth of
/// the grey scale gets one step deeper, until all are.
///
/// The text was not available; the constants are from the authors' own program of 2017 (optimization.cpp):
///   grey level        g = round(195.6 · V^0.09219), V a sample's visibility; 0 … 255
///   white             the mean of the brightest tenth of the white submodules' greys
///   wanted            g ≤ white − 255 · 0.20; in its later version 0.12 for data modules
///   step              mean diagonal of a projected submodule; √2/5 = 0.28 module for squares, but the openings in its
///                     logs fit pits that grow by 0.39 to 0.47 modules a step: we use 0.42
///   rays              50,000 a sample, 5,000 in previews
/// Our choices where the program says nothing or differs:
///   - visibility: for dark samples it is not a plain share. The program spreads rays within the opening only and
///     scales their mean by its solid angle A. V = A/π · (cosine-weighted share of the sky) matches its logs, the
///     share alone does not: an isolated module at 1.38 modules' depth has 0.025 in the log, 0.143 by the share, 0.021
///     by this product. White samples use the share.
///   - rays are Halton points over the whole hemisphere; so few are lost that `rays` = 512 replace their 50,000.
///     Samples that are far too light get fewer, down to an eighth (measureUntilClear()).
///   - step: the nominal one, 0.28 module, gives a mean of 34 % more steps than the log has. With 0.42 module the mean
///     is the log's (7.0), but a finder pattern's ring takes 6.2 steps where the log has 7 to 10. The log does not say
///     by how much the mesh under a submodule grows in a step, so no single step fits both.
///   - walls: their program has none; here no floor comes closer to another side than the spot's wall.
struct SelfShadowOptions {
  double functionContrast = 0.20;  ///< of the grey scale, for finder patterns, timing, alignment, format and version
  double dataContrast = 0.20;      ///< for data modules; 0.12 in the later version
  double stepModules = 0.42;       ///< matches its log
  double maxDepthModules = kPublishedMaxDepthModules;
  std::size_t rays = 512;
  int maxPasses = 60;
  std::uint64_t seed = 1;
};

/// Returns the grey level 0 … 255 of a visibility, rounded as in the program.
double selfShadowGrey(double visibility);

/// Carves with this search.
/// @param mask  of the symbol; the program carves whole modules (ModulePattern::None)
Result<CarvedCode> carveSelfShadow2019(const StudyPlacement& spot, const Symbol& symbol, const SubmoduleMask& mask,
                                       const SelfShadowOptions& options);

}  // namespace qrelief::study
