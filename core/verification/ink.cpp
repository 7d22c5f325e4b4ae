// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/ink.h"

#include <cassert>
#include <cmath>

namespace qrelief {

InkMap::InkMap(const Symbol& symbol, double symbolMm, Ink ink)
    : pixels_(symbol.size), pixelMm_(symbolMm / symbol.size), darkFactor_(static_cast<float>(ink.dark / ink.light)) {
  for (int row = symbol.size - 1; row >= 0; --row)
    for (int column = 0; column < symbol.size; ++column)
      darkShares_.push_back(symbol.isDark(row, column) ? 1.0f : 0.0f);
}

InkMap::InkMap(std::vector<float> darkShares, double pixelMm, Ink ink)
    : darkShares_(std::move(darkShares)),
      pixels_(static_cast<int>(std::lround(std::sqrt(static_cast<double>(darkShares_.size()))))),
      pixelMm_(pixelMm),
      darkFactor_(static_cast<float>(ink.dark / ink.light)) {
  assert(static_cast<std::size_t>(pixels_) * static_cast<std::size_t>(pixels_) == darkShares_.size());
}

float InkMap::factor(Vec2 onPlane) const {
  const Vec2 place = onPlane / pixelMm_ + pixels_ / 2.0;
  if (!(place.x >= 0 && place.y >= 0 && place.x < pixels_ && place.y < pixels_)) return 1;
  const auto pixel = static_cast<std::size_t>(static_cast<int>(place.y) * pixels_ + static_cast<int>(place.x));
  return 1 + darkShares_[pixel] * (darkFactor_ - 1);
}

void InkMap::apply(std::vector<float>& luminance, double pixelMm) const {
  const int pixels = static_cast<int>(std::lround(std::sqrt(static_cast<double>(luminance.size()))));
  for (int row = 0; row < pixels; ++row)
    for (int column = 0; column < pixels; ++column)
      luminance[static_cast<std::size_t>(row * pixels + column)] *=
          factor(pixelMm * (Vec2(column, row) + 0.5 - pixels / 2.0));
}

std::vector<double> withoutInversion(std::vector<double> luminance, const Ink& ink) {
  if (ink.isInverted())
    for (double& value : luminance) value = 1 + ink.dark / ink.light - value;
  return luminance;
}

}  // namespace qrelief
