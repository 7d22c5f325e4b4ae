// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/contrast_for_print.h"

#include <cmath>
#include <functional>
#include <gmock/gmock.h>

#include "depth/fast_search.h"
#include "pipeline/engrave.h"
#include "pipeline/printed_view.h"
#include "qr/module_pattern.h"
#include "settings/settings.h"
#include "support/follow_job.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kContrast = 0.3;

/// Returns the submodules' light: light modules fully lit, dark ones with the given contrast.
Grid<double> lit(const Symbol& symbol, const std::function<double(int row, int column)>& contrastOf) {
  const int edge = kSubmodulesPerModule * (symbol.size + 2 * kQuietZoneModules);
  Grid<double> light(edge, edge, 1);
  for (int y = 0; y < edge; ++y)
    for (int x = 0; x < edge; ++x) {
      const int row = y / kSubmodulesPerModule - kQuietZoneModules;
      const int column = x / kSubmodulesPerModule - kQuietZoneModules;
      const bool within = row >= 0 && column >= 0 && row < symbol.size && column < symbol.size;
      if (within && symbol.isDark(row, column)) light.at(y, x) = 1 - contrastOf(row, column);
    }
  return light;
}

TEST(ContrastForPrint, RaisesTheTargetByWhatThePrintLacksOfTwoThirds) {
  const Symbol symbol = *encodeSymbol("QRELIEF", {});
  const auto designed = lit(symbol, [](int, int) { return 0.3; });
  // From left to right, columns keep more of the design's contrast, from none to all of it.
  const auto share = [&](int column) { return static_cast<double>(column) / (symbol.size - 1); };
  const auto printed = lit(symbol, [&](int, int column) { return 0.3 * share(column); });
  const std::vector<double> asked = contrastForPrint(symbol, designed, printed, kContrast);
  ASSERT_EQ(asked.size(), symbol.dark.size());
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) {
      const double lacks = symbol.isDark(row, column) ? std::max(0.0, kPrintedShare - share(column)) : 0;
      EXPECT_NEAR(asked[static_cast<std::size_t>(row * symbol.size + column)], kContrast * (1 + lacks), 1e-9)
          << row << ", " << column;
    }
}

TEST(ContrastForPrint, ComparesFinderPatternsAndOtherModulesSeparately) {
  const Symbol symbol = *encodeSymbol("QRELIEF", {});
  const auto isFinder = [&](int row, int column) { return symbol.role(row, column) == ModuleRole::Finder; };
  // The design gives other modules a third of the finder patterns' contrast, as square modules would. Finder patterns
  // print with half their contrast, other modules with all of it.
  const auto designed = lit(symbol, [&](int row, int column) { return isFinder(row, column) ? 0.3 : 0.1; });
  const auto printed = lit(symbol, [&](int row, int column) { return isFinder(row, column) ? 0.15 : 0.1; });
  const std::vector<double> asked = contrastForPrint(symbol, designed, printed, kContrast);
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) {
      const double lacks = isFinder(row, column) && symbol.isDark(row, column) ? kPrintedShare - 0.5 : 0;
      EXPECT_NEAR(asked[static_cast<std::size_t>(row * symbol.size + column)], kContrast * (1 + lacks), 1e-9);
    }
}

TEST(ContrastForPrint, IsAtMostTwiceTheContrastAndNeverMoreThanAPocketCanHave) {
  const Symbol symbol = *encodeSymbol("QRELIEF", {});
  const auto designed = lit(symbol, [](int, int) { return 0.3; });
  const auto brighter = lit(symbol, [](int, int) { return -0.5; });  // pits shine, grooves are dark
  for (const auto& [contrast, most] : {std::pair{0.3, 0.6}, {0.5, 0.8}, {0.9, 0.9}}) {
    const std::vector<double> asked = contrastForPrint(symbol, designed, brighter, contrast);
    EXPECT_EQ(*std::max_element(asked.begin(), asked.end()), most);
    EXPECT_EQ(*std::min_element(asked.begin(), asked.end()), contrast);
  }
}

class CarvedForPrintTest : public GlTest {
 protected:
  CarvedForPrintTest() {
    // On a dome the layers' steps are wide on top and narrow at the rim.
    model_ = EngravableModel::upload(
        *prepareModel(shapes::soupOf(shapes::plate({50, 50}, 12, 100, 100,
                                                   [](double x, double y) { return -0.008 * (x * x + y * y); })),
                      {}));
    request_.code.text = "QRELIEF";
    request_.code.modulePattern = ModulePattern::ThickPlus;
    request_.code.finderPattern = FinderPattern::ThickPlusSharp;
    request_.placement.centreMm = {0, 0, 0};
    request_.placement.upHint = {0, 1, 0};
    request_.placement.sizeMode = SizeMode::Fixed;
    request_.placement.sizeMm = 21;  // modules of a millimetre
    request_.print.buildUp.pose = BuildPose::CodeUp;
  }

