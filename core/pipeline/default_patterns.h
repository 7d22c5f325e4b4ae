// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "qr/symbol.h"

namespace qrelief {

struct EngraveRequest;

/// Default maximum depth of a pocket, in modules. Walls limit most pockets first
/// (docs/decisions/0042-whole-finders-where-walls-allow.md).
inline constexpr double kMaxDepthModules = 4;

/// Contrast of codes with whole finder patterns, as a factor of the preset's contrast. It makes them as deep on average
/// as codes with patterned finders at the preset's contrast. Modules narrower than kSmallModuleNozzles lose more
/// contrast in print and need the larger factor.
inline constexpr double kWholeFinderContrast = 5.0 / 6, kWholeFinderContrastSmall = 0.9, kSmallModuleNozzles = 2.6;

/// Least depth of the pockets of whole finders, in modules. In a shallower pocket the middle sees too much of the sky.
inline constexpr double kWholeFinderDepthModules = 1.5;

/// Fills in the patterns, contrast and maximum depth that a request leaves open.
///
/// Dark modules get `thick-plus` if the request names no pattern and no mask. Finders are then carved whole, with a
/// smaller contrast, for even light and ContrastSolver::Fast. Otherwise, or where walls are too thin for whole finders,
/// finders are `thick-plus-sharp`, with the preset's contrast.
/// @param moduleMm      > 0
/// @param areWallsThin  see wallsAreThinForWholeFinders()
EngraveRequest withDefaultPatterns(EngraveRequest request, double moduleMm, bool areWallsThin = false);

/// @param limitsMm  greatest depths of a mask with whole finders, (5·modules)² values from the symbol's top left, mm
bool wallsAreThinForWholeFinders(const Symbol& symbol, const std::vector<double>& limitsMm, double moduleMm);

/// Returns the least width of a printable module before carving, mm, derived from published prints of the patterns
/// (verification/printability.h); for a code in colour, the width of a line.
double leastPrintableModuleMm(const Symbol& symbol, const EngraveRequest& request);

}  // namespace qrelief
