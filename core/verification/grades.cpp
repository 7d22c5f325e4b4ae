// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/grades.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>

#include "qr/codewords.h"
#include "qr/module_pattern.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;

/// Fraction of each row of submodules within the middle 80 % of a module: the outer rows count half.
constexpr std::array<double, kN> kAperture = {0.5, 1, 1, 1, 0.5};

/// Lower bounds of the grades A, B, C and D.
using Levels = std::array<double, 4>;
constexpr Levels kSymbolContrast = {0.70, 0.55, 0.40, 0.20};
constexpr Levels kModulation = {0.50, 0.40, 0.30, 0.20};
constexpr Levels kUnusedCorrection = {0.62, 0.50, 0.37, 0.25};
constexpr Levels kCellContrast = {0.30, 0.25, 0.20, 0.15};

double gradeFrom(double value, const Levels& levels) {
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (value >= levels[i]) return 4.0 - static_cast<double>(i);
  return 0;
}

Grade graded(double value, const Levels& levels) { return {value, gradeFrom(value, levels)}; }

/// Returns the unused error correction of the worst block: 1 − errors / correctable; below 0 where a block cannot be
/// corrected. Errors are codewords with a wrong module and codewords spoilt on purpose.
double unusedCorrection(const CodewordLayout& layout, const std::vector<std::uint8_t>& wrongModules) {
  std::vector<std::uint8_t> wrong = layout.isSpoilt;
  for (std::size_t i = 0; i < wrongModules.size(); ++i)
    if (wrongModules[i] && layout.codewordOfModule[i] >= 0) wrong[layout.codewordOfModule[i]] = 1;
  std::vector<int> errors(static_cast<std::size_t>(layout.structure.blocks), 0);
  for (std::size_t i = 0; i < wrong.size(); ++i) errors[layout.blockOfCodeword[i]] += wrong[i];
  const int worst = *std::max_element(errors.begin(), errors.end());
  return 1 - static_cast<double>(worst) / layout.structure.correctable();
}

/// Grades by the highest level at which error correction can make up for the modules below it [ISO/IEC 15415, 7.8.4].
Grade gradedWithCorrection(const CodewordLayout& layout, const std::vector<double>& modulation) {
  double best = 0;
  std::vector<std::uint8_t> below(modulation.size());
  for (std::size_t level = 0; level < kModulation.size(); ++level) {
    for (std::size_t i = 0; i < modulation.size(); ++i) below[i] = modulation[i] < kModulation[level];
    const double corrected = gradeFrom(unusedCorrection(layout, below), kUnusedCorrection);
    best = std::max(best, std::min(4.0 - static_cast<double>(level), corrected));
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < modulation.size(); ++i)
    if (layout.codewordOfModule[i] >= 0) least = std::min(least, modulation[i]);
  return {least, best};
}

/// Grades by the fraction of damage: 4 for none, otherwise 3, less 1 for each bound that is reached.
double gradeByFraction(double fraction, const std::array<double, 3>& bounds) {
  if (fraction == 0) return 4;
  for (std::size_t i = 0; i < bounds.size(); ++i)
    if (fraction < bounds[i]) return 3.0 - static_cast<double>(i);
  return 0;
}

bool isFinderOrSeparatorOf(const Symbol& symbol, int corner, int row, int column) {
  const ModuleRole role = symbol.role(row, column);
  if (role != ModuleRole::Finder && role != ModuleRole::Separator) return false;
  const bool right = column >= symbol.size / 2, bottom = row >= symbol.size / 2;
  return corner == (bottom ? 2 : right ? 1 : 0);
}

