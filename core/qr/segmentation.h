// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace qrelief {

/// Mode in which a run of characters is written into a symbol [ISO/IEC 18004, 7.4]. Kanji mode is never used: its bytes
/// are Shift JIS, so a decoder would not return the original UTF-8.
enum class SegmentMode : std::uint8_t { Numeric, Alphanumeric, Byte };

struct Segment {
  SegmentMode mode = SegmentMode::Byte;
  std::size_t begin = 0;   ///< offset in the text, in bytes
  std::size_t length = 0;  ///< in bytes, at least 1
};

/// Returns the sequence of segments with the fewest bits, by dynamic programming over the mode of each character. It
/// depends on the version because the length fields grow at versions 10 and 27.
///
/// Cost: linear.
/// @param text  any bytes; may be empty
/// @param version  1 … 40
/// @returns segments that cover the text in order, no two neighbours of the same mode
std::vector<Segment> segmentText(std::string_view text, int version);

/// Bits that libqrencode reserves for the ECI before a text: the 12 that it takes, and 12 more for a mode and a length
/// that an ECI does not have.
inline constexpr int kEciBits = 24;

/// Returns the number of bits in the segments, with their headers and without terminator and padding.
int segmentBits(const std::vector<Segment>& segments, int version);

}  // namespace qrelief
