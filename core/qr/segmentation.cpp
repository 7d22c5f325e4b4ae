// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/segmentation.h"

#include <algorithm>
#include <array>
#include <limits>

namespace qrelief {
namespace {

constexpr std::size_t kModes = 3;
constexpr int kModeIndicatorBits = 4;

// Costs are counted in sixths of a bit: a digit takes 10/3 bits, an alphanumeric character 11/2.
constexpr int kSixths = 6;
constexpr std::array<int, kModes> kSixthsPerCharacter = {20, 33, 48};
constexpr int kImpossible = std::numeric_limits<int>::max() / 2;

int lengthFieldBits(SegmentMode mode, int version) {
  constexpr std::array<std::array<int, 3>, kModes> kBits = {{{10, 12, 14}, {9, 11, 13}, {8, 16, 16}}};
  const std::size_t versionGroup = version < 10 ? 0 : version < 27 ? 1 : 2;
  return kBits[static_cast<std::size_t>(mode)][versionGroup];
}

int headerSixths(std::size_t mode, int version) {
  return kSixths * (kModeIndicatorBits + lengthFieldBits(static_cast<SegmentMode>(mode), version));
}

bool isWritable(char character, std::size_t mode) {
  const bool digit = character >= '0' && character <= '9';
  switch (static_cast<SegmentMode>(mode)) {
    case SegmentMode::Numeric:
      return digit;
    case SegmentMode::Alphanumeric:
      return digit || (character >= 'A' && character <= 'Z') ||
             std::string_view(" $%*+-./:").find(character) != std::string_view::npos;
    case SegmentMode::Byte:
      return true;
  }
  return false;
}

int roundedUpToBits(int sixths) { return (sixths + kSixths - 1) / kSixths * kSixths; }

using ModeCosts = std::array<int, kModes>;  ///< cost of the text so far, if its last character is written in each mode

/// For each character and each of its modes: the mode of the previous character on the cheapest way.
struct CheapestWays {
  std::vector<std::array<int, kModes>> modeBefore;
  int lastMode = 0;
};

/// Finds the cheapest ways. A cheaper way to a mode stays cheaper, because the same characters follow and rounding up
/// is monotonic.
CheapestWays findCheapestWays(std::string_view text, int version) {
  CheapestWays ways;
  ways.modeBefore.resize(text.size());
  ModeCosts cost = {0, 0, 0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    ModeCosts next = {kImpossible, kImpossible, kImpossible};
    for (std::size_t mode = 0; mode < kModes; ++mode) {
      if (!isWritable(text[i], mode)) continue;
      for (std::size_t before = 0; before < kModes; ++before) {
        if (cost[before] >= kImpossible) continue;
        const bool continues = before == mode && i > 0;
        const int start = continues ? cost[before] : roundedUpToBits(cost[before]) + headerSixths(mode, version);
        if (start + kSixthsPerCharacter[mode] >= next[mode]) continue;
        next[mode] = start + kSixthsPerCharacter[mode];
        ways.modeBefore[i][mode] = static_cast<int>(before);
      }
    }
    cost = next;
  }
  const auto cheaper = [](int a, int b) { return roundedUpToBits(a) < roundedUpToBits(b); };
  ways.lastMode = static_cast<int>(std::min_element(cost.begin(), cost.end(), cheaper) - cost.begin());
  return ways;
}

}  // namespace

std::vector<Segment> segmentText(std::string_view text, int version) {
  const CheapestWays ways = findCheapestWays(text, version);
  int mode = ways.lastMode;
  std::vector<SegmentMode> modes(text.size());
  for (std::size_t i = text.size(); i-- > 0;) {
    modes[i] = static_cast<SegmentMode>(mode);
    mode = ways.modeBefore[i][static_cast<std::size_t>(mode)];
  }
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == 0 || modes[i] != modes[i - 1]) segments.push_back({modes[i], i, 0});
    ++segments.back().length;
  }
  return segments;
}

int segmentBits(const std::vector<Segment>& segments, int version) {
  int sixths = 0;
  for (const Segment& segment : segments) {
    const auto mode = static_cast<std::size_t>(segment.mode);
    const int characters = kSixthsPerCharacter[mode] * static_cast<int>(segment.length);
    sixths += headerSixths(mode, version) + roundedUpToBits(characters);
  }
  return sixths / kSixths;
}

}  // namespace qrelief
