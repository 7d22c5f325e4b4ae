// SPDX-License-Identifier: GPL-3.0-or-later
// The GPU and the processor engrave alike.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

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
    EngraveRequest made;
    made.text = "QRELIEF";
    made.symbol.version = 1;
    made.placement.centreMm = centre;
    made.placement.upHint = {0, 1, 0.1};
    return made;
  }
  static Result<EngraveResult> engraveBy(Device device, const Mesh& mesh, const EngraveRequest& request) {
    auto pass = GeometryPass::create();
    if (!pass) return tl::unexpected(pass.error());
    const auto model = EngravableModel::create(*prepareModel(shapes::soupOf(mesh), {}),
                                               std::make_shared<const GeometryPass>(std::move(*pass)), device);
    auto job = EngraveJob::create(model, request, {.device = device});
    if (!job) return tl::unexpected(job.error());
    return runToEnd(**job);
  }
  /// Compares the codes that both devices carve: place, size, depths and decoded text.
  static void expectSameCode(const Mesh& mesh, const EngraveRequest& request) {
    const auto gpu = engraveBy(Device::Gpu, mesh, request), processor = engraveBy(Device::Processor, mesh, request);
    ASSERT_TRUE(gpu.has_value()) << gpu.error().message;
    ASSERT_TRUE(processor.has_value()) << processor.error().message;
    const Placement &a = gpu->placement, &b = processor->placement;
    EXPECT_GT(glm::dot(a.frame.normal, b.frame.normal), std::cos(0.005));
    EXPECT_NEAR(a.symbolMm, b.symbolMm, 0.005 * a.symbolMm);
    ASSERT_EQ(gpu->depths.depthMm.size(), processor->depths.depthMm.size());
    std::size_t carved = 0, differing = 0;
    for (std::size_t i = 0; i < gpu->depths.depthMm.size(); ++i) {
      const double ofGpu = gpu->depths.depthMm[i], ofProcessor = processor->depths.depthMm[i];
      EXPECT_EQ(ofGpu > 0, ofProcessor > 0) << i;
      if (ofGpu > 0) ++carved;
      if (std::abs(ofGpu - ofProcessor) > request.printer.layerMm / 2) ++differing;
    }
    EXPECT_GT(carved, 1000u);
    EXPECT_LE(static_cast<double>(differing), 0.01 * static_cast<double>(carved));
    EXPECT_NEAR(summarise(gpu->depths).meanMm, summarise(processor->depths).meanMm,
                0.02 * summarise(gpu->depths).meanMm);
    EXPECT_EQ(readWithZxing(processor->readerView), "QRELIEF");
  }
};

TEST_F(DevicesTest, CarveTheSameCodeOnAPlate) { expectSameCode(shapes::box({40, 40, 10}), request({0, 0, 5})); }

TEST_F(DevicesTest, CarveTheSameCodeOnABumpySphere) {
  expectSameCode(shapes::bumpySphere(40, 1.5, 5, 5), request({0, 0, 40}));
}

TEST_F(DevicesTest, CarveTheSameCodeOnASaddleInTheOptimalDirection) {
  EngraveRequest wanted = request({4, 2, 0});
  wanted.placement.directionMethod = DirectionMethod::Optimal;
  expectSameCode(shapes::plate({60, 60}, 20, 60, 60, [](double x, double y) { return 0.004 * (x * x - y * y); }),
                 wanted);
}

TEST(WithoutGl, AModelHasNoGpuAndIsEngravedWhereASpotWasFound) {
  const auto model = EngravableModel::create(*prepareModel(shapes::soupOf(shapes::bumpySphere(30, 1.5, 5, 5)), {}),
                                             nullptr, Device::Gpu);
  EXPECT_EQ(model->gpu, nullptr);
  EXPECT_FALSE(model->usesShaders(Device::Gpu));

  EngraveRequest request;
  request.text = "QRELIEF";
  request.symbol.version = 1;
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
