// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "qr/symbol.h"

namespace qrelief {

/// Returns a symbol of light data modules. @param size  modules along an edge
inline Symbol lightSymbol(int size) {
  Symbol symbol;
  symbol.size = size;
  symbol.dark = {size, size};
  symbol.roles = {size, size};
  return symbol;
}

}  // namespace qrelief
