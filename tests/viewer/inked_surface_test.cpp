// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/inked_surface.h"

#include <algorithm>

#include "mesh/prepare.h"
#include "pipeline/engrave.h"
#include "settings/settings.h"
#include "support/gl_test.h"
#include "support/shapes.h"
#include "support/solid_oracle.h"

namespace qrelief {
namespace {

class InkedSurfaceTest : public GlTest {
 protected:
  /// Engraves the top of a box of 60 × 60 × 20 mm.
  static EngraveResult engraved(Mark mark) {
    EngraveRequest request = defaultRequest();
    request.code.text = "A";
    request.marking.mark = mark;
    request.placement.centreMm = {0, 0, 10};
    request.placement.sizeMode = SizeMode::Fixed;
    request.placement.sizeMm = 30;
    const auto model = EngravableModel::upload(*prepareModel(shapes::soupOf(shapes::box({60, 60, 20})), {}));
    auto result = engrave(model, request);
    EXPECT_TRUE(result.has_value());
    return result ? std::move(*result) : EngraveResult{};
  }
  static double inkMm2(const InkedSurface& surface) {
    double area = 0;
    for (std::size_t t = 0; t < surface.isInk.size(); ++t)
      if (surface.isInk[t])
        area += glm::length(glm::cross(surface.mesh.corner(t, 1) - surface.mesh.corner(t, 0),
                                       surface.mesh.corner(t, 2) - surface.mesh.corner(t, 0))) /
                2;
    return area;
  }
  static double darkMm2(const EngraveResult& result) {
    const double moduleMm = result.placement.moduleMm;
    return static_cast<double>(std::count(result.symbol.dark.begin(), result.symbol.dark.end(), 1)) * moduleMm *
           moduleMm;
  }
};

TEST_F(InkedSurfaceTest, PaintIsTheModelsSurfaceWithThePaintedTriangles) {
  const EngraveResult result = engraved(Mark::Paint);
  const InkedSurface surface = inkedSurface(result);
  EXPECT_EQ(surface.mesh.triangles, result.mesh.triangles);
  EXPECT_EQ(static_cast<std::size_t>(std::count(surface.isInk.begin(), surface.isInk.end(), true)),
            result.painted.size());
  EXPECT_NEAR(inkMm2(surface), darkMm2(result), 5e-3 * darkMm2(result));  // outlines move by up to 0.01 mm
}

TEST_F(InkedSurfaceTest, AnInlayAndItsModelHaveTheOutsideOfTheModel) {
  const EngraveResult result = engraved(Mark::Inlay);
  const InkedSurface surface = inkedSurface(result);
  EXPECT_EQ(surfaceProblems(surface.mesh), "");
  EXPECT_NEAR(signedVolume(surface.mesh), 60.0 * 60 * 20, 1e-2);
  EXPECT_NEAR(inkMm2(surface), darkMm2(result), 5e-3 * darkMm2(result));  // outlines move by up to 0.01 mm
  EXPECT_TRUE(std::equal(result.mesh.triangles.begin(),
                         result.mesh.triangles.begin() + static_cast<std::ptrdiff_t>(result.keptTriangles),
                         surface.mesh.triangles.begin()));
}

TEST_F(InkedSurfaceTest, TheBodyKeepsTheModelsColoursAndTheCodeHasTheInks) {
  constexpr Colour kRed{200, 30, 30}, kBlue{20, 40, 210};
  for (const Mark mark : {Mark::Paint, Mark::Inlay}) {
    const EngraveResult result = engraved(mark);
    const InkedSurface surface = inkedSurface(result);
    std::vector<std::optional<Colour>> ofModel(12, kBlue);
    ofModel[result.placement.seed] = kRed;
    const auto colours = inkedColours(surface, result, ofModel);
    const auto plain = inkedColours(surface, result, {});
    ASSERT_EQ(colours.size(), surface.mesh.triangles.size());
    ASSERT_EQ(plain.size(), surface.mesh.triangles.size());
    for (std::size_t t = 0; t < colours.size(); ++t) {
      if (surface.isInk[t]) {
        EXPECT_EQ(colours[t], plain[t]);
        EXPECT_LT((*plain[t])[0], 100);
      } else {
        EXPECT_GT((*plain[t])[0], 200);
        EXPECT_EQ(colours[t], t < result.keptTriangles ? ofModel[result.origins[t].facet] : kRed);
      }
    }
  }
}

}  // namespace
}  // namespace qrelief
