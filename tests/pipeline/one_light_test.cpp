// SPDX-License-Identifier: GPL-3.0-or-later
// Codes carved for one lamp, from the request to the verdict.
#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "depth/one_light_search.h"
#include "mesh/ray_tree.h"
#include "native/read_carving.h"
#include "native/zxing_decoder.h"
#include "pipeline/engrave.h"
#include "pipeline/printed_view.h"
#include "report/report.h"
#include "report/verify_report.h"
#include "study/path_tracer.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

struct Sample {
  std::shared_ptr<const EngravableModel> model;
  EngraveRequest request;
  EngraveResult result;
};

Sample carved(const Mesh& mesh, Vec3 centre, DepthObjective objective, ModulePattern pattern,
              const std::function<void(EngraveRequest&)>& change = {}) {
  Sample sample;
  sample.model = EngravableModel::upload(*prepareModel(shapes::soupOf(mesh), {}));
  EngraveRequest& request = sample.request;
  request.code.text = "QRELIEF";
  request.code.symbol.version = 1;
  request.code.modulePattern = pattern;
  request.depth.objective = objective;
  request.depth.preset = Preset::Shallow;
  request.placement.centreMm = centre;
  request.placement.upHint = {0, 1, 0};
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 25.2;
  if (change) change(request);
  auto result = engrave(sample.model, request);
  EXPECT_TRUE(result.has_value()) << result.error().message;
  sample.result = std::move(*result);
  return sample;
}

class OneLightTest : public GlTest {
 protected:
  static const Sample& onPlate() {
    static const Sample sample =
        carved(shapes::box({50, 50, 10}), {0, 0, 5}, DepthObjective::OneLight, ModulePattern::ThickPlus);
    return sample;
  }
  static ReadingCount tries(const Sample& sample, VerifyRequest request) {
    request.ranges = false;
    auto job = VerifyJob::create(sample.result.mesh, request, zxingDecoders());
    return runToEnd(**job)->reading.frontal;
  }
};

TEST_F(OneLightTest, IsASolidThatDecodesUnderItsLampBetterThanUnderTheSky) {
  const Sample& sample = onPlate();
  EXPECT_TRUE(sample.result.solidity.solid());
  EXPECT_LT(summarise(sample.result.depths).meanMm, 0.12);
  VerifyRequest request = verifyRequestOf(sample.request, sample.result);
  EXPECT_EQ(request.lamps, std::vector{kOneLight});
  const ReadingCount underLamp = tries(sample, request);
  EXPECT_TRUE(underLamp.enough()) << underLamp.reads;
  request.lamps.clear();
  const ReadingCount underSky = tries(sample, request);
  EXPECT_LT(underSky.reads, underLamp.reads);
}

TEST_F(OneLightTest, IsShallowerThanACodeForAnyLight) {
  const Sample any = carved(shapes::box({50, 50, 10}), {0, 0, 5}, DepthObjective::Contrast, ModulePattern::ThickPlus);
  EXPECT_LT(summarise(onPlate().result.depths).meanMm, 0.5 * summarise(any.result.depths).meanMm);
}

TEST_F(OneLightTest, TracedLightConfirmsThatCarvedSubmodulesAreDarkUnderTheLamp) {
  for (const bool isBall : {false, true}) {
    const Sample ball =
        isBall ? carved(shapes::icosphere(40, 5), {0, 0, 40}, DepthObjective::OneLight, ModulePattern::ThickPlus,
                        [](EngraveRequest& request) {
                          request.depth.lights = {kOneLight};
                          request.depth.lights.front().elevationDeg = 45;
                        })
               : Sample{};
    const Sample& sample = isBall ? ball : onPlate();
    const EngraveResult& result = sample.result;
    const DepthField& depths = result.depths;
    std::vector<study::SeenCell> dark, light;
    for (int row = 0; row < result.symbol.size; ++row)
      for (int column = 0; column < result.symbol.size; ++column) {
        const Vec2 topLeft = depths.corner(5 * row, 5 * column),
                   bottomRight = depths.corner(5 * row + 5, 5 * column + 5);
        const study::SeenCell module{{topLeft.x, bottomRight.y}, {bottomRight.x, topLeft.y}};
        const Vec2 in = 0.2 * (module.max - module.min);  // the middle nine submodules; they are carved
        if (result.symbol.isDark(row, column))
          dark.push_back({module.min + in, module.max - in});
        else
          light.push_back(module);
      }
    const auto meanOf = [&](const std::vector<study::SeenCell>& cells) {
      double sum = 0;
      for (const study::CellLight& cell : study::traceCells(RayTree(result.mesh), result.placement.frame, cells,
                                                            {.paths = 64, .lights = sample.request.lamps()}))
        sum += cell.luminance.mean / static_cast<double>(cells.size());
      return sum;
    };
    EXPECT_LT(meanOf(dark), (1 - sample.request.depth.contrastAsked() + 0.05) * meanOf(light)) << isBall;
    EXPECT_TRUE(result.solidity.solid());
    EXPECT_LT(static_cast<double>(result.limitedSubmodules), 0.02 * static_cast<double>(depths.depthMm.size()));
  }
}

