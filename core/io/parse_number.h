// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace qrelief {

/// Parses a decimal number to the nearest double, independent of the locale: an optional sign, digits with an optional
/// point, an optional exponent. Also accepts "nan", "inf" and "infinity" in any case, so that a parser can report them.
///
/// Cost: about 10 ns (fast_float [Lemire 2021]).
/// @param token  the number and nothing else: no white space, no trailing characters
/// @returns empty if the token is not a number
std::optional<double> parseNumber(std::string_view token);

/// Returns the text without white space round it: attributes of XML that are numbers may have some.
std::string_view withoutBlanks(std::string_view text);

/// Parses a decimal integer with an optional sign; empty if the token is not one or does not fit.
std::optional<std::int64_t> parseInteger(std::string_view token);

/// Loads a number of type T from its bytes. Assumes a little-endian machine (x86, ARM and WebAssembly, the only
/// targets).
template <class T>
T loadBytes(const std::uint8_t* bytes, bool bigEndian = false) {
  std::array<std::uint8_t, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (bigEndian) std::reverse(raw.begin(), raw.end());
  T value;
  std::memcpy(&value, raw.data(), sizeof(T));
  return value;
}

}  // namespace qrelief
