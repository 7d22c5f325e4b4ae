// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/ink.h"

namespace qrelief {

InkMap::InkMap(const Symbol& symbol, double symbolMm, Ink ink)
    : InkMap(BottomUp<float>(symbol.size, symbol.size), symbolMm / symbol.size, ink) {
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column)
      darkShares_.at(row, column) = symbol.isDark(symbol.size - 1 - row, column) ? 1 : 0;
}

InkMap::InkMap(BottomUp<float> darkShares, double pixelMm, Ink ink)
    : darkShares_(std::move(darkShares)), pixelMm_(pixelMm), darkFactor_(static_cast<float>(ink.dark / ink.light)) {}

float InkMap::factor(Vec2 onPlane) const {
  const Vec2 place = onPlane / pixelMm_ + darkShares_.columns() / 2.0;
  if (!(place.x >= 0 && place.y >= 0 && place.x < darkShares_.columns() && place.y < darkShares_.rows())) return 1;
  return 1 + darkShares_.at(static_cast<int>(place.y), static_cast<int>(place.x)) * (darkFactor_ - 1);
}

void InkMap::apply(BottomUp<float>& luminance, double pixelMm) const {
  for (int row = 0; row < luminance.rows(); ++row)
    for (int column = 0; column < luminance.columns(); ++column)
      luminance.at(row, column) *= factor(pixelMm * (Vec2(column, row) + 0.5 - luminance.rows() / 2.0));
}

Grid<double> withoutInversion(Grid<double> luminance, const Ink& ink) {
  if (ink.isInverted())
    for (double& value : luminance) value = 1 + ink.dark / ink.light - value;
  return luminance;
}

}  // namespace qrelief
