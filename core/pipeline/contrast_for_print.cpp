// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/contrast_for_print.h"

#include <algorithm>
#include <array>

#include "depth/light_neighbours.h"
#include "verification/grades.h"

namespace qrelief {
namespace {

/// Limits of a module's target contrast: a multiple of the common target, and the most that any pocket can have.
constexpr double kMostTimes = 2, kMostContrast = 0.8;

/// Returns the contrast of every dark module; 0 for light ones.
std::vector<double> contrastsOf(const Symbol& symbol, const Grid<double>& submodules) {
  const ModuleReflectances seen = measureModules(symbol, submodules);
  const LightNeighbours neighbours(symbol);
  std::vector<double> contrasts(symbol.dark.size(), 0);
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) {
      if (!symbol.isDark(row, column)) continue;
      const auto module = static_cast<std::size_t>(row * symbol.size + column);
      contrasts[module] = 1 - seen.at(row, column) / neighbours.darkestMean(module, seen.values);
    }
  return contrasts;
}

}  // namespace

std::vector<double> contrastForPrint(const Symbol& symbol, const Grid<double>& designed, const Grid<double>& printed,
                                     double contrast) {
  const std::vector<double> target = contrastsOf(symbol, designed), has = contrastsOf(symbol, printed);
  const auto kindOf = [&](std::size_t module) {
    const int row = static_cast<int>(module) / symbol.size, column = static_cast<int>(module) % symbol.size;
    return static_cast<std::size_t>(symbol.role(row, column) == ModuleRole::Finder);
  };
  std::array<double, 2> sum{}, count{};
  for (std::size_t module = 0; module < target.size(); ++module) {
    if (!symbol.dark[module]) continue;
    sum[kindOf(module)] += target[module];
    count[kindOf(module)] += 1;
  }
  const double most = std::max(contrast, std::min(kMostTimes * contrast, kMostContrast));
  std::vector<double> asked(target.size(), contrast);
  for (std::size_t module = 0; module < target.size(); ++module) {
    const std::size_t kind = kindOf(module);
    if (!symbol.dark[module] || sum[kind] <= 0) continue;
    const double share = has[module] / (sum[kind] / count[kind]);
    asked[module] = std::clamp(contrast * (1 + kPrintedShare - share), contrast, most);
  }
  return asked;
}

}  // namespace qrelief
