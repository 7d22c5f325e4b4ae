// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/engrave_request.h"

namespace qrelief {

/// Modules narrower than this are small beside the nozzle.
inline constexpr double kSmallModuleNozzles = 2.6;

/// The deepest pocket that a request allows by itself, in modules, and that of small modules.
inline constexpr double kMaxDepthModules = 1.2, kMaxDepthSmallModules = 4;

/// The contrast of small modules, in that of the preset.
inline constexpr double kSmallModuleContrast = 5.0 / 6;

/// A request and its symbol once the size of a module is known.
struct SizedCode {
  EngraveRequest request;  ///< with both patterns
  Symbol symbol;
};

/// Decides what a request leaves to the size of a module.
///
/// A pattern leaves a part of each module uncarved. Where modules are small beside the nozzle, the printer fills what
/// is left of the pockets. There the whole of each dark module is carved, dark areas are broken up
/// (qr/symbol_shaping.h), pockets may be deeper, and the contrast is five sixths of the preset's, which comes to about
/// the same mean depth. Other modules get `thick-plus` (docs/decisions/0038-small-modules-are-carved-whole.md).
///
/// What the request says itself stays. One that names its module pattern, one whose print is not looked at, and one for
/// lamps, for shaped floors or by another search than ContrastSolver::Fast gets nothing but the patterns that it leaves
/// open.
/// @param moduleMm  > 0
SizedCode codeOfSize(EngraveRequest request, Symbol symbol, double moduleMm);

/// Of a symbol before its size is known, by what published prints say (verification/printability.h).
double leastPrintableModuleMm(const Symbol& symbol, const EngraveRequest& request);

}  // namespace qrelief
