// SPDX-License-Identifier: GPL-3.0-or-later
// The GPU and the processor engrave alike.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "native/zxing_decoder.h"
#include "pipeline/engrave.h"
#include "pipeline/spot_search.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class DevicesTest : public GlTest {
 protected:
  static EngraveRequest request(Vec3 centre) {
    EngraveRequest request;
    request.code.text = "QRELIEF";
    request.code.symbol.version = 1;
    request.placement.centreMm = centre;
    request.placement.upHint = {0, 1, 0.1};
    return request;
  }
  static EngraveResult engraveBy(Device maps, Device light, const Mesh& mesh, const EngraveRequest& request) {
    auto pass = GeometryPass::create();
    EXPECT_TRUE(pass.has_value());
    const auto model = EngravableModel::create(*prepareModel(shapes::soupOf(mesh), {}),
                                               std::make_shared<const GeometryPass>(std::move(*pass)), maps);
    auto job = CarveJob::create(model, request, {.device = light});
    EXPECT_TRUE(job.has_value()) << job.error().message;
    auto result = runToEnd(**job);
    EXPECT_TRUE(result.has_value()) << result.error().message;
    return result ? std::move(*result) : EngraveResult{};
  }
  /// Compares place and size, and counts the submodules that differ by more than half a layer.
  /// @param mostDiffering  of the carved submodules, 0 … 1
  static void expectSameCode(const EngraveResult& one, const EngraveResult& other, double mostDiffering) {
    EXPECT_GT(glm::dot(one.placement.frame.normal, other.placement.frame.normal), std::cos(0.005));
    EXPECT_NEAR(one.placement.symbolMm, other.placement.symbolMm, 0.005 * one.placement.symbolMm);
    ASSERT_EQ(one.depths.depthMm.size(), other.depths.depthMm.size());
    std::size_t carved = 0, differing = 0;
    for (std::size_t i = 0; i < one.depths.depthMm.size(); ++i) {
      const double a = one.depths.depthMm[i], b = other.depths.depthMm[i];
      EXPECT_EQ(a > 0, b > 0) << i;
      if (a > 0) ++carved;
      if (std::abs(a - b) > one.request.print.printer.layerMm / 2) ++differing;
    }
    EXPECT_GT(carved, 1000u);
    EXPECT_LE(static_cast<double>(differing) / static_cast<double>(carved), mostDiffering);
    const double meanMm = summarise(one.depths).meanMm;
    EXPECT_NEAR(summarise(other.depths).meanMm, meanMm, 0.02 * meanMm);
  }
  static void expectSameCode(const Mesh& mesh, const EngraveRequest& request) {
    const EngraveResult byGpu = engraveBy(Device::Gpu, Device::Gpu, mesh, request);
    const EngraveResult byProcessor = engraveBy(Device::Processor, Device::Processor, mesh, request);
    const EngraveResult mapsByGpu = engraveBy(Device::Gpu, Device::Processor, mesh, request);
    {
      SCOPED_TRACE("maps by the GPU, light by the processor");
      expectSameCode(mapsByGpu, byProcessor, 0.01);
    }
    SCOPED_TRACE("all by the GPU");  // its light has other sample points
    expectSameCode(byGpu, byProcessor, 0.05);
    EXPECT_EQ(readWithZxing(byProcessor.readerView), "QRELIEF");
  }
};

TEST_F(DevicesTest, CarveTheSameCodeOnAPlate) { expectSameCode(shapes::box({40, 40, 10}), request({0, 0, 5})); }

TEST_F(DevicesTest, CarveTheSameCodeOnABumpySphere) {
  expectSameCode(shapes::bumpySphere(40, 1.5, 5, 5), request({0, 0, 40}));
}

TEST_F(DevicesTest, CarveTheSameCodeOnASaddleInTheOptimalDirection) {
  EngraveRequest engraving = request({4, 2, 0});
  engraving.placement.directionMethod = DirectionMethod::Optimal;
  expectSameCode(shapes::plate({60, 60}, 20, 60, 60, [](double x, double y) { return 0.004 * (x * x - y * y); }),
                 engraving);
}

