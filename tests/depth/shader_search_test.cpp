// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/shader_search.h"

#include <cmath>

#include "base/random.h"
#include "depth/fast_search.h"
#include "depth/light_neighbours.h"
#include "depth/pocket_sky.h"
#include "render/geometry_pass.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kContrast = 0.3, kSymbolMm = 25, kLimitMm = 3;
constexpr int kMargin = kSubmodulesPerModule * (kQuietZoneModules + kOcclusionMarginModules);

class ShaderSearchTest : public GlTest {
 protected:
  ShaderSearchTest()
      : symbol_(*encodeSymbol("https://qrelief.example", {})),
        mask_(submodulesToCarve(symbol_, ModulePattern::ThickPlus, FinderPattern::None)) {
    for (std::uint32_t i = 0; i < mask_.size(); ++i)
      if (mask_[i]) {
        carved_.push_back(i);
        const int row = static_cast<int>(i) / mask_.rows(), column = static_cast<int>(i) % mask_.rows();
        cells_.push_back(static_cast<std::uint32_t>((edge() - 1 - row - kMargin) * edge() + column + kMargin));
      }
  }

  int edge() const { return mask_.rows() + 2 * kMargin; }
  int quietEdge() const { return mask_.rows() + 2 * kSubmodulesPerModule * kQuietZoneModules; }
  CarvingTarget target() const { return {&symbol_, &mask_, kSymbolMm, std::vector<double>(mask_.size(), kLimitMm)}; }
  Grid<double> quietOnes() const { return {quietEdge(), quietEdge(), 1}; }
  /// Returns the index of a submodule among those of symbol and quiet zone.
  std::size_t inQuietZone(std::uint32_t i) const {
    constexpr int kQuiet = kSubmodulesPerModule * kQuietZoneModules;
    return static_cast<std::size_t>((static_cast<int>(i) / mask_.rows() + kQuiet) * quietEdge() +
                                    static_cast<int>(i) % mask_.rows() + kQuiet);
  }

  /// Makes the pass that lights a plate.
  void makeLight() {
    const Mesh plate = shapes::box({100, 100, 10});
    auto geometry = GeometryPass::create();
    ASSERT_TRUE(geometry.has_value());
    const GpuMesh mesh(plate, vertexNormals(plate));
    const ProjectionFrame frame = makeFrame({0, 0, 5}, {0, 0, 1}, {0, 1, 0}, 250);
    auto maps =
        geometry->render(mesh, frame, {kSymbolMm / mask_.rows() * edge(), edge() * LuminanceOptions{}.cellTexels});
    ASSERT_TRUE(maps.has_value());
    maps_ = std::move(*maps);
    auto pass = LuminancePass::create(maps_, nullptr, 250, {.radiusMm = 30});
    ASSERT_TRUE(pass.has_value()) << pass.error().message;
    light_ = std::move(*pass);
    light_.run();
  }

  std::unique_ptr<ShaderSearch> search(const FastSearchOptions& options) {
    ShaderSearch::Place place;
    place.light = &light_;
    place.cells = cells_;
    place.luminance = quietOnes();
    auto search = ShaderSearch::create(target(), options, std::move(place));
    EXPECT_TRUE(search.has_value());
    return std::move(*search);
  }

  Symbol symbol_;
  SubmoduleMask mask_;
  std::vector<std::uint32_t> carved_, cells_;
  SurfaceMaps maps_;
  LuminancePass light_;
};

