// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/symbol_decal.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "depth/depth_solver.h"
#include "math/frame.h"
#include "pipeline/engravable_model.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

constexpr double kModuleMm = 1.5;

class SymbolDecal : public testing::TestWithParam<Mark> {
 protected:
  SymbolDecal() { request_.marking.mark = GetParam(); }
  Decal decal() const { return symbolDecal(symbol_, frame_, symbol_.size * kModuleMm, request_); }
  /// Returns a texel of the decal. @param at  modules from the symbol's centre, v points up
  int inkAt(const Decal& decal, Vec2 at) const {
    const double texels = decal.size * kModuleMm / decal.edgeMm;  // per module
    const int column = static_cast<int>(std::floor(at.x * texels + decal.size / 2.0));
    const int row = static_cast<int>(std::floor(decal.size / 2.0 - at.y * texels));
    return decal.ink.at(static_cast<std::size_t>(row * decal.size + column));
  }

  Symbol symbol_ = *encodeSymbol("A");
  ProjectionFrame frame_ = makeFrame({}, {0, 0, 1}, {0, 1, 0}, 250);
  EngraveRequest request_;
};

bool isInside(const std::vector<Ring>& rings, Vec2 at) {
  bool inside = false;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  return inside;
}

TEST_P(SymbolDecal, WithoutALabelItEndsAtTheQuietZone) {
  const Decal made = decal();
  EXPECT_DOUBLE_EQ(made.edgeMm, (symbol_.size + 2 * kQuietZoneModules) * kModuleMm);
  EXPECT_EQ(inkAt(made, {-10, 10}), 255);  // in the border of the upper left finder
  EXPECT_EQ(inkAt(made, {-11, 11}), 0);
}

TEST_P(SymbolDecal, FillsTheRoomThatPlacementKeepsForALabel) {
  request_.code.label = {"No 7", LabelFrame::Rounded};
  const double room = roomFactor(symbol_.size, searchedPlacement(request_, symbol_.size));
  const double texelMm = decal().edgeMm / decal().size;
  EXPECT_GE(decal().edgeMm, symbol_.size * kModuleMm * room - 1e-9);
  EXPECT_LE(decal().edgeMm, symbol_.size * kModuleMm * room + 2 * texelMm);
}

TEST_P(SymbolDecal, FrameAndLettersLieWhereTheyAreCarved) {
  request_.code.label = {"No 7", LabelFrame::Rounded};
  const Decal made = decal();
  const auto layout = layOutLabel(request_.code.label, symbol_.size);
  ASSERT_TRUE(layout.has_value());
  const double half = symbol_.size / 2.0, texel = made.edgeMm / made.size / kModuleMm;
  double inked = 0;
  for (int row = 0; row < made.size; ++row)
    for (int column = 0; column < made.size; ++column) {
      const Vec2 at = texel * Vec2(column + 0.5 - made.size / 2.0, made.size / 2.0 - row - 0.5);
      if (std::max(std::abs(at.x), std::abs(at.y)) < half) continue;
      const int ink = made.ink[static_cast<std::size_t>(row * made.size + column)];
      const bool isCarved = isInside(layout->rings, at);
      inked += ink / 255.0;
      if (ink == 0 || ink == 255) {
        EXPECT_EQ(isCarved, ink == 255) << at.x << " " << at.y;
      }
    }
  double area = 0;
  for (const Ring& ring : layout->rings)
    for (std::size_t i = 0; i < ring.size(); ++i) area += cross2(ring[i], ring[(i + 1) % ring.size()]) / 2;
  EXPECT_NEAR(inked * texel * texel, area, 0.01 * area);
}