TEST_F(OneLightTest, TheReportNamesTheLampAndVerifyUsesIt) {
  const Sample& sample = onPlate();
  const ReadingEvidence evidence = readCarving(sample.request, sample.result);
  ReportContext context;
  context.verdict = judge(sample.request, sample.result, evidence);
  EXPECT_TRUE(context.verdict.passed());
  ASSERT_EQ(context.verdict.reads.warnings.size(), 1u);
  EXPECT_EQ(context.verdict.reads.warnings.front().code, "needs-one-light");
  const std::string report = makeReport(sample.request, *sample.model, sample.result, context);
  const auto json = nlohmann::json::parse(report);
  EXPECT_EQ(json["depth"]["objective"], "one-light");
  EXPECT_EQ(json["depth"]["solver"], "one-light");
  EXPECT_EQ(json["depth"]["carvedFor"], "design");
  EXPECT_EQ(json["depth"]["lights"][0]["elevationDeg"], kOneLight.elevationDeg);
  EXPECT_EQ(json["verification"]["verdict"]["reads"]["warnings"][0]["code"], "needs-one-light");
  const auto request = requestFromReport(report);
  ASSERT_TRUE(request.has_value());
  EXPECT_EQ(request->lamps, std::vector{kOneLight});
  EXPECT_TRUE(request->needsLamp);

  auto job = VerifyJob::create(sample.result.mesh, *request, zxingDecoders());
  const VerifyResult verified = *runToEnd(**job);
  VerifyReportContext verifyContext;
  verifyContext.verdict = judge(*request, verified);
  EXPECT_TRUE(verifyContext.verdict.passed());
  EXPECT_EQ(verifyContext.verdict.reads.warnings, context.verdict.reads.warnings);
  EXPECT_EQ(verified.reading.tiltDeg, std::nullopt);
  const auto said = nlohmann::json::parse(makeVerifyReport(*request, verified, verifyContext));
  EXPECT_EQ(said["lights"], json["depth"]["lights"]);
  ASSERT_TRUE(verified.grades.has_value());
  EXPECT_GT(verified.grades->cellContrast.value, 0.1);  // share of the light under the lamp
}

TEST_F(OneLightTest, ThePrintIsViewedUnderTheLampToo) {
  const Sample& sample = onPlate();
  VerifyRequest request = verifyRequestOf(sample.request, sample.result);
  const auto contrast = [&] {
    PrintedViewRequest wanted = **printedViewOf(request);
    wanted.isRough = true;
    auto job = PrintedViewJob::create(sample.result.mesh, wanted);
    const PrintedView view = *runToEnd(**job);
    const ModuleReflectances measured = measureModules(sample.result.symbol, view.submodules);
    return gradeSymbol(measured, 0.7).cellContrast.value;
  };
  const double underLamp = contrast();
  request.lamps.clear();
  EXPECT_GT(underLamp, 1.5 * contrast());
}

TEST_F(OneLightTest, VerifyRefusesAnInvalidLamp) {
  VerifyRequest request = verifyRequestOf(onPlate().request, onPlate().result);
  request.lamps.front().elevationDeg = -3;
  const auto job = VerifyJob::create(onPlate().result.mesh, request, zxingDecoders());
  ASSERT_FALSE(job.has_value());
  EXPECT_EQ(job.error().message.code, "setting-out-of-range");
}

}  // namespace
}  // namespace qrelief