/// Returns the least grade of finder patterns, timing and alignment [ISO/IEC 18004, annex on symbol quality].
Grade fixedPatternDamage(const Symbol& symbol, const Grid<std::uint8_t>& wrong) {
  std::array<int, 3> finder{};
  int timing = 0, timingWrong = 0, alignmentModules = 0, all = 0;
  std::vector<std::pair<int, int>> alignmentWrong;
  for (int row = 0; row < symbol.size; ++row) {
    for (int column = 0; column < symbol.size; ++column) {
      const ModuleRole role = symbol.role(row, column);
      const bool bad = wrong.at(row, column) != 0;
      for (int corner = 0; corner < 3; ++corner)
        finder[corner] += bad && isFinderOrSeparatorOf(symbol, corner, row, column);
      timing += role == ModuleRole::Timing;
      timingWrong += bad && role == ModuleRole::Timing;
      alignmentModules += role == ModuleRole::Alignment;
      if (bad && role == ModuleRole::Alignment) alignmentWrong.emplace_back(row, column);
      all += bad && role != ModuleRole::Data && role != ModuleRole::Format && role != ModuleRole::Version;
    }
  }
  double grade = 4;
  for (const int count : finder) grade = std::min(grade, std::max(0.0, 4.0 - count));
  if (timing > 0)
    grade = std::min(grade, gradeByFraction(static_cast<double>(timingWrong) / timing, {0.07, 0.11, 0.14}));
  if (alignmentModules > 0) {
    // Wrong modules less than 5 modules apart belong to one pattern.
    int damaged = 0;
    std::vector<std::pair<int, int>> seen;
    for (const auto& [row, column] : alignmentWrong) {
      const bool known = std::any_of(seen.begin(), seen.end(), [&, r = row, c = column](const auto& other) {
        return std::abs(other.first - r) < 5 && std::abs(other.second - c) < 5;
      });
      damaged += !known;
      if (!known) seen.emplace_back(row, column);
    }
    grade = std::min(grade, gradeByFraction(25.0 * damaged / alignmentModules, {0.10, 0.20, 0.30}));
  }
  return {static_cast<double>(all), grade};
}

/// Grades format and version information. Each copy gets 4 less its wrong bits; the mean of both copies is rounded, and
/// the worse of format and version counts.
Grade formatInformation(const Symbol& symbol, const Grid<std::uint8_t>& wrong) {
  std::array<int, 2> format{}, version{};
  for (int row = 0; row < symbol.size; ++row) {
    for (int column = 0; column < symbol.size; ++column) {
      if (!wrong.at(row, column)) continue;
      const ModuleRole role = symbol.role(row, column);
      const bool first = row < 9 && column < 9;
      if (role == ModuleRole::Format) ++format[first ? 0 : 1];
      if (role == ModuleRole::Version) ++version[row < 9 ? 0 : 1];
    }
  }
  const auto gradeOf = [](const std::array<int, 2>& bits) {
    const auto one = [](int count) { return count > 3 ? 0.0 : 4.0 - count; };
    return std::round((one(bits[0]) + one(bits[1])) / 2);
  };
  return {static_cast<double>(format[0] + format[1] + version[0] + version[1]),
          std::min(gradeOf(format), gradeOf(version))};
}

struct Extremes {
  double brightest = 0, darkest = 0;   // of all modules, quiet zone included
  double meanLight = 0, meanDark = 0;  // of the symbol's light and dark modules
};

Extremes extremesOf(const ModuleReflectances& measured) {
  Extremes e;
  const auto [low, high] = std::minmax_element(measured.values.begin(), measured.values.end());
  e.darkest = *low;
  e.brightest = *high;
  int light = 0, dark = 0;
  for (int row = 0; row < measured.symbol->size; ++row) {
    for (int column = 0; column < measured.symbol->size; ++column) {
      const bool isDark = measured.symbol->isDark(row, column);
      (isDark ? e.meanDark : e.meanLight) += measured.at(row, column);
      ++(isDark ? dark : light);
    }
  }
  e.meanLight /= light;
  e.meanDark /= dark;
  return e;
}

/// Returns the modules on the wrong side of the threshold.
Grid<std::uint8_t> wrongModules(const ModuleReflectances& measured, double threshold) {
  const Symbol& symbol = *measured.symbol;
  Grid<std::uint8_t> wrong(symbol.size, symbol.size);
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column)
      wrong.at(row, column) = (measured.at(row, column) < threshold) != symbol.isDark(row, column);
  return wrong;
}

/// Returns the threshold that splits the values into two classes with the least variance within them [Otsu 1979;
/// ISO/IEC 29158 asks for the same by its own histogram method].
double separation(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  double total = 0, below = 0, best = -1, threshold = values.front();
  for (const double v : values) total += v;
  const auto count = static_cast<double>(values.size());
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    below += values[i];
    const double n = static_cast<double>(i + 1);
    const double apart = below / n - (total - below) / (count - n);
    const double between = n * (count - n) * apart * apart;
    if (values[i] < values[i + 1] && between > best) {
      best = between;
      threshold = (values[i] + values[i + 1]) / 2;
    }
  }
  return threshold;
}

