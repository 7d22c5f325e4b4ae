// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ZXing/ReadBarcode.h>

#include "qr/symbol.h"

namespace qrelief {

/// Returns a symbol of light data modules. @param size  modules along an edge
Symbol lightSymbol(int size);

/// Decodes a clean picture of the symbol with ZXing-C++.
ZXing::Result decodeSymbol(const Symbol& symbol);

}  // namespace qrelief
