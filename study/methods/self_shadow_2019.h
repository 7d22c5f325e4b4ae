// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "study/carved_code.h"
#include "study/spot.h"

namespace qrelief::study {

/// The search of Peng, Lu, Liu, Sharf, Chen, "Fabricating QR codes on 3D objects using self-shadows", CAD 114 (2019).
///
/// Every dark submodule begins one step deep. Rays from its middle find what it sees of the sky; a model fitted to
/// photographs says how grey that looks; what is not darker than the white modules by a fifth of the grey scale gets a
/// step deeper, until none is left.
///
/// The text could not be had; the constants are those of the authors' own program of 2017 (optimization.cpp):
///   grey level        g = round(195.6 · V^0.09219), V a sample's visibility; 0 … 255
///   white             the mean of the brightest tenth of the white submodules' greys
///   wanted            g ≤ white − 255 · 0.20; in its later version 0.12 for data modules
///   step              mean diagonal of a projected submodule; √2/5 = 0.28 module for squares, but the openings in its
///   logs
///                     are those of pits that grow by 0.39 to 0.47 modules a step: 0.42 is taken
///   rays              50,000 a sample, 5,000 in previews
/// Where it is silent, and what was chosen:
///   - its visibility of dark samples is no plain one: rays are spread within the opening alone and their mean is
///   scaled
///     by its solid angle A. Its logs are met by V = A/π · (cosine-weighted share of the sky), not by that share alone:
///     an isolated module at 1.38 modules' depth has 0.025 in the log, 0.143 by the share, 0.021 by this product. White
///     samples take the share.
///   - rays are Halton points over the whole hemisphere; so few are lost that `rays` = 512 do for their 50,000.
///   - step: the nominal one, 0.28 module, gives a mean of 34 % more steps than the log has. With 0.42 module the mean
///     is the log's (7.0), but a finder's ring takes 6.2 steps where the log has 7 to 10. The log does not say by how
///     much the mesh under a submodule grows in a step, so no single step meets both.
///   - walls: their program has none; here no floor comes nearer to another side than the spot's wall.
struct SelfShadowOptions {
  double functionContrast = 0.20;  ///< of the grey scale, for finders, timing, alignment, format and version
  double dataContrast = 0.20;      ///< for data modules; 0.12 in the later version
  double stepModules = 0.42;       ///< as its log has it
  double maxDepthModules = kPublishedMaxDepthModules;
  int rays = 512;
  int maxPasses = 60;
  std::uint64_t seed = 1;
};

/// Grey level 0 … 255 of a visibility, rounded as the program does.
double selfShadowGrey(double visibility);

/// @param mask  of the symbol; the program carves whole modules (ModulePattern::None)
Result<CarvedCode> carveSelfShadow2019(const Spot& spot, const Symbol& symbol, const SubmoduleMask& mask,
                                       const SelfShadowOptions& options);

}  // namespace qrelief::study
