// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/literal_2022.h"

#include <cmath>

#include "study/methods/by_engine.h"
#include "study/study_spots.h"

namespace qrelief::study {
namespace {

using Literal2022 = PlateTest;

EngraveRequest requestAt(const StudyPlacement& spot, ModulePattern modules, FinderPattern finders) {
  EngraveRequest request = publishedRequest(spot, modules, finders);
  request.depth.contrast = 0.2;
  return request;
}

double meanMm(const Result<CarvedCode>& code) {
  EXPECT_TRUE(code.has_value());
  return summarise(code->depths).meanMm;
}

/// A dark neighbour lowers the wanted luminance, so a plate's code gets deeper.
TEST_F(Literal2022, AllEightNeighboursMakeACodeOnAPlateDeeper) {
  const StudyPlacement spot = plateSpot(2);
  const EngraveRequest request = requestAt(spot, ModulePattern::Square, FinderPattern::ThickPlus);
  LiteralOptions options{.surroundings = Surroundings::LightModules, .significantChange = 0.005, .roundSteps = true};
  const double ofLight = meanMm(carveLiteral2022(spot, request, options));
  EXPECT_NEAR(ofLight, meanMm(carveByEngine(spot, request)), 0.02);  // the program's search, with these options
  options.surroundings = Surroundings::EightNeighbours;
  EXPECT_GT(meanMm(carveLiteral2022(spot, request, options)), 1.1 * ofLight);
}

/// The search by horizon-based ambient occlusion ends by darkness if light modules are the surroundings.
TEST_F(Literal2022, UnderItsOcclusionLightModulesEndWhereNoSubmoduleIsTooBright) {
  const StudyPlacement spot = plateSpot(2);
  const auto code = carveLiteral2022(spot, requestAt(spot, ModulePattern::Square, FinderPattern::ThickPlus),
                                     {.surroundings = Surroundings::LightModules, .hbao = HbaoOptions()});
  ASSERT_TRUE(code.has_value());
  EXPECT_EQ(code->limited, 0u);
  EXPECT_EQ(code->ownEstimate.size(), carvedOf(code->mask).size());
  for (const double luminance : code->ownEstimate) EXPECT_LE(luminance, 0.8 + 1e-6);
}

/// Luminance of a cell in the middle of a square pit, by a light of many directions and steps without jitter.
class HbaoPit : public GlTest {
 protected:
  static constexpr int kSize = 41, kHalf = 5;  // of map and pit, in cells of 1 mm

  static double middleOf(const HbaoOptions& options, float depthMm) {
    const auto count = static_cast<std::size_t>(kSize * kSize);
    HeightMap map{
        kSize, 1, 1e5, std::vector<float>(count, 0), std::vector<float>(count, 0), std::vector<float>(count, 0)};
    HbaoLight light(std::move(map), {kSize / 5, 5, 0.7f, {}}, options);
    std::vector<float> depths(count, 0);
    constexpr int kMiddle = kSize / 2;
    for (int row = kMiddle - kHalf; row <= kMiddle + kHalf; ++row)
      for (int column = kMiddle - kHalf; column <= kMiddle + kHalf; ++column)
        depths[static_cast<std::size_t>(row * kSize + column)] = depthMm;
    const std::uint32_t middle = kMiddle * kSize + kMiddle;
    return static_cast<double>(light.luminance(std::span(&middle, 1), depths, 1)[middle]);
  }
};

/// The shader computes the same light as the CPU, with its defaults and without noise and fading, on sloping ground
/// with pockets of many depths.
TEST_F(HbaoPit, IsTheSameByShader) {
  const HbaoOptions plain{.radiusModules = 1.6,
                          .angleBiasDeg = 10,
                          .directions = 6,
                          .steps = 5,
                          .isAttenuated = false,
                          .isJittered = false,
                          .pixelsPerSubmodule = 2};
  for (const HbaoOptions& options : {HbaoOptions(), plain}) {
    const auto count = static_cast<std::size_t>(kSize * kSize);
    HeightMap map{kSize, 0.37, 250, {}, std::vector<float>(count, 0.2f), std::vector<float>(count, -0.1f)};
    std::vector<float> depths;
    std::vector<std::uint32_t> cells;
    for (std::uint32_t i = 0; i < count; ++i) {
      map.height.push_back(0.37f * (0.2f * static_cast<float>(i % kSize) - 0.1f * static_cast<float>(i / kSize)));
      depths.push_back(i % 7 < 4 ? 0.1f * static_cast<float>(i % 11) : 0.0f);
      cells.push_back(i);
    }
    HbaoLight light(std::move(map), {kSize / 5, 1.85, 0.7f, {}}, options);
    const std::vector<float> own = light.luminance(cells, depths, 1);
    ASSERT_TRUE(light.useShader().has_value());
    const std::vector<float> byShader = light.luminance(cells, depths, 1);
    double difference = 0, darkest = 1;
    for (std::size_t i = 0; i < count; ++i) {
      difference += std::abs(static_cast<double>(own[i] - byShader[i])) / static_cast<double>(count);
      darkest = std::min(darkest, static_cast<double>(own[i]));
    }
    EXPECT_LT(darkest, 0.7);
    EXPECT_LT(difference, 1e-3);
  }
}

/// Without bias and fading the light is 1 − mean of sin h, with tan h = depth / distance of the wall.
TEST_F(HbaoPit, MatchesTheClosedFormOfHorizons) {
  HbaoOptions options{.radiusModules = 4,
                      .angleBiasDeg = 0,
                      .directions = 64,
                      .steps = 400,
                      .isAttenuated = false,
                      .isJittered = false,
                      .pixelsPerSubmodule = 1};
  const double depth = 4;
  double hidden = 0;
  for (int k = 0; k < options.directions; ++k) {
    const double angle = 2 * M_PI * (k + 0.5) / options.directions;
    const double wall = (kHalf + 0.5) / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
    hidden += depth / std::hypot(depth, wall) / options.directions;
  }
  EXPECT_NEAR(middleOf(options, static_cast<float>(depth)), 1 - hidden, 0.01);
}

TEST_F(HbaoPit, HorizonsWithinTheBiasAndWallsBeyondTheRadiusHideNothing) {
  const HbaoOptions exact{.radiusModules = 4, .angleBiasDeg = 0, .directions = 16, .steps = 40, .isJittered = false};
  HbaoOptions biased = exact, near = exact;
  biased.angleBiasDeg = 30;  // the nearest wall is 5.5 mm away and 2 mm high: 20°
  near.radiusModules = 1;    // 5 mm
  EXPECT_LT(middleOf(exact, 2), 0.9);
  EXPECT_DOUBLE_EQ(middleOf(biased, 2), 1);
  EXPECT_DOUBLE_EQ(middleOf(near, 2), 1);
}

}  // namespace
}  // namespace qrelief::study
