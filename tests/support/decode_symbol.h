// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ZXing/ReadBarcode.h>
#include <vector>

#include "qr/symbol.h"

namespace qrelief {

/// Decodes a clean picture of the symbol with ZXing-C++.
inline ZXing::Result decodeSymbol(const Symbol& symbol) {
  constexpr int kPixels = 3;
  const int edge = kPixels * (symbol.size + 2 * kQuietZoneModules);
  std::vector<std::uint8_t> picture(static_cast<std::size_t>(edge * edge), 255);
  for (int y = 0; y < edge; ++y) {
    for (int x = 0; x < edge; ++x) {
      const int row = y / kPixels - kQuietZoneModules, column = x / kPixels - kQuietZoneModules;
      const bool isInside = row >= 0 && column >= 0 && row < symbol.size && column < symbol.size;
      if (isInside && symbol.isDark(row, column)) picture[static_cast<std::size_t>(y * edge + x)] = 0;
    }
  }
  const ZXing::ImageView view(picture.data(), edge, edge, ZXing::ImageFormat::Lum);
  return ZXing::ReadBarcode(view, ZXing::DecodeHints().setFormats(ZXing::BarcodeFormat::QRCode).setIsPure(true));
}

}  // namespace qrelief
