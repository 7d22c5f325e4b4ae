// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/outlined_pockets.h"

#include <cmath>
#include <gtest/gtest.h>

#include "carving/carving_oracle.h"
#include "messages/sentences.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using oracle::fieldOf;

/// Carves with a patch that includes the label's surroundings.
Result<EmbedResult> carve(const Mesh& mesh, const ProjectionFrame& frame, const DepthField& field,
                          const EmbedOptions& options) {
  const auto patch = oracle::frontPatch(mesh, buildAdjacency(mesh.triangles), frame, 40);
  return embedDepthField(mesh, frame, patch, field, options);
}

/// Returns a label in millimetres, for modules of one.
OutlinedPockets pockets(const LabelOptions& label, int modules, double depthMm) {
  auto layout = layOutLabel(label, modules);
  EXPECT_TRUE(layout.has_value()) << layout.error().message;
  return {layout->rings, layout->covered, depthMm};
}

double areaOf(const OutlinedPockets& pockets) {
  double area = 0;
  for (const Ring& ring : pockets.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) area += cross2(ring[i], ring[(i + 1) % ring.size()]) / 2;
  return area;
}

/// Looks straight down from so far that pockets are prisms.
ProjectionFrame fromFarAbove() { return makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1e5); }

const DepthField kNoCode = fieldOf(25, 25, [](int, int) { return 0.0; });

TEST(OutlinedPockets, RemoveTheirAreaTimesTheirDepth) {
  const Mesh mesh = shapes::plate({61, 57}, 10, 3, 2);
  const OutlinedPockets label = pockets({"Part Ä8", LabelFrame::Rounded}, 25, 0.4);
  const auto result = carve(mesh, fromFarAbove(), kNoCode, {.label = label});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
  const double lost = signedVolume(mesh) - signedVolume(result->mesh), expected = areaOf(label) * 0.4;
  EXPECT_GT(expected, 30);
  EXPECT_NEAR(lost, expected, 0.002 * expected);
}

TEST(OutlinedPockets, AreCarvedWithTheCodeInOnePass) {
  const Mesh mesh =
      shapes::plate({61, 57}, 10, 7, 5, [](double x, double y) { return 0.4 * std::sin(x / 9) + y / 40; });
  const DepthField code = fieldOf(25, 25, [](int r, int c) { return (r * 7 + c * 3) % 5 < 2 ? 0.6 : 0.0; });
  const OutlinedPockets label = pockets({"id 007", LabelFrame::Square}, 25, 0.4);
  const ProjectionFrame frame = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 250);
  const auto result = carve(mesh, frame, code, {.inlay = true, .label = label});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
  // The inlay fills exactly what was removed.
  const double lost = signedVolume(mesh) - signedVolume(result->mesh);
  EXPECT_NEAR(signedVolume(result->inlay), lost, 1e-4 * lost);
  const auto alone = carve(mesh, frame, code, {});
  ASSERT_TRUE(alone);
  const double byLabel = signedVolume(alone->mesh) - signedVolume(result->mesh);
  EXPECT_NEAR(byLabel, areaOf(label) * 0.4, 0.05 * byLabel);
}

TEST(OutlinedPockets, GoWithAResampledSquare) {
  const Mesh mesh = shapes::plate({61, 57}, 10, 3, 2);
  const DepthField code = fieldOf(25, 25, [](int r, int c) { return (r + c) % 2 == 0 ? 0.6 : 0.0; });
  const auto result = carve(mesh, fromFarAbove(), code,
                            {.surface = SurfaceMode::Resampled, .label = pockets({"R", LabelFrame::None}, 25, 0.4)});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(oracle::solidProblems(*result), "");
}

TEST(OutlinedPockets, LeaveNoRoomIsAnError) {
  const Mesh mesh = shapes::plate({30, 30}, 10, 3, 2);
  const auto result = carve(mesh, fromFarAbove(), kNoCode, {.label = pockets({"Part 8", LabelFrame::None}, 25, 0.4)});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
}

TEST(OutlinedPockets, LongSidesAreDividedAndNodesMoveLittle) {
  OutlineGraph graph;
  addOutlines(graph, {{{{0, 0}, {10, 0}, {10, 1}, {0, 1}}}, {{{0, 0}, {10, 1}}}, 0.4}, 2.5);
  ASSERT_EQ(graph.nodes.size(), 10u);
  ASSERT_EQ(graph.outlines.size(), 10u);
  EXPECT_EQ(graph.nodes[1], Vec2(2.5, 0));
  EXPECT_EQ(graph.outlines[9].to, 0u);
  for (const Outline& outline : graph.outlines) {
    EXPECT_EQ(outline.left, 40);
    EXPECT_EQ(outline.right, 0);
  }
  EXPECT_DOUBLE_EQ(graph.leewayMm[0], 1.0 / 8);
  EXPECT_DOUBLE_EQ(graph.leewayMm[1], 2.5 / 8);
}

}  // namespace
}  // namespace qrelief
