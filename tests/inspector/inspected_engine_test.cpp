// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/inspected_engine.h"

#include <gmock/gmock.h>
#include <optional>
#include <utility>

#include "support/gl_test.h"

namespace qrelief {
namespace {

/// Record of the calls that the latest window received.
struct Told {
  int made = 0;
  std::vector<std::pair<double, double>> sizes;
  std::vector<bool> themes;
  std::optional<DrawnGlyphs> glyphs;
  int keys = 0, pointers = 0, draws = 0;
} told;

class FakeWindow : public InspectorWindow {
 public:
  void resize(double width, double height, double) override { told.sizes.emplace_back(width, height); }
  void setFreeArea(double, double, double, double) override {}
  void setTheme(bool dark) override { told.themes.push_back(dark); }
  void setGlyphs(DrawnGlyphs glyphs) override { told.glyphs = std::move(glyphs); }
  bool pointer(double, double, int, double) override { return ++told.pointers > 0; }
  void key(const std::string&, bool, bool) override { ++told.keys; }
  bool pickSubmodule(const Engine&, double, double) override { return true; }
  bool draw(const Engine&) override { return ++told.draws > 0; }
  std::string state() const override { return R"({"tab": 0})"; }
  const RequestOverrides& overrides() const override { return overrides_; }

 private:
  RequestOverrides overrides_;
};

std::unique_ptr<InspectorWindow> makeFake() {
  ++told.made;
  return std::make_unique<FakeWindow>();
}

class InspectedEngineTest : public GlTest {
 protected:
  void SetUp() override { told = {}; }
  InspectedEngine engine_{"", false, &makeFake};
};

TEST_F(InspectedEngineTest, DoesNothingBeforeTheInspectorIsOpened) {
  engine_.showInspector(true);
  engine_.inspectorGlyphs(16, {65, 1, 1, 0, 0, 1}, {255});
  EXPECT_FALSE(engine_.inspectorPointer(1, 1, 1, 0));
  EXPECT_FALSE(engine_.inspectorPick(1, 1));
  EXPECT_EQ(engine_.inspectorState(), "{}");
  engine_.draw();
  EXPECT_EQ(told.made, 0);
}

TEST_F(InspectedEngineTest, ALateWindowGetsThemeAndSize) {
  engine_.setTheme(true);
  engine_.resize(320, 200, 2);
  engine_.openInspector();
  engine_.openInspector();
  engine_.showInspector(true);
  EXPECT_EQ(told.made, 1);
  EXPECT_THAT(told.themes, testing::ElementsAre(true));
  EXPECT_THAT(told.sizes, testing::ElementsAre(std::pair(320.0, 200.0)));
}

TEST_F(InspectedEngineTest, DrawsAndHandlesInputOnlyWhileTheWindowIsShown) {
  engine_.openInspector();
  engine_.inspectorKey("a", false, false);
  EXPECT_FALSE(engine_.inspectorPointer(1, 1, 1, 0));
  engine_.draw();
  EXPECT_EQ(std::pair(told.keys, told.draws), std::pair(0, 0));
  engine_.showInspector(true);
  engine_.inspectorKey("a", false, false);
  EXPECT_TRUE(engine_.inspectorPointer(1, 1, 1, 0));
  EXPECT_TRUE(engine_.inspectorPick(1, 1));
  EXPECT_TRUE(engine_.draw());
  engine_.showInspector(false);
  engine_.inspectorKey("a", false, false);
  EXPECT_FALSE(engine_.inspectorPointer(1, 1, 1, 0));
  engine_.draw();
  EXPECT_EQ(std::pair(told.keys, told.draws), std::pair(1, 1));
  EXPECT_EQ(engine_.inspectorState(), R"({"tab": 0})");
}

TEST_F(InspectedEngineTest, ReadsGlyphsOfSixNumbersAndIgnoresARest) {
  engine_.openInspector();
  engine_.inspectorGlyphs(18, {65, 7, 9, 0.5f, -1, 7.5f, 66, 8, 9, 0, -1, 8, 67}, {1, 2, 3});
  ASSERT_TRUE(told.glyphs.has_value());
  EXPECT_EQ(told.glyphs->lineHeight, 18);
  ASSERT_EQ(told.glyphs->glyphs.size(), 2U);
  const DrawnGlyphs::Glyph& first = told.glyphs->glyphs[0];
  EXPECT_EQ(first.codePoint, 65U);
  EXPECT_EQ(first.width, 7);
  EXPECT_EQ(first.height, 9);
  EXPECT_EQ(first.left, 0.5f);
  EXPECT_EQ(first.top, -1);
  EXPECT_EQ(first.advance, 7.5f);
  EXPECT_THAT(told.glyphs->alpha, testing::ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace qrelief
