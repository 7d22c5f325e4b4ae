// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study/spot.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief::study {

/// Fixture with a plate of 70 × 70 mm, too thick for walls to limit depths; modules of 1.2 mm.
class PlateTest : public GlTest {
 protected:
  static StudyPlacement plateSpot(int version) {
    auto prepared = prepareModel(shapes::soupOf(shapes::plate({70, 70}, 30, 4, 4)), {});
    EXPECT_TRUE(prepared.has_value());
    EngraveRequest request;
    request.code.text = "https://example.org/p/1";
    request.code.symbol.version = version;
    request.placement.centreMm = {0, 0, 0};
    request.placement.upHint = {0, 1, 0};
    request.placement.sizeMode = SizeMode::Fixed;
    request.placement.sizeMm = 1.2 * (17 + 4 * version);
    auto spot = findSpot("plate", EngravableModel::upload(std::move(*prepared)), request);
    EXPECT_TRUE(spot.has_value());
    return std::move(*spot);
  }

  /// Returns the spot's symbol as data modules only, all light except the middle one.
  static Symbol withOneDarkModule(const StudyPlacement& spot) {
    Symbol symbol = spot.symbol;
    symbol.dark = {symbol.size, symbol.size};
    symbol.roles = {symbol.size, symbol.size};
    symbol.dark[symbol.dark.size() / 2] = 1;
    return symbol;
  }
};

}  // namespace qrelief::study
