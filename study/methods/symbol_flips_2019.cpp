// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/symbol_flips_2019.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "math/vec.h"
#include "qr/codewords.h"

namespace qrelief::study {
namespace {

constexpr int kRays = 720;

bool isDark(const Symbol& symbol, int row, int column) {
  return row >= 0 && column >= 0 && row < symbol.size && column < symbol.size && symbol.isDark(row, column);
}

/// Returns the length of a ray from a dark module's middle to the first light module, in modules.
double reach(const Symbol& symbol, int row, int column, Vec2 direction) {
  Vec2 next;  // along the ray to the next border, for columns and rows
  for (int axis = 0; axis < 2; ++axis) next[axis] = 0.5 / std::abs(direction[axis]);
  for (;;) {
    const int axis = next.x < next.y ? 0 : 1;
    (axis == 0 ? column : row) += direction[axis] > 0 ? 1 : -1;
    if (!isDark(symbol, row, column)) return next[axis];
    next[axis] += 1 / std::abs(direction[axis]);
  }
}

/// Numbers the 4-connected dark areas by module, -1 for light modules. @returns number of areas
int labelDarkAreas(const Symbol& symbol, std::vector<int>& label) {
  label.assign(symbol.dark.size(), -1);
  int count = 0;
  for (std::size_t first = 0; first < symbol.dark.size(); ++first) {
    if (!symbol.dark[first] || label[first] >= 0) continue;
    std::vector<int> open = {static_cast<int>(first)};
    label[first] = count;
    while (!open.empty()) {
      const int module = open.back(), row = module / symbol.size, column = module % symbol.size;
      open.pop_back();
      constexpr int kAround[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
      for (const auto& step : kAround) {
        const int next = (row + step[0]) * symbol.size + column + step[1];
        if (!isDark(symbol, row + step[0], column + step[1]) || label[static_cast<std::size_t>(next)] >= 0) continue;
        label[static_cast<std::size_t>(next)] = count;
        open.push_back(next);
      }
    }
    ++count;
  }
  return count;
}

/// Returns the dark modules, those of the widest areas first.
std::vector<std::size_t> widestFirst(const Symbol& symbol) {
  std::vector<int> label;
  const auto areas = static_cast<std::size_t>(labelDarkAreas(symbol, label));
  std::vector<double> seen(symbol.dark.size(), 0), mean(areas, 0), count(areas, 0);
  std::vector<std::size_t> modules;
  for (std::size_t i = 0; i < symbol.dark.size(); ++i) {
    if (!symbol.dark[i]) continue;
    modules.push_back(i);
    seen[i] = visibleArea2019(symbol, static_cast<int>(i) / symbol.size, static_cast<int>(i) % symbol.size);
    mean[static_cast<std::size_t>(label[i])] += seen[i];
    ++count[static_cast<std::size_t>(label[i])];
  }
  for (std::size_t area = 0; area < areas; ++area) mean[area] /= count[area];
  const auto areaOf = [&](std::size_t i) { return static_cast<std::size_t>(label[i]); };
  std::stable_sort(modules.begin(), modules.end(), [&](std::size_t a, std::size_t b) {
    if (label[a] != label[b]) {
      if (mean[areaOf(a)] != mean[areaOf(b)]) return mean[areaOf(a)] > mean[areaOf(b)];
      return label[a] < label[b];
    }
    return seen[a] > seen[b];
  });
  return modules;
}

}  // namespace

double visibleArea2019(const Symbol& symbol, int row, int column) {
  double area = 0;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / kRays;
    const double length = reach(symbol, row, column, {std::cos(angle), std::sin(angle)});
    area += length * length * std::numbers::pi / kRays;
  }
  return area;
}

int flipBudget2019(const Symbol& symbol) {
  const BlockStructure own = blockStructure(symbol.version, symbol.errorCorrection),
                       least = blockStructure(symbol.version, ErrorCorrection::L);
  return std::max(0, (own.checkCodewords * own.blocks - least.checkCodewords * least.blocks) / 2 / own.blocks);
}

void flipModules2019(Symbol& symbol) {
  const CodewordLayout layout = layoutCodewords(symbol);
  std::vector<int> left(static_cast<std::size_t>(layout.structure.blocks), flipBudget2019(symbol));
  std::vector<char> isSpoilt(layout.blockOfCodeword.size(), 0);
  symbol.flipped = {symbol.size, symbol.size};
  const auto hasBudget = [](int budget) { return budget > 0; };
  while (std::any_of(left.begin(), left.end(), hasBudget)) {
    const std::vector<std::size_t> modules = widestFirst(symbol);
    const auto mayFlip = [&](std::size_t module) {
      if (symbol.roles[module] != ModuleRole::Data) return false;
      const int codeword = layout.codewordOfModule[module];
      if (codeword < 0 || isSpoilt[static_cast<std::size_t>(codeword)]) return true;
      return left[static_cast<std::size_t>(layout.blockOfCodeword[static_cast<std::size_t>(codeword)])] > 0;
    };
    const auto chosen = std::find_if(modules.begin(), modules.end(), mayFlip);
    if (chosen == modules.end()) return;
    if (const int codeword = layout.codewordOfModule[*chosen]; codeword >= 0) {
      const auto index = static_cast<std::size_t>(codeword);
      if (!isSpoilt[index]) --left[static_cast<std::size_t>(layout.blockOfCodeword[index])];
      isSpoilt[index] = 1;
    }
    symbol.dark[*chosen] = 0;
    symbol.flipped[*chosen] = 1;
  }
}

}  // namespace qrelief::study
