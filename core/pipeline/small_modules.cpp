// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/small_modules.h"

#include "qr/symbol_shaping.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

constexpr ModulePattern kLargeModulePattern = ModulePattern::ThickPlus;
constexpr FinderPattern kLargeFinderPattern = FinderPattern::ThickPlusSharp;

bool isCarvedWhole(const EngraveRequest& request, double moduleMm) {
  return moduleMm < kSmallModuleNozzles * request.printer.nozzleMm && !request.modulePattern && request.process &&
         request.objective == DepthObjective::Contrast && request.solver == ContrastSolver::Fast &&
         request.floor == FloorShape::Flat && request.lights.empty();
}

}  // namespace

SizedCode codeOfSize(EngraveRequest request, Symbol symbol, double moduleMm) {
  const bool isWhole = isCarvedWhole(request, moduleMm);
  if (!request.maxDepthMm) request.maxDepthMm = (isWhole ? kMaxDepthSmallModules : kMaxDepthModules) * moduleMm;
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

}  // namespace qrelief
