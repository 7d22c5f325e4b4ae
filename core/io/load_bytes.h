// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace qrelief {

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
