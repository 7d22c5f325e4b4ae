// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "depth/submodule_luminances.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"

namespace qrelief {

/// Layout of the symbol's submodules in a map of cells with a margin all round; one cell is one submodule.
struct CellLayout {
  int modules = 0;  ///< along the symbol's edge
  static constexpr int kN = kSubmodulesPerModule;

  bool operator==(const CellLayout&) const = default;

  int cells() const { return kN * (modules + 2 * (kQuietZoneModules + kOcclusionMarginModules)); }
  /// @param row, column  from the quiet zone's top left; maps count rows from the bottom
  std::uint32_t ofQuietZone(int row, int column) const {
    const int offset = kN * kOcclusionMarginModules;
    return static_cast<std::uint32_t>((cells() - 1 - (row + offset)) * cells() + column + offset);
  }
  std::uint32_t ofSymbol(int row, int column) const {
    return ofQuietZone(row + kN * kQuietZoneModules, column + kN * kQuietZoneModules);
  }
};

}  // namespace qrelief
