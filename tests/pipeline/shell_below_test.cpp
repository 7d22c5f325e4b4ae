// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/shell_below.h"

#include <gtest/gtest.h>

#include "pipeline/engrave.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

Mesh slab(double bottom, double top, double edge = 60) {
  return shapes::translated(shapes::box({edge, edge, top - bottom}), {0, 0, (bottom + top) / 2});
}

/// Looks from above at a code of 30 mm on z = 22.
std::optional<double> below(const Mesh& mesh, double reachMm = 5) {
  Placement placement;
  placement.frame = makeFrame({0, 0, 22}, {0, 0, 1}, {0, 1, 0}, 1e6);
  placement.symbolMm = 30;
  return shellBelowMm(mesh, placement, reachMm);
}

TEST(ShellBelow, IsFoundWhereItBeginsWithinTheMaterial) {
  const auto found = below(shapes::together(slab(0, 20), slab(19, 22)));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(*found, 2, 1e-6);
  EXPECT_FALSE(below(shapes::together(slab(0, 20), slab(19, 22)), 1.9).has_value()) << "out of reach";
}

TEST(ShellBelow, IsFoundWhereItTouchesTheFarSide) {
  const auto found = below(shapes::together(slab(0, 20), slab(20, 22)));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(*found, 2, 1e-6);
}

TEST(ShellBelow, IsFoundUnderAPartOfTheCode) {
  EXPECT_TRUE(below(shapes::together(shapes::translated(slab(0, 20, 20), {14, 14, 0}), slab(19, 22))).has_value());
}

TEST(ShellBelow, IsNoneBehindAGapAndNoCavity) {
  EXPECT_FALSE(below(slab(18, 22)).has_value());
  EXPECT_FALSE(below(shapes::together(slab(0, 18), slab(19, 22))).has_value()) << "air between them";
  EXPECT_FALSE(below(shapes::together(slab(0, 22), shapes::insideOut(slab(10, 19, 40)))).has_value());
}

/// Looks from above for a second surface at z = 22, where the first triangle of the last body lies.
bool isTwin(const Mesh& below, const Mesh& last) {
  Placement placement;
  placement.frame = makeFrame({0, 0, 22}, {0, 0, 1}, {0, 1, 0}, 1e6);
  placement.symbolMm = 30;
  Mesh mesh = shapes::together(below, last);
  mesh.bodyOf.assign(below.triangles.size(), 0);
  mesh.bodyOf.resize(mesh.triangles.size(), 1);
  placement.seed = static_cast<std::uint32_t>(below.triangles.size());
  return hasTwinSurface(mesh, placement);
}

TEST(TwinSurface, IsThatOfAnotherBodyInTheSamePlace) {
  EXPECT_TRUE(isTwin(slab(0, 22), slab(0, 22)));
  EXPECT_TRUE(isTwin(slab(0, 22), shapes::translated(slab(0, 22), {0.5, 0, 0}))) << "a copy that was moved along it";
  EXPECT_TRUE(isTwin(slab(0, 22), slab(20, 22, 40))) << "a flush body";
}

TEST(TwinSurface, IsNoneBelowOrBesideTheCodeOrUnderLessThanHalfOfIt) {
  EXPECT_FALSE(isTwin(slab(0, 20), slab(20, 22)));
  EXPECT_FALSE(isTwin(slab(0, 21.9), slab(0, 22)));
  EXPECT_FALSE(isTwin(shapes::translated(slab(0, 22), {70, 0, 0}), slab(0, 22)));
  EXPECT_FALSE(isTwin(shapes::translated(slab(0, 22, 20), {14, 14, 0}), slab(0, 22)));
  Mesh one = slab(0, 22);
  EXPECT_FALSE(hasTwinSurface(one, Placement())) << "one body";
}

TEST(TwinSurface, IsNamedBeforeAnythingIsCarved) {
  const Mesh block = slab(0, 22);
  PolygonSoup soup = shapes::soupOf(shapes::together(block, block));
  soup.bodies = {{"a", 0}, {"b", 1}};
  soup.bodyOf.assign(block.triangles.size(), 0);
  soup.bodyOf.resize(soup.triangles.size(), 1);
  EngraveRequest request;
  request.code.text = "HELLO";
  request.placement.centreMm = {20, 0, 22};  // away from the edges of the facets
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 8;
  const auto result = engrave(EngravableModel::create(*prepareModel(soup, {}), nullptr), request);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().message.code, "shell-in-same-place");
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
}

TEST(ShellBelow, IsNamedIfItLeavesNoDepth) {
  const auto refusal = [](const Mesh& mesh) {
    auto prepared = prepareModel(shapes::soupOf(mesh), {});
    EXPECT_TRUE(prepared.has_value());
    EngraveRequest request;
    request.code.text = "HELLO";
    request.placement.centreMm = {0, 0, 20.7};
    request.placement.direction = Vec3(0, 0, 1);
    request.placement.upHint = {0, 1, 0};
    request.placement.sizeMode = SizeMode::Fixed;
    request.placement.sizeMm = 25;
    const auto result = engrave(EngravableModel::create(std::move(*prepared), nullptr), request);
    return result ? Message() : result.error().message;
  };
  EXPECT_EQ(refusal(shapes::together(slab(0, 20), slab(19.95, 20.7))).code, "nothing-can-be-carved-over-shell");
  EXPECT_EQ(refusal(slab(19.95, 20.7)).code, "nothing-can-be-carved");
}

}  // namespace
}  // namespace qrelief
