// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/inspected_engine.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "support/gl_test.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

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
  void open() { engine_.inspector(R"({"kind": "open"})"); }
  void show(bool shown) {
    engine_.inspector(shown ? R"({"kind": "show", "shown": true})" : R"({"kind": "show", "shown": false})");
  }
  void press() { engine_.inspector(R"({"kind": "key", "key": "a", "control": false, "shift": false})"); }
  bool takes(const std::string& event) { return engine_.inspector(event) == R"({"ok":true,"takes":true})"; }
  bool takesPointer() { return takes(R"({"kind": "pointer", "x": 1, "y": 1, "buttons": 1, "wheel": 0})"); }
  bool takesPick() { return takes(R"({"kind": "pick", "x": 1, "y": 1})"); }
  Json drawn() { return Json::parse(engine_.draw()); }
  InspectedEngine engine_{"", true, false, &makeFake};
};

TEST_F(InspectedEngineTest, DoesNothingBeforeTheInspectorIsOpened) {
  show(true);
  engine_.inspectorGlyphs(16, {65, 1, 1, 0, 0, 1}, {255});
  EXPECT_FALSE(takesPointer());
  EXPECT_FALSE(takesPick());
  EXPECT_TRUE(drawn()["inspector"].is_null());
  EXPECT_EQ(told.made, 0);
}

TEST_F(InspectedEngineTest, ALateWindowGetsThemeAndSize) {
  engine_.show(R"({"dark": true})");
  engine_.resize(320, 200, 2);
  open();
  open();
  show(true);
  EXPECT_EQ(told.made, 1);
  EXPECT_THAT(told.themes, testing::ElementsAre(true));
  EXPECT_THAT(told.sizes, testing::ElementsAre(std::pair(320.0, 200.0)));
}

TEST_F(InspectedEngineTest, DrawsAndHandlesInputOnlyWhileTheWindowIsShown) {
  open();
  press();
  EXPECT_FALSE(takesPointer());
  engine_.draw();
  EXPECT_EQ(std::pair(told.keys, told.draws), std::pair(0, 0));
  show(true);
  press();
  EXPECT_TRUE(takesPointer());
  EXPECT_TRUE(takesPick());
  const Json frame = drawn();
  EXPECT_EQ(frame["more"], true);
  EXPECT_EQ(frame["view"], Json::parse(engine_.engine().viewState()));
  EXPECT_EQ(frame["inspector"], Json({{"tab", 0}}));
  show(false);
  press();
  EXPECT_FALSE(takesPointer());
  EXPECT_TRUE(drawn()["inspector"].is_null());
  EXPECT_EQ(std::pair(told.keys, told.draws), std::pair(1, 1));
}

TEST_F(InspectedEngineTest, ReadsGlyphsOfSixNumbersAndIgnoresARest) {
  open();
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