TEST_P(SymbolDecal, ATextAloneIsItsLetters) {
  request_.code.content = Content::Text;
  request_.code.text = "I";
  symbol_ = blankSymbol();
  const Decal made = decal();
  EXPECT_EQ(inkAt(made, {0, 0}), 255);
  EXPECT_EQ(inkAt(made, {0, symbol_.size / 2.0 - 0.2}), 255);
  EXPECT_EQ(inkAt(made, {symbol_.size / 3.0, 0}), 0);
  EXPECT_EQ(inkAt(made, {0, symbol_.size / 2.0 + 0.2}), 0);
}

TEST_P(SymbolDecal, TheCodeIsTheSameWithAndWithoutALabel) {
  const Decal plain = decal();
  request_.code.label = {"No 7", LabelFrame::Square};
  const Decal labelled = decal();
  const double edge = symbol_.size / 2.0 + kQuietZoneModules;
  for (double y = -edge + 0.1; y < edge; y += 0.2)
    for (double x = -edge + 0.1; x < edge; x += 0.2)
      EXPECT_EQ(inkAt(labelled, {x, y}), inkAt(plain, {x, y})) << x << " " << y;
}

TEST_P(SymbolDecal, ALabelThatCannotBeLaidOutLeavesItsRoomEmpty) {
  request_.code.label = {"\u6f22", LabelFrame::Square};
  const Decal made = decal();
  const double half = symbol_.size / 2.0;
  EXPECT_GT(made.edgeMm, (symbol_.size + 2 * kQuietZoneModules) * kModuleMm);
  EXPECT_EQ(inkAt(made, {0, half + kQuietZoneModules + 1}), 0);  // a frame would be there
}

TEST(SearchedDecal, ShowsTheLightOfEverySubmodule) {
  const Symbol symbol = *encodeSymbol("A");
  const ProjectionFrame frame = makeFrame({}, {0, 0, 1}, {0, 1, 0}, 250);
  const int edge = kSubmodulesPerModule * symbol.size;
  SearchRecord search;
  search.carved = {0, static_cast<std::uint32_t>(3 * edge + 7)};
  search.passes = {{{0, 0}, {1, 1}}, {{0.5f, 0.5f}, {0.25f, 1.5f}}};  // the last pass counts
  EngraveRequest request;
  for (const int scale : {1, 2}) {
    if (scale == 2) request.code.label = {"No 7", LabelFrame::Square};
    const Decal plain = symbolDecal(symbol, frame, symbol.size * kModuleMm, request);
    Decal shown = plain;
    showSearch(shown, symbol, symbol.size * kModuleMm, search);
    ASSERT_EQ(shown.inkUnderLamps.size(), plain.ink.size());
    const int border = (shown.size - scale * edge) / 2;
    for (int row = 0; row < shown.size; ++row)
      for (int column = 0; column < shown.size; ++column) {
        const auto texel = static_cast<std::size_t>(row * shown.size + column);
        const Vec2 at = Vec2(column - border, row - border) / static_cast<double>(scale);
        const auto isIn = [&](Vec2 corner) {
          return at.x >= corner.x && at.x < corner.x + 1 && at.y >= corner.y && at.y < corner.y + 1;
        };
        if (isIn({0, 0})) {
          EXPECT_EQ(shown.inkUnderLamps[texel], 191) << "as dark as the light says: the view's light adds nothing";
          EXPECT_GT(shown.ink[texel], 191) << "darker, as the view's own light shows pockets";
        } else if (isIn({7, 3})) {
          EXPECT_EQ(shown.inkUnderLamps[texel], 0) << "brighter than the surface";
          EXPECT_EQ(shown.ink[texel], 0);
        } else {
          ASSERT_EQ(shown.ink[texel], plain.ink[texel]) << row << " " << column;
          ASSERT_EQ(shown.inkUnderLamps[texel], plain.ink[texel]) << row << " " << column;
        }
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Marks, SymbolDecal, testing::Values(Mark::Shadow, Mark::Inlay, Mark::Paint),
                         [](const auto& tested) { return std::string(markName(tested.param)); });

}  // namespace
}  // namespace qrelief
