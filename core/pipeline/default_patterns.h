// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "settings/engrave_request.h"

namespace qrelief {

/// Greatest depth of a pocket where the request names none, in modules. Walls limit most pockets before
/// (docs/decisions/0042-whole-finders-where-walls-allow.md).
inline constexpr double kMaxDepthModules = 4;

/// Contrast of codes with whole finders, as a factor of the preset's: with it they are as deep on average as codes with
/// patterned finders and the preset's contrast. Modules narrower than kSmallModuleNozzles lose more of it in print.
inline constexpr double kWholeFinderContrast = 5.0 / 6, kWholeFinderContrastSmall = 0.9, kSmallModuleNozzles = 2.6;

/// Depth that the pockets of whole finders need, in modules. Less deep, their middle sees too much of the sky.
inline constexpr double kWholeFinderDepthModules = 1.5;

/// Fills in the patterns, the contrast and the greatest depth that a request leaves open.
///
/// Dark modules get `thick-plus`. Finders are carved whole, with a smaller contrast, in a request that names no pattern
/// and is for even light, flat floors and ContrastSolver::Fast. Finders are `thick-plus-sharp`, with the preset's
/// contrast, in every other request, and where walls are too thin for whole ones.
/// @param moduleMm      > 0
/// @param areWallsThin  see wallsAreThinForWholeFinders()
EngraveRequest withDefaultPatterns(EngraveRequest request, double moduleMm, bool areWallsThin = false);

/// @param limitsMm  greatest depths of a mask with whole finders, (5·modules)² from the symbol's top left, mm
bool wallsAreThinForWholeFinders(const Symbol& symbol, const std::vector<double>& limitsMm, double moduleMm);

/// Least width of a module that prints, before anything is carved, mm: by what published prints say of the patterns
/// (verification/printability.h).
double leastPrintableModuleMm(const Symbol& symbol, const EngraveRequest& request);

}  // namespace qrelief
