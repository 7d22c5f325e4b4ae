// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/search_view.h"

#include <cmath>
#include <gmock/gmock.h>

#include "depth/paper_step_search.h"
#include "qr/module_pattern.h"

namespace qrelief {
namespace {

constexpr double kContrast = 0.3;
constexpr int kQuiet = 20;  // submodules

/// Fixture with a made-up search whose numbers can be checked by hand. Light modules have a luminance of 0.9. Carved
/// submodules have 0.8, 0.7 and 0.6 in the three passes, except the first submodule: in the last pass it is 0.01 too
/// bright.
class SearchViewTest : public testing::Test {
 protected:
  SearchViewTest()
      : symbol_(*encodeSymbol("https://qrelief.example", {})),
        mask_(submodulesToCarve(symbol_, ModulePattern::Square, FinderPattern::ThickPlus)),
        edge_(mask_.rows() + 2 * kQuiet) {
    record_.luminance = {edge_, edge_, 0.9f};
    for (std::size_t i = 0; i < mask_.size(); ++i) {
      if (!mask_[i]) continue;
      record_.carved.push_back(static_cast<std::uint32_t>(i));
      record_.limitMm.push_back(1.5f);
    }
    for (int pass = 0; pass < 3; ++pass) {
      SearchRecord::Pass made;
      made.ms = 10 + pass;
      made.depthMm.assign(record_.carved.size(), 0.2f * static_cast<float>(pass + 1));
      made.luminance.assign(record_.carved.size(), 0.8f - 0.1f * static_cast<float>(pass));
      record_.passes.push_back(made);
    }
    record_.passes[2].luminance[0] = 0.9f * 0.7f + 0.01f;
    record_.passes[2].depthMm[0] = 1.0f;
  }

  SubmodulePlace firstCarved() const {
    const int i = static_cast<int>(record_.carved[0]);
    return {i / mask_.rows(), i % mask_.rows()};
  }

