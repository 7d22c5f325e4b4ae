// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/engine.h"
#include "io/read_model.h"
#include "io/write_stl.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

/// Fixture with an engine that has no GL context.
class EngineWithoutGl : public testing::Test {
 protected:
  Json run(const std::string& job) {
    Json answer = Json::parse(engine_.startJob(job));
    while (answer["ok"] == true && !answer.value("done", false)) answer = Json::parse(engine_.advanceJob(job));
    return answer;
  }
  Engine engine_{"", false};
};

TEST_F(EngineWithoutGl, NamesTheProcessorAndNoProblem) {
  const Json capabilities = Json::parse(engine_.capabilities());
  EXPECT_EQ(capabilities["renderer"], "processor");
  EXPECT_TRUE(capabilities["problems"].empty());
}

TEST_F(EngineWithoutGl, EngravesAtTheBestSpotAndDrawsNothing) {
  const Mesh box = shapes::box({40, 40, 10});
  ASSERT_EQ(Json::parse(engine_.loadModel(writeStl(box), "model.stl", 1))["ok"], true);
  ASSERT_EQ(Json::parse(engine_.configure(R"({"text": "QRELIEF", "size": "free"})"))["ok"], true);
  const Json last = run("spots");
  ASSERT_EQ(last["done"], true) << last;
  EXPECT_GE(last["spots"].size(), 1u);
  ASSERT_EQ(Json::parse(engine_.setCentre(R"({"spot": 0})"))["hit"], true);
  ASSERT_EQ(Json::parse(engine_.placement())["ok"], true);
  const Json carved = run("engrave");
  ASSERT_EQ(carved["done"], true) << carved;

  const auto file = readModel(engine_.exportModel("stl"), "model.stl");
  ASSERT_TRUE(file.has_value());
  EXPECT_GT(file->triangles.size(), 1000u);
  EXPECT_FALSE(engine_.exportModel("3mf").empty());
  EXPECT_EQ(Json::parse(engine_.report())["gl"]["renderer"], "processor");
  EXPECT_FALSE(engine_.pictures("reading").empty());

  EXPECT_FALSE(engine_.draw());
  EXPECT_EQ(engine_.spotPicture(0, 64, 64).width, 0);
  EXPECT_EQ(Json::parse(engine_.show(R"({"carved": true})"))["ok"], true);
}

}  // namespace
}  // namespace qrelief
