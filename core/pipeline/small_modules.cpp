// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/small_modules.h"

#include "qr/symbol_shaping.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

constexpr ModulePattern kLargeModulePattern = ModulePattern::ThickPlus;
constexpr FinderPattern kLargeFinderPattern = FinderPattern::ThickPlusSharp;

bool carvesSmallModulesWhole(const EngraveRequest& request) {
  return !request.modulePattern && request.process && request.objective == DepthObjective::Contrast &&
         request.solver == ContrastSolver::Fast && request.floor == FloorShape::Flat && request.lights.empty();
}

bool isSmall(const EngraveRequest& request, double moduleMm) {
  return moduleMm < kSmallModuleNozzles * request.printer.nozzleMm;
}

}  // namespace

SizedCode codeOfSize(EngraveRequest request, Symbol symbol, double moduleMm) {
  const bool isWhole = carvesSmallModulesWhole(request) && isSmall(request, moduleMm);
  request.maxDepthMm = maxDepthMm(request, moduleMm);
  if (isWhole) {
    if (!request.contrast) request.contrast = kSmallModuleContrast * request.contrastAsked();
    if (!request.symbol.breakUpDarkAreas) breakUpDarkAreas(symbol);
    request.symbol.breakUpDarkAreas = true;
  }
  if (!request.modulePattern) request.modulePattern = isWhole ? ModulePattern::None : kLargeModulePattern;
  if (!request.finderPattern) request.finderPattern = isWhole ? FinderPattern::None : kLargeFinderPattern;
  return {std::move(request), std::move(symbol)};
}

double leastPrintableModuleMm(const Symbol& symbol, const EngraveRequest& request) {
  return leastPrintableModuleMm(symbol, request.modulePattern.value_or(kLargeModulePattern),
                                request.finderPattern.value_or(kLargeFinderPattern), request.printer);
}

double maxDepthMm(const EngraveRequest& request, double moduleMm) {
  const bool isWhole = carvesSmallModulesWhole(request) && isSmall(request, moduleMm);
  return request.maxDepthMm.value_or((isWhole ? kMaxDepthSmallModules : kMaxDepthModules) * moduleMm);
}

}  // namespace qrelief
