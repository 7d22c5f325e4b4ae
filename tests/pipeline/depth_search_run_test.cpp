// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/depth_search_run.h"

#include <cmath>

#include "depth/fast_search.h"
#include "pipeline/engrave.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// Shaders light the place, also on a software renderer.
class DepthSearchRunTest : public GlTest {
 protected:
  DepthSearchRunTest() {
    auto prepared = prepareModel(shapes::soupOf(shapes::bumpySphere(40, 1.5, 5, 5)), {});
    model_ = EngravableModel::upload(std::move(*prepared));
    request_.code.text = "https://qrelief.example";
    request_.placement.centreMm = Vec3(0, 0, 40);
    request_.placement.sizeMode = SizeMode::Fixed;
    request_.placement.sizeMm = 25;
    request_.depth.contrast = 0.3;
  }

  EngraveResult carve(const MakeSearch& makeSearch = nullptr) const {
    auto job = CarveJob::create(model_, request_, {.device = Device::Gpu, .makeSearch = makeSearch});
    EXPECT_TRUE(job.has_value());
    auto result = runToEnd(**job);
    EXPECT_TRUE(result.has_value()) << result.error().message;
    return std::move(*result);
  }

  std::shared_ptr<const EngravableModel> model_;
  EngraveRequest request_;
};

TEST_F(DepthSearchRunTest, TheGpuFindsTheDepthsThatPassesOnTheProcessorFind) {
  const EngraveResult onGpu = carve();
  const EngraveResult byPasses = carve([](CarvingTarget target) {
    return std::make_unique<FastSearch>(std::move(target), FastSearchOptions{.contrast = 0.3});
  });
  const double halfLayerMm = request_.print.printer.layerMm / 2;
  std::size_t carved = 0, apart = 0;
  for (std::size_t i = 0; i < onGpu.depths.depthMm.size(); ++i) {
    carved += onGpu.depths.depthMm[i] > 0;
    apart += std::abs(onGpu.depths.depthMm[i] - byPasses.depths.depthMm[i]) > halfLayerMm;
  }
  EXPECT_LE(apart, carved / 100);
  EXPECT_NEAR(summarise(onGpu.depths).meanMm, summarise(byPasses.depths).meanMm,
              0.01 * summarise(byPasses.depths).meanMm);
  EXPECT_EQ(onGpu.limitedSubmodules, byPasses.limitedSubmodules);
}

TEST_F(DepthSearchRunTest, TheGpuRecordsEveryPass) {
  request_.depth.recordSearch = true;
  const EngraveResult result = carve();
  ASSERT_EQ(result.search.passes.size(), static_cast<std::size_t>(result.searchIterations));
  const SearchRecord::Pass& last = result.search.passes.back();
  for (std::size_t k = 0; k < result.search.carved.size(); ++k)
    ASSERT_EQ(last.depthMm[k], static_cast<float>(result.depths.depthMm[result.search.carved[k]]));
  EXPECT_NE(result.search.passes.front().depthMm, last.depthMm);
}

TEST_F(DepthSearchRunTest, TheGpuCarvesForThePrintToo) {
  const double designed = summarise(carve().depths).meanMm;
  request_.depth.carveFor = CarveFor::Print;
  const EngraveResult result = carve();
  EXPECT_GT(summarise(result.depths).meanMm, designed);
  EXPECT_GT(result.timingsMs.forPrint, 0);
  EXPECT_TRUE(result.solidity.solid());
}

}  // namespace
}  // namespace qrelief
