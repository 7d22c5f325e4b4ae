// SPDX-License-Identifier: GPL-3.0-or-later
// Every machine computes the same light: all instruction sets of this machine give the same bits.
#include "support/instruction_sets.h"

#include <cmath>
#include <gtest/gtest.h>
#include <utility>

#include "light/height_light.h"

namespace qrelief {
namespace {

/// Returns uneven ground with pits.
HeightMap ground(bool isContinuous) {
  const int size = 100;
  HeightMap map{size, 0.1, 250, {}, {}, {}, isContinuous};
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const bool isPit = (row / 9 * 7 + column / 9 * 13) % 3 == 0;
      map.height.push_back(static_cast<float>((isPit ? -0.6 : 0) - 0.002 * std::hypot(row - 50, column - 50)));
      map.slopeX.push_back(0.01f);
      map.slopeY.push_back(static_cast<float>(0.02 * std::sin(row)));
    }
  return map;
}

TEST(InstructionSets, GiveTheSameLightBitForBit) {
  for (const bool isContinuous : {false, true}) {
    const HeightLight surface(ground(isContinuous));
    const LightOptions options{.sampling = {2, 10}, .reachMm = 20, .everyPatchMm = 1.2, .lamps = {{30, 40, 1}}};
    expectSameByAllInstructionSets([&] {
      std::vector<Received> light;
      surface.measure(options, {}, light);
      std::vector<float> luminance = surface.luminance(options, light, 0.7);
      return std::pair(std::move(light), std::move(luminance));
    });
  }
}

}  // namespace
}  // namespace qrelief
