// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/pass_rays.h"

#include <cmath>
#include <gtest/gtest.h>

#include "study/carved_code.h"
#include "study/study_spots.h"

namespace qrelief::study {
namespace {

constexpr std::size_t kRays = 64;

class PassRaysTest : public PlateTest {
 protected:
  PassRaysTest() : spot_(plateSpot(2)) {
    const SubmoduleMask mask = submodulesToCarve(spot_.symbol, ModulePattern::None, FinderPattern::None);
    dark_ = carvedOf(mask);
    depths_ = {mask.rows(), spot_.placement.symbolMm, std::vector<double>(mask.size(), 0)};
  }

  /// Deepens every `stride`-th dark submodule.
  void deepen(std::size_t stride, double byMm) {
    for (std::size_t k = 0; k < dark_.size(); k += stride) depths_.depthMm[dark_[k]] += byMm;
  }

  /// Measures all rays. @returns the open sky by submodule, and how many rays were cast
  std::pair<std::vector<double>, std::size_t> measure(PassRays& rays) const {
    const auto surface = CarvedSurface::make(spot_, depths_);
    EXPECT_TRUE(surface.has_value());
    rays.begin(spot_.placement.frame, depths_);
    std::vector<double> open;
    std::size_t casts = 0;
    for (std::size_t k = 0; k < dark_.size(); ++k) {
      const auto at = surface->middleOf(dark_[k]);
      EXPECT_TRUE(at.has_value());
      const Hemisphere hemisphere(surface->normalAt(*at), k);
      double sum = 0;
      for (std::size_t i = 0; i < kRays; ++i)
        sum += rays.value(k, i, [&]() -> PassRays::Cast {
          ++casts;
          const auto hit = surface->hitFrom(*at, hemisphere.direction(i));
          if (!hit) return {1, std::nullopt};
          return {0, hit->position};
        });
      open.push_back(sum / kRays);
    }
    return {open, casts};
  }

  StudyPlacement spot_;
  std::vector<std::uint32_t> dark_;
  DepthField depths_;
};

TEST_F(PassRaysTest, KeepsOnlyWhatCastingAgainFinds) {
  PassRays kept(dark_, kRays);
  deepen(1, 0.6);
  EXPECT_EQ(measure(kept).second, dark_.size() * kRays);
  deepen(40, 0.6);
  const auto [open, casts] = measure(kept);
  EXPECT_LT(casts, dark_.size() * kRays / 4);
  PassRays fresh(dark_, kRays);
  const std::vector<double> expected = measure(fresh).first;
  double difference = 0;
  for (std::size_t k = 0; k < open.size(); ++k) difference += std::abs(open[k] - expected[k]);
  EXPECT_LE(difference / static_cast<double>(open.size()), 0.001);  // rounding decides for rays along edges
}

TEST_F(PassRaysTest, CastsAgainWhereABlockerMoved) {
  PassRays rays(dark_, kRays);
  deepen(2, 0.6);
  const std::vector<double> between = measure(rays).first;  // uncarved submodules shade those between them
  for (std::size_t k = 1; k < dark_.size(); k += 2) depths_.depthMm[dark_[k]] = 0.6;
  const std::vector<double> even = measure(rays).first;
  std::size_t brighter = 0, darker = 0;
  for (std::size_t k = 0; k < dark_.size(); k += 2) {
    brighter += even[k] > between[k];
    darker += even[k] < between[k];
  }
  EXPECT_GT(brighter, dark_.size() / 4);
  EXPECT_EQ(darker, 0u);
}

TEST(MeasureUntilClear, StopsOnlyAboveTheMargin) {
  std::vector<std::size_t> counts;
  const auto of = [&](double value) {
    return [&counts, value](std::size_t count) {
      counts.push_back(count);
      return value;
    };
  };
  measureUntilClear(64, 0.5, 0.2, of(0.71));
  EXPECT_EQ(counts, (std::vector<std::size_t>{8}));
  counts.clear();
  measureUntilClear(64, 0.5, 0.2, of(0.56));
  EXPECT_EQ(counts, (std::vector<std::size_t>{8, 16, 32}));
  counts.clear();
  measureUntilClear(64, 0.5, 0.2, of(0.4));
  EXPECT_EQ(counts, (std::vector<std::size_t>{8, 16, 32, 64}));
}

}  // namespace
}  // namespace qrelief::study
