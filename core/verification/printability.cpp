// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/printability.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "label/label_layout.h"
#include "message_codes/text.h"
#include "message_codes/verdict.h"

namespace qrelief {
namespace {

constexpr double kRoundingMm = 1e-9;

constexpr int kN = kSubmodulesPerModule;

/// Least width of a pocket that opens in print, in nozzle widths: `thin-plus` with 0.6 nozzle widths did not open,
/// `thick-plus` with 0.9 did.
constexpr double kMinPocketNozzles = 0.9;
constexpr double kMinDepthLayers = 2;

/// Returns the least module that was printed and read with a 0.4 mm nozzle, in nozzle widths.
std::optional<double> leastModuleNozzles(ModulePattern pattern) {
  switch (pattern) {
    case ModulePattern::Square:
    case ModulePattern::Diamond:
      return 0.9 / 0.4;
    case ModulePattern::ThickPlus:
      return 0.6 / 0.4;
    case ModulePattern::None:
      return 1.2 / 0.4;
    case ModulePattern::ThinPlus:
      break;
  }
  return std::nullopt;
}

/// Returns the edge of the largest carved square within one module, in submodules.
int largestSquare(const SubmoduleMask& mask, int row, int column) {
  for (int size = kN; size > 0; --size)
    for (int r = 0; r + size <= kN; ++r)
      for (int c = 0; c + size <= kN; ++c) {
        bool whole = true;
        for (int k = 0; k < size * size && whole; ++k)
          whole = mask.at(kN * row + r + k / size, kN * column + c + k % size);
        if (whole) return size;
      }
  return 0;
}

/// Returns the length of the shortest run of material between two carved submodules in a row or column.
int shortestGap(const SubmoduleMask& mask) {
  int shortest = std::numeric_limits<int>::max();
  for (int line = 0; line < mask.rows(); ++line)
    for (const bool across : {true, false}) {
      int last = -1;  // the last carved one
      for (int k = 0; k < mask.rows(); ++k) {
        if (!(across ? mask.at(line, k) : mask.at(k, line))) continue;
        if (last >= 0 && k - last > 1) shortest = std::min(shortest, k - last - 1);
        last = k;
      }
    }
  return shortest;
}

/// Counts the submodules of one module in which the mask differs from a pattern.
int differences(const SubmoduleMask& mask, int row, int column, const SubmoduleMask& pattern) {
  int count = 0;
  for (int k = 0; k < kN * kN; ++k) {
    const int r = kN * row + k / kN, c = kN * column + k % kN;
    count += mask.at(r, c) != pattern.at(r, c);
  }
  return count;
}

/// Finds the pattern that differs least from the data modules on average.
std::optional<ModulePattern> recognised(const Symbol& symbol, const SubmoduleMask& mask) {
  constexpr std::array kPatterns = {ModulePattern::None, ModulePattern::Square, ModulePattern::ThinPlus,
                                    ModulePattern::Diamond, ModulePattern::ThickPlus};
  constexpr double kAlike = 3;  // differing submodules of 25, on average
  std::optional<ModulePattern> best;
  double least = kAlike;
  for (const ModulePattern pattern : kPatterns) {
    const SubmoduleMask expected = submodulesToCarve(symbol, pattern, FinderPattern::None);
    int wrong = 0, modules = 0;
    for (int row = 0; row < symbol.size; ++row)
      for (int column = 0; column < symbol.size; ++column) {
        if (!symbol.isDark(row, column) || symbol.role(row, column) != ModuleRole::Data) continue;
        wrong += differences(mask, row, column, expected);
        ++modules;
      }
    if (modules > 0 && static_cast<double>(wrong) / modules < least) {
      least = static_cast<double>(wrong) / modules;
      best = pattern;
    }
  }
  return best;
}

/// Depth that suffices for any printer, used where the depths are not known before carving. Small enough to be summed
/// without overflow.
constexpr double kAnyDepthMm = 1e6;
constexpr double kModuleStepMm = 0.01;
constexpr int kMostNozzles = 100;  // modules of this many nozzle widths have open pockets in any pattern

CarvedFeatures withModulesOf(CarvedFeatures features, double moduleMm) {
  const double factor = moduleMm / features.moduleMm;
  features.moduleMm *= factor;
  features.pocketMm *= factor;
  features.gapMm *= factor;
  return features;
}

/// Rounds up to a twentieth of a millimetre.
double inTwentieths(double mm) { return std::ceil(mm * 20 - 1e-6) / 20; }

}  // namespace

CarvedFeatures measureFeatures(const Symbol& symbol, const SubmoduleMask& mask, std::span<const double> depthMm,
                               double moduleMm) {
  assert(mask.rows() == kN * symbol.size && depthMm.size() == mask.size());
  CarvedFeatures features;
  features.moduleMm = moduleMm;
  features.pattern = recognised(symbol, mask);
  int count = 0;
  std::vector<int> squares;
  std::vector<double> deepest;
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) {
      const int square = largestSquare(mask, row, column);
      if (square == 0) continue;
      squares.push_back(square);
      double most = 0;
      for (int k = 0; k < kN * kN; ++k) {
        const std::size_t i = mask.index(kN * row + k / kN, kN * column + k % kN);
        if (!mask[i]) continue;
        features.meanDepthMm += depthMm[i];
        most = std::max(most, depthMm[i]);
        ++count;
      }
      deepest.push_back(most);
    }
  if (count == 0) return features;
  std::sort(deepest.begin(), deepest.end());
  std::sort(squares.begin(), squares.end());
  features.meanDepthMm /= count;
  features.leastDepthMm = deepest[deepest.size() / 20];
  features.pocketMm = squares[squares.size() / 2] * moduleMm / kN;
  const int gap = shortestGap(mask);
  features.gapMm =
      gap == std::numeric_limits<int>::max() ? std::numeric_limits<double>::infinity() : gap * moduleMm / kN;
  return features;
}