  EngraveResult carved(const EngraveRequest& request) const { return *engrave(model_, request); }

  /// Returns the stages of carving in their order.
  std::vector<std::string> stagesOf(const EngraveRequest& request) const {
    return followJob(**CarveJob::create(model_, request));
  }

  /// Returns the additional contrast that the print requires from the dark modules, on average.
  double lacks(const EngraveResult& result) const {
    auto job = PrintedViewJob::create(result.mesh, **printedViewOf(verifyRequestOf(request_, result)));
    const PrintedView printed = *runToEnd(**job);
    const Grid<double> ink = lit(result.symbol, [](int, int) { return kContrast; });
    const std::vector<double> asked = contrastForPrint(result.symbol, ink, printed.submodules, kContrast);
    double sum = 0, dark = 0;
    for (std::size_t module = 0; module < asked.size(); ++module) {
      sum += asked[module] - kContrast;
      dark += result.symbol.dark[module];
    }
    return sum / dark;
  }

  std::shared_ptr<const EngravableModel> model_;
  EngraveRequest request_;
};

TEST_F(CarvedForPrintTest, ThePrintReachesMoreOfTheContrastAtLittleMoreDepth) {
  const EngraveResult forDesign = carved(request_);
  request_.depth.carveFor = CarveFor::Print;
  const EngraveResult forPrint = carved(request_);
  EXPECT_GT(lacks(forDesign), 0.03);
  EXPECT_LT(lacks(forPrint), 0.6 * lacks(forDesign));
  EXPECT_TRUE(forPrint.solidity.solid());
  EXPECT_LT(summarise(forPrint.depths).meanMm, 1.3 * summarise(forDesign.depths).meanMm);
  for (std::size_t i = 0; i < forPrint.depths.depthMm.size(); ++i)
    EXPECT_EQ(forPrint.depths.depthMm[i] > 0, forDesign.depths.depthMm[i] > 0);
}

TEST_F(CarvedForPrintTest, UnderALampDepthsGrowAndHardlyShrinkFromThoseOfTheDesign) {
  request_.depth.lights = {{30, 45, 1}};
  const EngraveResult forDesign = carved(request_);
  request_.depth.carveFor = CarveFor::Print;
  const EngraveResult forPrint = carved(request_);
  EXPECT_LT(lacks(forPrint), lacks(forDesign));
  EXPECT_TRUE(forPrint.solidity.solid());
  EXPECT_GT(summarise(forPrint.depths).meanMm, 1.05 * summarise(forDesign.depths).meanMm);
  for (std::size_t i = 0; i < forPrint.depths.depthMm.size(); ++i)  // deeper neighbours darken a floor
    EXPECT_GE(forPrint.depths.depthMm[i], forDesign.depths.depthMm[i] - 2 * kLampSlackMm);
}

TEST_F(CarvedForPrintTest, SimulatesARoughPrintAndThenSearchesDepthsAgain) {
  using testing::ElementsAre;
  request_.placement.sizeMm = 12;
  request_.depth.carveFor = CarveFor::Design;
  EXPECT_THAT(stagesOf(request_), ElementsAre("finding-direction-and-size", "measuring-surface", "finding-depth",
                                              "carving-mesh", "checking-solid", "looking-at-result"));
  request_.depth.carveFor = CarveFor::Print;
  EXPECT_THAT(stagesOf(request_),
              ElementsAre("finding-direction-and-size", "measuring-surface", "finding-depth", "carving-mesh",
                          "printing", "finding-depth", "carving-mesh", "checking-solid", "looking-at-result"));
}

TEST_F(CarvedForPrintTest, CarvesForTheDesignIfNoPrintCanBeSimulated) {
  request_.placement.sizeMm = 12;
  const auto depthsBy = [&](const std::function<void(EngraveRequest&)>& change, CarveFor carveFor) {
    EngraveRequest changed = request_;
    change(changed);
    changed.depth.carveFor = carveFor;
    return carved(changed).depths.depthMm;
  };
  const std::function<void(EngraveRequest&)> changes[] = {
      [](EngraveRequest& r) { r.print.process.reset(); },
      [](EngraveRequest& r) { r.depth.solver = ContrastSolver::PaperSteps; },
      [](EngraveRequest& r) { r.depth.objective = DepthObjective::OneLight; }};
  for (const auto& change : changes) EXPECT_EQ(depthsBy(change, CarveFor::Print), depthsBy(change, CarveFor::Design));
  const auto none = [](EngraveRequest&) {};
  EXPECT_NE(depthsBy(none, CarveFor::Print), depthsBy(none, CarveFor::Design));
}

TEST(CarveFor, IsThePrintByDefault) {
  EXPECT_EQ(defaultRequest().depth.carveFor, CarveFor::Print);
  EXPECT_TRUE(defaultRequest().isForPrint());
}

}  // namespace
}  // namespace qrelief
