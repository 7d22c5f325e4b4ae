// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/inspector_model.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/write_stl.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

constexpr double kBoxMm = 20;  // height: the code is on its top

std::size_t tunable(std::string_view name) {
  for (std::size_t i = 0; i < tunables().size(); ++i)
    if (tunables()[i].key == name) return i;
  ADD_FAILURE() << "there is no " << name;
  return 0;
}

/// Fixture with a box whose top is engraved once.
class InspectorModelTest : public GlTest {
 protected:
  static void SetUpTestSuite() {
    GlTest::SetUpTestSuite();
    engine_ = std::make_unique<Engine>();
    engine_->resize(400, 400, 1);
    engine_->loadModel(writeStl(shapes::box({60, 60, kBoxMm})), "box.stl", 1);
    engine_->configure(R"({"text": "https://example.org", "size": 40, "pattern": "square"})");
    engine_->setCentre(Json{{"mm", {0, 0, kBoxMm / 2}}}.dump());
    engine_->timePasses(gl::hasTimerQueries());
    engrave(nullptr);
  }
  static void TearDownTestSuite() { engine_.reset(); }
  static void engrave(const RequestOverrides* overrides) {
    ASSERT_EQ(
        Json::parse(engine_->startJob("engrave", "{}",
                                      overrides ? [=](const EngraveRequest& page) { return overrides->appliedTo(page); }
                                                : std::function<EngraveRequest(EngraveRequest)>()))["ok"],
        true);
    for (bool done = false; !done;) {
      const Json progress = Json::parse(engine_->advanceJob("engrave"));
      ASSERT_EQ(progress["ok"], true) << progress;
      done = progress["done"];
    }
  }
  static float middleOf(const ValueMap& map) { return map.values[*map.indexAt({0.5, 0.5})]; }
  static inline std::unique_ptr<Engine> engine_;
};

TEST_F(InspectorModelTest, IsEmptyBeforeAnEngraving) {
  const Engine fresh;
  InspectorModel model;
  model.follow(fresh);
  EXPECT_EQ(model.search(), nullptr);
  EXPECT_EQ(model.passes(), 0);
  EXPECT_EQ(model.channel(fresh, MapChannel::Depth), nullptr);
  EXPECT_EQ(model.channel(fresh, MapChannel::Height), nullptr);
  model.select(SubmodulePlace{0, 0});
  EXPECT_FALSE(model.selected().has_value());
}

TEST_F(InspectorModelTest, ShowsTheLastPassUntilAnEarlierOneIsChosen) {
  InspectorModel model;
  model.follow(*engine_);
  ASSERT_EQ(model.passes(), engine_->carvings().result()->searchIterations);
  ASSERT_GT(model.passes(), 1);
  EXPECT_EQ(model.pass(), model.passes() - 1);
  model.setPass(0);
  EXPECT_EQ(model.pass(), 0);
  model.setPass(-5);
  EXPECT_EQ(model.pass(), 0);
  model.setPass(1000);
  EXPECT_EQ(model.pass(), model.passes() - 1);
}

TEST_F(InspectorModelTest, ShowsTheChannelOfTheChosenPass) {
  InspectorModel model;
  model.follow(*engine_);
  const ValueMap last = *model.channel(*engine_, MapChannel::Depth);
  const int version = model.channelVersion();
  EXPECT_EQ(model.channel(*engine_, MapChannel::Depth)->values.size(), last.values.size());
  EXPECT_EQ(model.channelVersion(), version);  // nothing changed
  model.setPass(0);
  const ValueMap first = *model.channel(*engine_, MapChannel::Depth);
  EXPECT_GT(model.channelVersion(), version);
  EXPECT_NE(rangeOf(first.values), rangeOf(last.values));
}

TEST_F(InspectorModelTest, TheGBufferOfTheTopOfABoxMatchesTheClosedForm) {
  InspectorModel model;
  model.follow(*engine_);
  const double eye = engine_->carvings().result()->placement.frame.eyeDistance, edge = engine_->carvings().codeEdgeMm();
  EXPECT_NEAR(edge, 40.0 * (engine_->carvings().result()->symbol.size + 8) / engine_->carvings().result()->symbol.size,
              1e-9);
  const ValueMap facing = *model.channel(*engine_, MapChannel::FacetNormal);
  EXPECT_NEAR(middleOf(facing), 0, 0.05);
  EXPECT_NEAR(facing.directions[*facing.indexAt({0.5, 0.5})].z, 1, 1e-5);
  // The corners' normals lean outwards, so the interpolated normal half a texel beside the middle leans slightly, too.
  EXPECT_NEAR(middleOf(*model.channel(*engine_, MapChannel::SmoothNormal)), 0, 0.2);
  EXPECT_NEAR(middleOf(*model.channel(*engine_, MapChannel::Height)), 0, 1e-3);
  EXPECT_NEAR(middleOf(*model.channel(*engine_, MapChannel::BackDistance)), eye + kBoxMm, 0.02);
  EXPECT_NEAR(middleOf(*model.channel(*engine_, MapChannel::Thickness)), kBoxMm, 0.02);
  const ValueMap distance = *model.channel(*engine_, MapChannel::Distance);
  EXPECT_NEAR(middleOf(distance), eye, 0.01);
  // The ray is longer in the corners. The map covers symbol and quiet zone, no more.
  const double half = edge / 2 * (1 - 1.0 / distance.columns);
  EXPECT_NEAR(distance.values.front(), std::sqrt(eye * eye + 2 * half * half), 0.02);
}

TEST_F(InspectorModelTest, TheLightOfTheSearchCoversTheSameSquare) {
  InspectorModel model;
  model.follow(*engine_);
  for (const MapChannel channel : {MapChannel::Sky, MapChannel::PastWalls, MapChannel::Lamps}) {
    const ValueMap map = *model.channel(*engine_, channel);
    EXPECT_EQ(map.columns, model.search()->edge());
    EXPECT_NEAR(map.values.front(), channel == MapChannel::Lamps ? 0 : 1, 0.02) << static_cast<int>(channel);
  }
}

TEST_F(InspectorModelTest, AClickOnTheModelChoosesTheSubmoduleThere) {
  engine_->look(R"({"kind": "readerView"})");
  while (engine_->draw()) {  // lets the camera glide there
  }
  const auto middle = engine_->codePlaceAt(200, 200);
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(middle->x, 0.5, 0.02);
  EXPECT_NEAR(middle->y, 0.5, 0.02);
  const auto upperLeft = engine_->codePlaceAt(100, 120);
  ASSERT_TRUE(upperLeft.has_value());
  EXPECT_LT(upperLeft->x, 0.5);
  EXPECT_LT(upperLeft->y, 0.5);
  // 400 pixels show 1.1 times the width of symbol and quiet zone.
  EXPECT_NEAR(upperLeft->x, 0.5 - 100.0 / 400 * 1.1, 0.02);
  EXPECT_NEAR(upperLeft->y, 0.5 - 80.0 / 400 * 1.1, 0.02);
  EXPECT_FALSE(engine_->codePlaceAt(1, 1).has_value());
}

TEST_F(InspectorModelTest, PassesAreTimed) {
  const gl::PassTimings* timings = engine_->carvings().passTimings();
  ASSERT_NE(timings, nullptr);
  std::map<std::string_view, int> runs;
  for (const gl::PassTime& time : timings->times()) runs[time.name] = time.count;
  // Once for the surroundings, then for each pass of the search.
  EXPECT_EQ(runs["occlusion"], engine_->carvings().result()->searchIterations + 1);
  EXPECT_EQ(runs["back distance"], 1);
}

TEST_F(InspectorModelTest, OverridesApplyToOneEngravingAndItsReport) {
  InspectorModel model;
  model.follow(*engine_);
  ASSERT_TRUE(model.runs()[0].has_value());
  EXPECT_EQ(model.runs()[0]->passes.size(), static_cast<std::size_t>(model.passes()));
  EXPECT_FALSE(model.runs()[1].has_value());

  model.overrides().set(tunable("solver"), 1, engine_->settings());
  model.overrides().set(tunable("contrast"), 0.2, engine_->settings());
  engrave(&model.overrides());
  model.follow(*engine_);
  EXPECT_EQ(engine_->carvings().request().depth.contrast, 0.2);
  EXPECT_EQ(engine_->carvings().request().depth.solver, ContrastSolver::PaperSteps);
  EXPECT_NE(engine_->settings().depth.contrast, 0.2);
  ASSERT_TRUE(model.runs()[0] && model.runs()[1]);
  EXPECT_NE(model.runs()[1]->name.find("paper's steps, c = 0.2"), std::string::npos) << model.runs()[1]->name;
  EXPECT_EQ(model.pass(), model.passes() - 1);
  // The report measures against the requested contrast.
  EXPECT_EQ(model.runs()[1]->passes.back().unmet, 0);
}

}  // namespace
}  // namespace qrelief
