// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/default_patterns.h"

#include <cmath>

#include "settings/engrave_request.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

constexpr ModulePattern kModules = ModulePattern::ThickPlus;
constexpr FinderPattern kPatternedFinders = FinderPattern::ThickPlusSharp;

/// Share of the finders' submodules that may be less deep than kWholeFinderDepthModules.
constexpr double kMostShallow = 0.1;

bool mayHaveWholeFinders(const EngraveRequest& request) {
  return !request.code.modulePattern && !request.code.ownPattern && !request.code.finderPattern &&
         request.depth.objective == DepthObjective::Contrast && request.depth.solver == ContrastSolver::Fast &&
         request.depth.lights.empty();
}

}  // namespace

EngraveRequest withDefaultPatterns(EngraveRequest request, double moduleMm, bool areWallsThin) {
  const bool hasWholeFinders = mayHaveWholeFinders(request) && !areWallsThin;
  const bool isSmall = moduleMm < kSmallModuleNozzles * request.print.printer.nozzleMm;
  if (hasWholeFinders && !request.depth.contrast)
    request.depth.contrast =
        (isSmall ? kWholeFinderContrastSmall : kWholeFinderContrast) * request.depth.contrastAsked();
  if (!request.code.finderPattern)
    request.code.finderPattern = hasWholeFinders ? FinderPattern::None : kPatternedFinders;
  if (!request.code.modulePattern) request.code.modulePattern = kModules;
  if (!request.depth.maxDepthMm) request.depth.maxDepthMm = kMaxDepthModules * moduleMm;
  return request;
}

bool wallsAreThinForWholeFinders(const Symbol& symbol, const std::vector<double>& limitsMm, double moduleMm) {
  const int edge = kSubmodulesPerModule * symbol.size;
  int shallow = 0, count = 0;
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column) {
      const int moduleRow = row / kSubmodulesPerModule, moduleColumn = column / kSubmodulesPerModule;
      if (symbol.role(moduleRow, moduleColumn) != ModuleRole::Finder || !symbol.isDark(moduleRow, moduleColumn))
        continue;
      ++count;
      shallow += limitsMm[row * edge + column] < kWholeFinderDepthModules * moduleMm;
    }
  return shallow > kMostShallow * count;
}

double leastPrintableModuleMm(const Symbol& symbol, const EngraveRequest& request) {
  if (request.code.isText()) {
    const auto layout = layOutLabel(request.code.lettering(), symbol.size);
    return layout ? finestStrokeMm(request.print.printer) / layout->thinnestStrokeModules : 0;
  }
  if (request.marking.isInColour()) return std::ceil(100 * lineWidthMm(request.print.printer) - 1e-6) / 100;
  return leastPrintableModuleMm(symbol, request.code.ownPattern.value_or(request.code.modulePattern.value_or(kModules)),
                                request.code.finderPattern.value_or(kPatternedFinders), request.print.printer);
}

}  // namespace qrelief