TEST_F(DevicesTest, CarveTheSameCodeUnderLamps) {
  const Mesh plate = shapes::box({40, 40, 20}), sphere = shapes::bumpySphere(40, 1.5, 5, 5);
  const std::vector<DirectionalLight> two = {{.azimuthDeg = 0, .elevationDeg = 33, .strength = 1},
                                             {.azimuthDeg = 120, .elevationDeg = 33, .strength = 1}};
  const std::vector<DirectionalLight> low = {{.azimuthDeg = 30, .elevationDeg = 20, .strength = 4}};
  for (const auto& lights : {two, low}) {
    EngraveRequest engraving = request({0, 0, 10});
    engraving.depth.lights = lights;
    const EngraveResult byGpu = engraveBy(Device::Gpu, Device::Gpu, plate, engraving);
    const EngraveResult byProcessor = engraveBy(Device::Processor, Device::Processor, plate, engraving);
    expectSameCode(byGpu, byProcessor, 0.05);
    EXPECT_NEAR(summarise(byGpu.depths).maxMm, summarise(byProcessor.depths).maxMm, 0.05);

    engraving.depth.carveFor = CarveFor::Print;
    const EngraveResult printedByGpu = engraveBy(Device::Gpu, Device::Gpu, plate, engraving);
    expectSameCode(printedByGpu, engraveBy(Device::Processor, Device::Processor, plate, engraving), 0.05);
    EXPECT_GT(summarise(printedByGpu.depths).meanMm, summarise(byGpu.depths).meanMm);
    engraving.depth.carveFor = CarveFor::Design;

    engraving.depth.solver = ContrastSolver::PaperSteps;
    const EngraveResult inSteps = engraveBy(Device::Processor, Device::Processor, plate, engraving);
    EXPECT_LE(summarise(byProcessor.depths).meanMm, summarise(inSteps.depths).meanMm);
    EXPECT_LE(summarise(byProcessor.depths).maxMm, 1.1 * summarise(inSteps.depths).maxMm);
  }
  EngraveRequest curved = request({0, 0, 40});
  curved.depth.lights = {{.azimuthDeg = 45, .elevationDeg = 45, .strength = 1}};
  const EngraveResult byGpu = engraveBy(Device::Gpu, Device::Gpu, sphere, curved);
  const EngraveResult byProcessor = engraveBy(Device::Processor, Device::Processor, sphere, curved);
  expectSameCode(byGpu, byProcessor, 0.1);
  const double deepestMm = summarise(byProcessor.depths).maxMm;
  EXPECT_NEAR(summarise(byGpu.depths).maxMm, deepestMm, 0.05 * deepestMm);
}

TEST_F(DevicesTest, SeeTheShadowOfANarrowTowerBesideTheCode) {
  // A tower of 2 by 3 mm and 12 mm high stands at (20.5, 0). The lamp's rays that meet it pass x = 0 at y = −2.9.
  const auto isInTower = [](double x, double y) { return x > 19.5 && x < 21.5 && std::abs(y) < 1.5; };
  const Mesh mesh =
      shapes::plate({60, 60}, 20, 60, 60, [&](double x, double y) { return isInTower(x, y) ? 12.0 : 0.0; });
  EngraveRequest engraving = request({0, 0, 0});
  engraving.placement.maxSizeMm = 20;
  engraving.depth.lights = {{.azimuthDeg = 8, .elevationDeg = 25, .strength = 1}};
  for (const Device device : {Device::Gpu, Device::Processor}) {
    const EngraveResult engraved = engraveBy(device, device, mesh, engraving);
    ASSERT_EQ(engraved.received.rows(), 145);
    const auto lampAt = [&](double x, double y) {
      const double cellMm = engraved.depths.submoduleMm();
      const auto lamp = engraved.received.at(static_cast<int>(std::floor(72.5 - y / cellMm)),
                                             static_cast<int>(std::floor(72.5 + x / cellMm)));
      return static_cast<double>(lamp.lampsUncarved);
    };
    EXPECT_EQ(lampAt(0, -2.9), 0);
    EXPECT_NEAR(lampAt(0, 2.9), std::sin(25 * std::numbers::pi / 180), 0.002);
    EXPECT_NEAR(lampAt(-10, 6), std::sin(25 * std::numbers::pi / 180), 0.002);
  }
}

TEST(WithoutGl, AModelHasNoGpuAndIsEngravedWhereASpotWasFound) {
  const auto model = EngravableModel::create(*prepareModel(shapes::soupOf(shapes::bumpySphere(30, 1.5, 5, 5)), {}),
                                             nullptr, Device::Gpu);
  EXPECT_EQ(model->gpu, nullptr);
  EXPECT_FALSE(model->usesShaders(Device::Gpu));

  EngraveRequest request;
  request.code.text = "QRELIEF";
  request.code.symbol.version = 1;
  SpotSearchRequest searched;
  searched.modules = 21;
  searched.count = 1;
  const auto spots = findSpots(model, searched);
  ASSERT_TRUE(spots.has_value()) << spots.error().message;
  request.placement.centreMm = spots->spots.front().centreMm;
  const auto result = engrave(model, request);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  EXPECT_TRUE(result->solidity.solid());
  EXPECT_EQ(readWithZxing(result->readerView), "QRELIEF");
}

}  // namespace
}  // namespace qrelief
