// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_layout.h"

#include <algorithm>

#include "batch/plate_layout.h"

namespace qrelief {

std::size_t BatchLayout::count() const { return (rows + together() - 1) / together(); }

std::size_t BatchLayout::end(std::size_t unit) const { return std::min(begin(unit + 1), rows); }

std::size_t BatchLayout::rowsOf(const Shard& share) const {
  std::size_t own = 0;
  for (std::size_t unit = share.index; unit < count(); unit += share.count) own += end(unit) - begin(unit);
  return own;
}

std::string BatchLayout::plate(std::size_t unit) const {
  if (perPlate == 0) return "";
  if (firstNumber == 1) return plateName(unit, count());
  return plateName(firstNumber + begin(unit) - 1, firstNumber + rows - 1);
}

}  // namespace qrelief
