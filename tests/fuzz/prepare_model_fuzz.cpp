// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes encode any soup: the first byte sets how the positions are spread and how many there are; then come three
// bytes per position and three per triangle. A few bytes are enough to fold, double, cross and tear surfaces.
#include <cmath>

#include "fuzz/check.h"

namespace qrelief::fuzz {
namespace {

/// Spreads coordinates evenly, or over many orders of magnitude, from where floats coincide up to the largest.
double coordinate(std::uint8_t byte, bool wild) {
  const double fraction = (byte - 128) / 16.0;
  return wild ? std::copysign(std::exp2(std::abs(fraction) * 16 - 64), fraction) : fraction;
}

PolygonSoup soupFrom(std::span<const std::uint8_t> bytes) {
  PolygonSoup soup{.format = "bytes"};
  const bool wild = bytes[0] & 0x80;
  const std::size_t count = 3 + (bytes[0] & 0x1f);
  std::size_t next = 1;
  for (; soup.positions.size() < count && next + 3 <= bytes.size(); next += 3)
    soup.positions.push_back(
        {coordinate(bytes[next], wild), coordinate(bytes[next + 1], wild), coordinate(bytes[next + 2], wild)});
  if (soup.positions.empty()) return soup;
  const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(bytes[i] % soup.positions.size()); };
  for (; next + 3 <= bytes.size(); next += 3)
    soup.triangles.push_back({corner(next), corner(next + 1), corner(next + 2)});
  return soup;
}

}  // namespace
}  // namespace qrelief::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  if (size == 0) return 0;
  fuzz::checkPrepared(prepareModel(fuzz::soupFrom(fuzz::bytesOf(data, size)), {}));
  return 0;
}