TEST_F(ShaderSearchTest, AnUpdateFromRandomLuminancesIsThatOfTheFastSearch) {
  constexpr int kSweeps = 60;  // so that both solvers reach the solution
  auto programs = LuminancePrograms::create();
  ASSERT_TRUE(programs.has_value()) << programs.error().message;
  auto passes = FloorPasses::create(
      {.cellsAlongEdge = edge(), .cells = cells_, .steps = floorSteps(mask_.rows(), kSymbolMm / mask_.rows())},
      *programs);
  ASSERT_TRUE(passes.has_value()) << passes.error().message;
  passes->setTargets(
      std::vector<FloorTarget>(cells_.size(), {1, static_cast<float>(1 - kContrast), static_cast<float>(kLimitMm)}));
  passes->start(static_cast<float>(kFirstDepthModules * kSymbolMm / symbol_.size),
                static_cast<float>(firstDifference(static_cast<double>(FastSearchOptions{}.albedo))));
  FastSearch fast(target(), {.contrast = kContrast, .sweepsPerPass = kSweeps});

  Random random(1);
  Grid<double> told = quietOnes();
  gl::Texture luminance(edge(), edge(), gl::Format::R32F,
                        std::vector<float>(static_cast<std::size_t>(edge() * edge()), 1.0f).data());
  // In three passes depths rise and fall, in the fourth they may only grow. A floor whose depth rounds to the next
  // hundredth has another difference from the plane, so from the second pass on some end farther apart. (Two fast
  // searches whose contrasts differ by 1e-5 differ by more than 0.01 mm at 19, 31 and 50 of the 6,910 floors.)
  for (int pass = 0; pass <= kFreePasses; ++pass) {
    passes->move(luminance, {.sweeps = kSweeps,
                             .aim = static_cast<float>(kAimFraction),
                             .aimForTooBright = static_cast<float>(aimForTooBright(pass, kFreePasses)),
                             .changeFraction = static_cast<float>(pass == 0 ? 0 : kChangeFraction),
                             .maxChange = static_cast<float>(kMaxChange),
                             .leastGrowthMm = static_cast<float>(kDepthQuantumMm),
                             .isFree = pass < kFreePasses});
    passes->record(luminance, 0);
    const std::vector<FloorPasses::Recorded> floors = passes->readRecords(1);
    std::size_t apart = 0;
    double mean = 0, expectedMean = 0;
    for (std::size_t k = 0; k < carved_.size(); ++k) {
      const double depth = static_cast<double>(floors[k].depthMm), expected = fast.depths().depthMm[carved_[k]];
      if (pass == 0) {
        ASSERT_NEAR(depth, expected, 0.0101) << k;
      }
      apart += std::abs(depth - expected) > 0.0101;
      mean += depth / static_cast<double>(carved_.size());
      expectedMean += expected / static_cast<double>(carved_.size());
    }
    EXPECT_LE(apart, carved_.size() / 50) << pass;
    EXPECT_NEAR(mean, expectedMean, 0.001) << pass;

    std::vector<float> cells(static_cast<std::size_t>(edge() * edge()), 1.0f);
    for (std::size_t k = 0; k < carved_.size(); ++k) {
      told[inQuietZone(carved_[k])] = random.uniform(0.55, 0.8);
      cells[cells_[k]] = static_cast<float>(told[inQuietZone(carved_[k])]);
    }
    luminance.upload(cells.data());
    passes->compare(luminance, true, pass == 0);
    fast.update(told);
  }
}

TEST_F(ShaderSearchTest, MakesEverySubmoduleDarkEnoughWithOneReadBack) {
  makeLight();
  const auto gpu = search({.contrast = kContrast});
  const std::vector<SearchRecord::Pass> passes = gpu->advance();
  EXPECT_TRUE(gpu->finished());
  EXPECT_EQ(gpu->readBacks(), 1);
  EXPECT_EQ(passes.size(), static_cast<std::size_t>(gpu->iterations()));
  EXPECT_EQ(gpu->limitedCount(), 0u);
  for (const std::uint32_t i : carved_) EXPECT_LE(gpu->luminance()[inQuietZone(i)], 1 - kContrast + 1e-6);

  // The luminances are those of the final depths, although passes measured only a part of the floors.
  std::vector<float> depths(static_cast<std::size_t>(edge() * edge()), 0.0f);
  for (std::size_t k = 0; k < carved_.size(); ++k) {
    depths[cells_[k]] = static_cast<float>(gpu->depths().depthMm[carved_[k]]);
    EXPECT_EQ(passes.back().depthMm[k], depths[cells_[k]]);
  }
  light_.setDepths(depths);
  light_.run();
  const std::vector<float> again = light_.readLuminance();
  for (std::size_t k = 0; k < carved_.size(); ++k)
    EXPECT_NEAR(gpu->luminance()[inQuietZone(carved_[k])], static_cast<double>(again[cells_[k]]), 1e-5);
}

