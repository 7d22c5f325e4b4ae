// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/symbol_shaping.h"

#include <array>
#include <cassert>

#include "qr/codewords.h"
#include "qr/sky_fraction.h"

namespace qrelief {
namespace {

constexpr int kMasks = 8;
constexpr int kFormatBits = 15;

/// Returns the BCH code (15, 5) of level and mask, under the format's own mask [ISO/IEC 18004, 7.9.1].
int formatInformation(ErrorCorrection level, int mask) {
  constexpr std::array<int, 4> kLevelBits = {0b01, 0b00, 0b11, 0b10};
  constexpr int kGenerator = 0b10100110111, kFormatMask = 0b101010000010010;
  const int data = kLevelBits[static_cast<std::size_t>(level)] << 3 | mask;
  int remainder = data << 10;
  for (int bit = kFormatBits - 1; bit >= 10; --bit)
    if (remainder >> bit & 1) remainder ^= kGenerator << (bit - 10);
  return (data << 10 | remainder) ^ kFormatMask;
}

void setDark(Symbol& symbol, int row, int column, bool dark) { symbol.dark.at(row, column) = dark ? 1 : 0; }

/// Writes both copies, least significant bit first [ISO/IEC 18004, figure 25].
void writeFormatInformation(Symbol& symbol, int bits) {
  const int last = symbol.size - 1;
  for (int i = 0; i < kFormatBits; ++i) {
    const bool dark = bits >> i & 1;
    // Down column 8 past the timing row, then along row 8 to the left past the timing column.
    if (i < 8)
      setDark(symbol, i < 6 ? i : i + 1, 8, dark);
    else
      setDark(symbol, 8, i == 8 ? 7 : kFormatBits - 1 - i, dark);
    // Along row 8 from the right, then down column 8 to the bottom.
    if (i < 8)
      setDark(symbol, 8, last - i, dark);
    else
      setDark(symbol, last - (kFormatBits - 1 - i), 8, dark);
  }
}

}  // namespace

Symbol withMask(const Symbol& symbol, int mask) {
  assert(mask >= 0 && mask < kMasks);
  Symbol masked = symbol;
  masked.mask = mask;
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column)
      if (symbol.role(row, column) == ModuleRole::Data &&
          invertsModule(symbol.mask, row, column) != invertsModule(mask, row, column))
        setDark(masked, row, column, !symbol.isDark(row, column));
  writeFormatInformation(masked, formatInformation(symbol.errorCorrection, mask));
  return masked;
}

Symbol withShadiestMask(const Symbol& symbol) {
  Symbol best;
  double least = 2;
  for (int mask = 0; mask < kMasks; ++mask) {
    Symbol masked = withMask(symbol, mask);
    const double sky = SkyFraction(masked).mean(masked);
    if (sky >= least) continue;
    least = sky;
    best = std::move(masked);
  }
  return best;
}

}  // namespace qrelief