  Symbol symbol_;
  SubmoduleMask mask_;
  int edge_;
  SearchRecord record_;
};

TEST_F(SearchViewTest, DescribesASubmoduleInThePapersQuantities) {
  const SearchView view(symbol_, record_, kContrast);
  const auto facts = view.facts(2, firstCarved());
  ASSERT_TRUE(facts.has_value());
  EXPECT_TRUE(facts->carved && facts->dark && facts->inSymbol);
  EXPECT_EQ(facts->role, ModuleRole::Finder);  // the upper left corner
  EXPECT_FLOAT_EQ(facts->luminance, 0.64f);
  EXPECT_FLOAT_EQ(*facts->around, 0.9f);
  EXPECT_NEAR(*facts->excess, 0.9 * (kContrast - 1) + 0.64, 1e-6);  // G = AL·(c − 1) + LS
  EXPECT_FLOAT_EQ(*facts->depthMm, 1.0f);
  EXPECT_FLOAT_EQ(*facts->limitMm, 1.5f);
  EXPECT_FLOAT_EQ(*view.facts(0, firstCarved())->depthMm, 0.2f);
}

TEST_F(SearchViewTest, TheQuietZoneHasOnlyALuminance) {
  const SearchView view(symbol_, record_, kContrast);
  const auto facts = view.facts(0, {-kQuiet, -1});
  ASSERT_TRUE(facts.has_value());
  EXPECT_FALSE(facts->inSymbol || facts->dark || facts->carved);
  EXPECT_FLOAT_EQ(facts->luminance, 0.9f);
  EXPECT_FALSE(facts->around || facts->excess || facts->depthMm || facts->limitMm);
  EXPECT_FALSE(view.facts(0, {-kQuiet - 1, 0}).has_value());
  EXPECT_FALSE(view.facts(0, {0, mask_.rows() + kQuiet}).has_value());
}

TEST_F(SearchViewTest, UncarvedSubmodulesOfADarkModuleAreDark) {
  const SearchView view(symbol_, record_, kContrast);
  int standing = 0;
  for (int row = 0; row < mask_.rows(); ++row) {
    for (int column = 0; column < mask_.rows(); ++column) {
      const auto facts = view.facts(1, {row, column});
      ASSERT_EQ(facts->carved, mask_.at(row, column));
      ASSERT_EQ(facts->dark, symbol_.isDark(row / 5, column / 5));
      ASSERT_EQ(facts->depthMm.has_value(), facts->carved);
      ASSERT_EQ(facts->excess.has_value(), facts->dark);
      standing += facts->dark && !facts->carved;
    }
  }
  EXPECT_GT(standing, 1000);
}

TEST_F(SearchViewTest, SummarisesThePasses) {
  const SearchView view(symbol_, record_, kContrast);
  const auto& passes = view.summaries();
  ASSERT_EQ(passes.size(), 3u);
  const auto count = static_cast<double>(record_.carved.size());
  EXPECT_EQ(passes[0].unmet, static_cast<int>(count));  // 0.8 and 0.7 are brighter than 0.63,
  EXPECT_EQ(passes[1].unmet, static_cast<int>(count));
  EXPECT_EQ(passes[2].unmet, 1);  // 0.6 is not
  EXPECT_NEAR(passes[0].greatestExcess, 0.17, 1e-6);
  EXPECT_NEAR(passes[2].greatestExcess, 0.01, 1e-6);
  EXPECT_NEAR(passes[0].meanDepthMm, 0.2, 1e-6);
  EXPECT_NEAR(passes[2].meanDepthMm, (0.6 * (count - 1) + 1.0) / count, 1e-6);
  EXPECT_FLOAT_EQ(passes[0].changeMm, 0.2f);
  EXPECT_FLOAT_EQ(passes[1].changeMm, 0.2f);
  EXPECT_FLOAT_EQ(passes[2].changeMm, 0.6f);
  EXPECT_FLOAT_EQ(passes[2].maxDepthMm, 1.0f);
  EXPECT_EQ(passes[1].ms, 11);
}

TEST_F(SearchViewTest, CountsLikeTheSearch) {
  PaperStepSearch search({&symbol_, &mask_, 25, std::vector<double>(mask_.size(), 3.0)}, {.contrast = kContrast});
  SearchRecord record = record_;
  record.passes.resize(1);
  // Light modules differ, so AL differs, too.
  Grid<double> luminance(edge_, edge_);
  for (int row = 0; row < edge_; ++row)
    for (int column = 0; column < edge_; ++column)
      luminance.at(row, column) = 0.8 + 0.1 * std::sin(row * 0.3) * std::cos(column * 0.2);
  for (std::size_t k = 0; k < record.carved.size(); ++k) {
    const int i = static_cast<int>(record.carved[k]);
    double& seen = luminance.at(i / mask_.rows() + kQuiet, i % mask_.rows() + kQuiet);
    seen = 0.55 + 0.1 * std::sin(static_cast<double>(k));
    record.passes[0].luminance[k] = static_cast<float>(seen);
  }
  record.luminance = Grid<float>(luminance);
  search.update(luminance);
  const SearchView view(symbol_, record, kContrast);
  EXPECT_EQ(view.summaries()[0].unmet,
            std::count(search.states().begin(), search.states().end(), DepthState::Searching));
  EXPECT_NEAR(view.summaries()[0].greatestExcess, search.worstExcess(), 1e-6);
}

TEST_F(SearchViewTest, TheMapsShowEverySubmoduleAtItsPosition) {
  const SearchView view(symbol_, record_, kContrast);
  const auto inMap = [&](SubmodulePlace p) {
    return static_cast<std::size_t>((p.row + kQuiet) * edge_ + p.column + kQuiet);
  };
  const ValueMap depths = view.depths(2), luminance = view.luminance(2), excess = view.excess(2),
                 limits = view.limits();
  ASSERT_EQ(depths.columns, edge_);
  EXPECT_FLOAT_EQ(depths.values[inMap(firstCarved())], 1.0f);
  EXPECT_FLOAT_EQ(luminance.values[inMap(firstCarved())], 0.64f);
  EXPECT_NEAR(excess.values[inMap(firstCarved())], 0.01, 1e-6);
  EXPECT_FLOAT_EQ(limits.values[inMap(firstCarved())], 1.5f);
  EXPECT_TRUE(std::isnan(depths.values[0]));
  EXPECT_FLOAT_EQ(luminance.values[0], 0.9f);
  // A point of the map and its submodule map to each other.
  for (const SubmodulePlace place : {firstCarved(), SubmodulePlace{-kQuiet, -kQuiet}, SubmodulePlace{50, 3}}) {
    const Vec2 middle((place.column + kQuiet + 0.5) / edge_, (place.row + kQuiet + 0.5) / edge_);
    EXPECT_EQ(view.placeAt(middle), place);
    EXPECT_EQ(depths.indexAt(middle), inMap(place));
  }
  EXPECT_FALSE(view.placeAt({1.0, 0.5}).has_value());
}

TEST_F(SearchViewTest, TheLightSubmodulesAreThoseOutsideDarkModules) {
  const SearchView view(symbol_, record_, kContrast);
  const auto dark = std::count(symbol_.dark.begin(), symbol_.dark.end(), 1);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(view.lightLuminance().size()), edge_ * edge_ - 25 * dark);
}

}  // namespace
}  // namespace qrelief
