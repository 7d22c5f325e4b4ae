// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/sky_fraction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/grid_march.h"

namespace qrelief {
namespace {

constexpr double kDepthModules = 0.5;
constexpr int kDirections = 32;
constexpr double kReachModules = 8;  // a wall at this distance takes less than 0.4 % of the sky

bool isLight(const Symbol& symbol, int row, int column) {
  const bool inside = row >= 0 && column >= 0 && row < symbol.size && column < symbol.size;
  return !inside || !symbol.isDark(row, column);
}

/// Returns the distance from the middle of a module to the next light module, in modules, along a direction that is not
/// a multiple of 90°.
double distanceToLight(const Symbol& symbol, int row, int column, double angle) {
  const Vec2 along(std::cos(angle), std::sin(angle));  // columns, rows
  GridMarch march({column, row}, Vec2(0.5), along);
  for (;;) {
    const double distance = march.step();
    if (distance >= kReachModules || isLight(symbol, march.cell().y, march.cell().x)) return distance;
  }
}

double fractionOf(const Symbol& symbol, int row, int column) {
  if (!symbol.isDark(row, column)) return 1;
  double sum = 0;
  for (int k = 0; k < kDirections; ++k) {
    // The directions lie between the axes and the diagonals, because two modules only touch along a diagonal.
    const double distance = distanceToLight(symbol, row, column, 2 * std::numbers::pi * (k + 0.5) / kDirections);
    sum += distance * distance / (distance * distance + kDepthModules * kDepthModules);
  }
  return sum / kDirections;
}

}  // namespace

double SkyFraction::ofModuleAlone() {
  Symbol alone;
  alone.size = 1;
  alone.dark = {1, 1, 1};
  return fractionOf(alone, 0, 0);
}

SkyFraction::SkyFraction(const Symbol& symbol) : fractions_(symbol.size, symbol.size) {
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) fractions_.at(row, column) = fractionOf(symbol, row, column);
}

double SkyFraction::mean(const Symbol& symbol) const {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < fractions_.size(); ++i) {
    if (symbol.roles[i] != ModuleRole::Data || !symbol.dark[i]) continue;
    sum += fractions_[i];
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

void SkyFraction::update(const Symbol& symbol, int row, int column) {
  const int reach = static_cast<int>(kReachModules) + 1;
  const int top = std::max(0, row - reach), bottom = std::min(symbol.size - 1, row + reach);
  const int left = std::max(0, column - reach), right = std::min(symbol.size - 1, column + reach);
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) fractions_.at(y, x) = fractionOf(symbol, y, x);
}

}  // namespace qrelief