TEST_F(ShaderSearchTest, FindsTheDepthsOfTheFastSearch) {
  makeLight();
  const auto gpu = search({.contrast = kContrast});
  while (!gpu->finished()) gpu->advance();
  FastSearch fast(target(), {.contrast = kContrast});
  while (!fast.finished()) {
    std::vector<float> depths(static_cast<std::size_t>(edge() * edge()), 0.0f);
    for (std::size_t k = 0; k < carved_.size(); ++k)
      depths[cells_[k]] = static_cast<float>(fast.depths().depthMm[carved_[k]]);
    light_.setDepths(depths);
    light_.run();
    const std::vector<float> seen = light_.readLuminance();
    Grid<double> luminance = quietOnes();
    for (std::size_t k = 0; k < carved_.size(); ++k)
      luminance[inQuietZone(carved_[k])] = static_cast<double>(seen[cells_[k]]);
    fast.update(luminance);
  }
  constexpr double kHalfLayerMm = 0.1;
  std::size_t apart = 0;
  double mean = 0, meanFast = 0;
  for (const std::uint32_t i : carved_) {
    apart += std::abs(gpu->depths().depthMm[i] - fast.depths().depthMm[i]) > kHalfLayerMm;
    mean += gpu->depths().depthMm[i];
    meanFast += fast.depths().depthMm[i];
  }
  EXPECT_LE(apart, carved_.size() / 200);
  EXPECT_NEAR(mean, meanFast, 0.005 * meanFast);
}

TEST_F(ShaderSearchTest, ContinuesWithAHigherTargetForSomeModules) {
  makeLight();
  const auto gpu = search({.contrast = kContrast, .maxIterations = 4});
  gpu->advance();
  EXPECT_TRUE(gpu->finished());
  EXPECT_EQ(gpu->iterations(), 4);
  FastSearchOptions options;
  options.contrastOfModule.assign(symbol_.dark.size(), kContrast);
  for (std::size_t module = 0; module < symbol_.dark.size(); module += 3) options.contrastOfModule[module] = 0.4;
  gpu->restart(options);
  EXPECT_FALSE(gpu->finished());
  while (!gpu->finished()) gpu->advance();
  for (const std::uint32_t i : carved_) {
    const int row = static_cast<int>(i) / mask_.rows(), column = static_cast<int>(i) % mask_.rows();
    const auto module = static_cast<std::size_t>(row / 5 * symbol_.size + column / 5);
    EXPECT_LE(gpu->luminance()[inQuietZone(i)], 1 - options.contrastOfModule[module] + 1e-6);
  }
}

TEST_F(ShaderSearchTest, StopsAtTheLimitsAndCountsSubmodulesThatStayTooBright) {
  makeLight();
  ShaderSearch::Place place;
  place.light = &light_;
  place.cells = cells_;
  place.luminance = quietOnes();
  CarvingTarget shallow = target();
  shallow.limitMm.assign(mask_.size(), 0.123);
  const auto search = ShaderSearch::create(shallow, {.contrast = kContrast}, std::move(place));
  ASSERT_TRUE(search.has_value());
  while (!(*search)->finished()) (*search)->advance();
  std::size_t tooBright = 0;
  for (const std::uint32_t i : carved_) {
    EXPECT_LE((*search)->depths().depthMm[i], 0.123);
    tooBright += (*search)->luminance()[inQuietZone(i)] > 1 - kContrast;
  }
  EXPECT_GT(tooBright, 0u);
  EXPECT_EQ((*search)->limitedCount(), tooBright);
  EXPECT_EQ((*search)->unfinishedCount(), 0u);
}

TEST_F(ShaderSearchTest, CountsSubmodulesThatTheLastPassLeavesTooBright) {
  makeLight();
  ShaderSearch::Place place;
  place.light = &light_;
  place.cells = cells_;
  place.luminance = quietOnes();
  const auto search = ShaderSearch::create(target(), {.contrast = kContrast, .maxIterations = 1}, std::move(place));
  ASSERT_TRUE(search.has_value());
  (*search)->advance();
  ASSERT_TRUE((*search)->finished());
  EXPECT_GT((*search)->unfinishedCount(), 0u);
  EXPECT_EQ((*search)->limitedCount(), (*search)->unfinishedCount());
}

}  // namespace
}  // namespace qrelief
