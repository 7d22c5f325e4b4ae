// SPDX-License-Identifier: GPL-3.0-or-later
// Codes with shaped floors, from the search to the light on the mesh.
#include <cmath>
#include <gtest/gtest.h>

#include "carving/embed.h"
#include "math/tolerance.h"
#include "mesh/ray_tree.h"
#include "pipeline/engrave.h"
#include "study/methods/shaped_floor_search.h"
#include "study/path_tracer.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief::study {
namespace {

class ShapedFloorTest : public GlTest {
 protected:
  ShapedFloorTest() {
    model_ = EngravableModel::upload(*prepareModel(shapes::soupOf(shapes::box({50, 50, 10})), {}));
    request_.code.text = "QRELIEF";
    request_.code.modulePattern = ModulePattern::ThickPlus;
    request_.code.finderPattern = FinderPattern::ThickPlusSharp;
    request_.code.symbol.version = 1;
    request_.placement.centreMm = {0, 0, 5};
    request_.placement.upHint = {0, 1, 0};
    request_.placement.sizeMode = SizeMode::Fixed;
    request_.placement.sizeMm = 25.2;
  }

  EngraveResult carved(FloorShape floor) const {
    const ShapedFloorOptions options{.shape = floor, .contrast = request_.depth.contrastAsked()};
    CarveJob::Known known;
    known.makeSearch = [options](CarvingTarget target) {
      return std::make_unique<ShapedFloorSearch>(std::move(target), options);
    };
    auto job = CarveJob::create(model_, request_, known);
    EXPECT_TRUE(job.has_value()) << job.error().message;
    auto result = runToEnd(**job);
    EXPECT_TRUE(result.has_value()) << result.error().message;
    return std::move(*result);
  }

  /// Returns the mean light of the carved submodules, traced on the mesh.
  static double floorLight(const Mesh& mesh, const EngraveResult& result, const PathTraceOptions& options) {
    std::vector<SeenCell> cells;
    for (int row = 0; row < result.depths.size; ++row)
      for (int column = 0; column < result.depths.size; ++column) {
        if (result.depths.depth(row, column) == 0) continue;
        const Vec2 topLeft = result.depths.corner(row, column), bottomRight = result.depths.corner(row + 1, column + 1);
        cells.push_back({{topLeft.x, bottomRight.y}, {bottomRight.x, topLeft.y}});
      }
    double sum = 0;
    for (const CellLight& light : traceCells(RayTree(mesh), result.placement.frame, cells, options))
      sum += light.luminance.mean / static_cast<double>(cells.size());
    return sum;
  }

  /// Gives the carved submodules of a module their mean depth.
  static void flatten(DepthField& depths, int moduleRow, int moduleColumn) {
    std::vector<std::size_t> carved;
    double sum = 0;
    for (int k = 0; k < 25; ++k) {
      const int row = 5 * moduleRow + k / 5, column = 5 * moduleColumn + k % 5;
      if (depths.depth(row, column) == 0) continue;
      carved.push_back(static_cast<std::size_t>(row * depths.size + column));
      sum += depths.depth(row, column);
    }
    for (const std::size_t i : carved)
      depths.depthMm[i] = std::round(sum / static_cast<double>(carved.size()) / kDepthQuantumMm) * kDepthQuantumMm;
  }

  std::shared_ptr<const EngravableModel> model_;
  EngraveRequest request_;
};

TEST_F(ShapedFloorTest, EveryShapeIsASolidWithTheRequestedContrast) {
  for (const FloorShape floor : {FloorShape::Tilted, FloorShape::Wavy}) {
    const EngraveResult result = carved(floor);
    EXPECT_TRUE(result.solidity.solid()) << floorShapeName(floor);
    EXPECT_EQ(result.limitedSubmodules, 0u);
    EXPECT_LT(floorLight(result.mesh, result, {.paths = 64}), 1 - presetContrast(Preset::Balanced) + 0.02)
        << floorShapeName(floor);
  }
}

TEST_F(ShapedFloorTest, AShapedFloorIsDarkerThanAFlatOneOfItsMeanDepth) {
  for (const FloorShape floor : {FloorShape::Tilted, FloorShape::Wavy}) {
    const EngraveResult shaped = carved(floor);
    EngraveResult flat = shaped;
    for (int row = 0; row < shaped.symbol.size; ++row)
      for (int column = 0; column < shaped.symbol.size; ++column) flatten(flat.depths, row, column);
    EXPECT_NEAR(summarise(flat.depths).meanMm, summarise(shaped.depths).meanMm, kDepthQuantumMm);
    const auto embedded =
        embedDepthField(model_->prepared.mesh, flat.placement.frame, flat.placement.patch.triangles, flat.depths, {});
    ASSERT_TRUE(embedded.has_value());
    const auto gain = [&](const PathTraceOptions& options) {
      return floorLight(embedded->mesh, flat, options) - floorLight(shaped.mesh, shaped, options);
    };
    const double underSky = gain({.paths = 64});
    EXPECT_GT(underSky, 0.01) << floorShapeName(floor);
    if (floor == FloorShape::Tilted) {
      EXPECT_GT(gain({.paths = 64, .lights = {{.azimuthDeg = 90, .elevationDeg = 35}}}), 1.5 * underSky);
    }
  }
}

TEST_F(ShapedFloorTest, NoSubmoduleExceedsTheMaximumDepth) {
  request_.depth.maxDepthMm = 0.2;
  const EngraveResult result = carved(FloorShape::Wavy);
  EXPECT_LE(summarise(result.depths).maxMm, 0.2 + 1e-9);
  EXPECT_GT(result.limitedSubmodules, 0u);
}

}  // namespace
}  // namespace qrelief::study
