// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/filament_code.h"

namespace qrelief {
namespace {

// A leaf's two low bits are 0, for no division; its filament is in the two high bits. There, 3 says that the next digit
// holds the filament less 3.
constexpr unsigned kInNextDigit = 3;
constexpr std::string_view kDigits = "0123456789ABCDEF";

}  // namespace

std::string filamentCode(unsigned filament) {
  if (filament < kInNextDigit) return {kDigits[filament << 2]};
  return {kDigits[filament - kInNextDigit], 'C'};
}

std::optional<unsigned> filamentOfCode(std::string_view code) {
  if (code == "4") return 1;
  if (code == "8") return 2;
  if (code.size() != 2 || code[1] != 'C') return std::nullopt;
  const std::size_t digit = kDigits.find(code[0]);
  if (digit == std::string_view::npos || digit + 1 == kDigits.size()) return std::nullopt;  // F leads to another digit
  return static_cast<unsigned>(digit) + kInNextDigit;
}

}  // namespace qrelief