double finestStrokeMm(const Printer& printer) {
  const auto process = processOf(printer);
  return process ? std::max(2 * process->cornerRadiusMm, process->finestMm) : 0;
}

std::optional<Message> adviseLabel(double capitalMm, const Printer& printer) {
  const double leastMm = leastCapitalMm(finestStrokeMm(printer));
  if (capitalMm >= leastMm - kRoundingMm) return std::nullopt;
  return message<"label-too-small">(with::lengthMm<"height">(capitalMm), with::lengthMm<"least">(leastMm));
}

std::vector<Message> advisePrinting(const CarvedFeatures& features, const Printer& printer, double minWallMm) {
  std::vector<Message> advice;
  const double minPocketMm = kMinPocketNozzles * printer.nozzleMm;
  if (features.pocketMm < minPocketMm - kRoundingMm) {
    const double neededMm = inTwentieths(features.moduleMm * minPocketMm / features.pocketMm);
    if (features.pattern == ModulePattern::ThinPlus)
      advice.push_back(message<"thin-plus-narrower-than-nozzle">(
          with::lengthMm<"pocket">(features.pocketMm), with::lengthMm<"nozzle">(printer.nozzleMm),
          with::lengthMm<"needed">(neededMm), with::choice<"square">("pattern", "square")));
    else
      advice.push_back(message<"pockets-narrower-than-nozzle">(with::lengthMm<"pocket">(features.pocketMm),
                                                               with::lengthMm<"nozzle">(printer.nozzleMm),
                                                               with::lengthMm<"needed">(neededMm)));
  } else if (features.pattern) {
    const auto least = leastModuleNozzles(*features.pattern);
    const double neededMm = inTwentieths(least.value_or(0) * printer.nozzleMm);
    const std::string_view pattern = modulePatternName(*features.pattern);
    if (!least || features.moduleMm >= *least * printer.nozzleMm - kRoundingMm) {
      // no smaller than modules that were printed and read
    } else if (*features.pattern == ModulePattern::ThickPlus) {
      advice.push_back(message<"thick-plus-smaller-than-printed">(
          with::lengthMm<"module">(features.moduleMm), with::choice<"pattern">("pattern", pattern),
          with::lengthMm<"nozzle">(printer.nozzleMm), with::lengthMm<"needed">(neededMm)));
    } else {
      advice.push_back(message<"modules-smaller-than-printed">(
          with::lengthMm<"module">(features.moduleMm), with::choice<"pattern">("pattern", pattern),
          with::lengthMm<"nozzle">(printer.nozzleMm), with::lengthMm<"needed">(neededMm),
          with::choice<"thickPlus">("pattern", "thick-plus")));
    }
  }
  if (features.leastDepthMm < kMinDepthLayers * printer.layerMm - kRoundingMm)
    advice.push_back(message<"shallower-than-layers">(
        with::lengthMm<"depth">(features.leastDepthMm),
        with::number<"count">(std::round(10 * features.leastDepthMm / printer.layerMm) / 10),
        with::lengthMm<"layer">(printer.layerMm)));
  if (features.labelCapitalMm)
    if (auto label = adviseLabel(*features.labelCapitalMm, printer)) advice.push_back(std::move(*label));
  if (features.wallMm && *features.wallMm < minWallMm - 1e-3)
    advice.push_back(
        message<"wall-behind-pocket">(with::lengthMm<"wall">(*features.wallMm), with::number<"wanted">(minWallMm)));
  return advice;
}

double printableModuleMm(const CarvedFeatures& features, double nozzleMm) {
  const double leastMm = features.pattern ? leastModuleNozzles(*features.pattern).value_or(0) * nozzleMm : 0;
  return std::max(leastMm, features.moduleMm * kMinPocketNozzles * nozzleMm / features.pocketMm);
}

double printableNozzleMm(const CarvedFeatures& features) {
  const double widestMm = features.pocketMm / kMinPocketNozzles;
  const auto least = features.pattern ? leastModuleNozzles(*features.pattern) : std::nullopt;
  return least ? std::min(widestMm, features.moduleMm / *least) : widestMm;
}

double printableLayerMm(const CarvedFeatures& features) { return features.leastDepthMm / kMinDepthLayers; }

double leastPrintableModuleMm(const Symbol& symbol, const ModuleMask& modules, FinderPattern finders,
                              const Printer& printer) {
  const SubmoduleMask mask = submodulesToCarve(symbol, modules, finders);
  const std::vector<double> depths(mask.size(), kAnyDepthMm);
  const CarvedFeatures features = measureFeatures(symbol, mask, depths, 1);
  // Bisection works because a warning at one size also applies to all smaller sizes.
  int tooSmall = 0, enough = static_cast<int>(std::ceil(kMostNozzles * printer.nozzleMm / kModuleStepMm));
  while (enough - tooSmall > 1) {
    const int middle = tooSmall + (enough - tooSmall) / 2;
    const bool printable = advisePrinting(withModulesOf(features, middle * kModuleStepMm), printer).empty();
    (printable ? enough : tooSmall) = middle;
  }
  return enough * kModuleStepMm;
}

}  // namespace qrelief