std::vector<double> symbolValues(const ModuleReflectances& measured) {
  std::vector<double> values;
  values.reserve(measured.symbol->dark.size());
  for (int row = 0; row < measured.symbol->size; ++row)
    for (int column = 0; column < measured.symbol->size; ++column) values.push_back(measured.at(row, column));
  return values;
}

void gradeIso15415(SymbolGrades& grades, const ModuleReflectances& measured, const CodewordLayout& layout,
                   const Extremes& e, double white) {
  const double contrast = e.brightest - e.darkest;
  const double threshold = (e.brightest + e.darkest) / 2;
  const Grid<std::uint8_t> wrong = wrongModules(measured, threshold);
  std::vector<double> modulation = symbolValues(measured);
  for (double& m : modulation) m = contrast > 0 ? 2 * std::abs(m - threshold) / contrast : 0;
  grades.symbolContrast = graded(contrast * white, kSymbolContrast);
  grades.modulation = gradedWithCorrection(layout, modulation);
  for (std::size_t i = 0; i < modulation.size(); ++i)
    if (wrong[i]) modulation[i] = 0;
  grades.reflectanceMargin = gradedWithCorrection(layout, modulation);
}

void gradeIso29158(SymbolGrades& grades, const ModuleReflectances& measured, const CodewordLayout& layout,
                   const Extremes& e, double threshold) {
  std::vector<double> modulation = symbolValues(measured);
  for (double& m : modulation) {
    const double reach = m >= threshold ? e.meanLight - threshold : threshold - e.meanDark;
    m = reach > 0 ? std::abs(m - threshold) / reach : 0;
  }
  const Grid<std::uint8_t> wrong = wrongModules(measured, threshold);
  for (std::size_t i = 0; i < modulation.size(); ++i)
    if (wrong[i]) modulation[i] = 0;
  grades.cellContrast = graded(e.meanLight > 0 ? (e.meanLight - e.meanDark) / e.meanLight : 0, kCellContrast);
  grades.cellModulation = gradedWithCorrection(layout, modulation);
}

}  // namespace

Grid<std::uint8_t> misreadModules(const ModuleReflectances& measured) {
  return wrongModules(measured, separation(symbolValues(measured)));
}

ModuleReflectances measureModules(const Symbol& symbol, const Grid<double>& submodules) {
  const int edge = symbol.size + 2 * kQuietZoneModules;
  assert(submodules.rows() == edge * kN);
  ModuleReflectances measured{&symbol, {edge, edge}};
  for (int row = 0; row < edge; ++row) {
    for (int column = 0; column < edge; ++column) {
      double sum = 0, weights = 0;
      for (int k = 0; k < kN * kN; ++k) {
        const double weight = kAperture[k / kN] * kAperture[k % kN];
        sum += weight * submodules.at(row * kN + k / kN, column * kN + k % kN);
        weights += weight;
      }
      measured.values.at(row, column) = sum / weights;
    }
  }
  return measured;
}

SymbolGrades gradeSymbol(const ModuleReflectances& measured, double white) {
  const Symbol& symbol = *measured.symbol;
  const CodewordLayout layout = layoutCodewords(symbol);
  const Extremes extremes = extremesOf(measured);
  const double threshold = separation(symbolValues(measured));
  const Grid<std::uint8_t> wrong = wrongModules(measured, threshold);

  SymbolGrades grades;
  const double unused = unusedCorrection(layout, wrong.values());
  grades.decode = {unused >= 0 ? 1.0 : 0.0, unused >= 0 ? 4.0 : 0.0};
  grades.unusedCorrection = graded(std::max(0.0, unused), kUnusedCorrection);
  grades.fixedPatternDamage = fixedPatternDamage(symbol, wrong);
  grades.formatInformation = formatInformation(symbol, wrong);
  gradeIso15415(grades, measured, layout, extremes, white);
  gradeIso29158(grades, measured, layout, extremes, threshold);
  const double common = std::min({grades.decode.grade, grades.unusedCorrection.grade, grades.fixedPatternDamage.grade,
                                  grades.formatInformation.grade});
  grades.iso15415 =
      std::min({common, grades.symbolContrast.grade, grades.modulation.grade, grades.reflectanceMargin.grade});
  grades.iso29158 = std::min({common, grades.cellContrast.grade, grades.cellModulation.grade});
  return grades;
}

}  // namespace qrelief
