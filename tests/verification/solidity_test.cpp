// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/solidity.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/crossing_segments.h"
#include "message_codes/model.h"
#include "messages/sentences.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

SolidityReport check(const Mesh& mesh, std::span<const std::uint32_t> suspects = {}) {
  const auto report = checkSolidity(mesh, suspects);
  EXPECT_TRUE(report);
  return report.value_or(SolidityReport{});
}

std::vector<std::string> wordsOf(const SolidityReport& report) {
  std::vector<std::string> words;
  for (const Message& problem : report.problems()) words.push_back(sentence(problem));
  return words;
}

TEST(Solidity, AcceptsClosedShapesAndMeasuresTheirVolume) {
  const SolidityReport box = check(shapes::box({2, 3, 5}));
  EXPECT_TRUE(box.solid());
  EXPECT_THAT(wordsOf(box), testing::IsEmpty());
  EXPECT_EQ(box.triangles, 12u);
  EXPECT_EQ(box.vertices, 8u);
  EXPECT_NEAR(box.volumeMm3, 30, 1e-9);
  EXPECT_TRUE(check(shapes::torus(40, 10, 30, 20)).solid());
  EXPECT_NEAR(check(shapes::tetrahedron(6)).volumeMm3, 216 / (6 * std::sqrt(2.0)), 1e-4);
}

TEST(Solidity, CountsTheEdgesOfAHole) {
  Mesh mesh = shapes::icosphere(10, 2);
  mesh.triangles.pop_back();
  const SolidityReport report = check(mesh);
  EXPECT_EQ(report.openEdges, 3u);
  EXPECT_FALSE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_THAT(wordsOf(report), testing::ElementsAre("3 open edges"));
}

TEST(Solidity, CountsTheEdgesOfAFlippedTriangle) {
  Mesh mesh = shapes::icosphere(10, 2);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const SolidityReport report = check(mesh);
  EXPECT_EQ(report.misorientedEdges, 3u);
  EXPECT_THAT(wordsOf(report), testing::ElementsAre("3 edges between triangles that face opposite ways"));
}

TEST(Solidity, CountsAVertexWhereTwoPartsTouch) {
  // The second box's first corner is welded to the first box's last corner.
  Mesh mesh = shapes::together(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {2, 2, 2}));
  const Vec3f meeting(1, 1, 1);
  std::uint32_t count = 0;
  while (mesh.positions[count] != meeting) ++count;
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t)
      if (mesh.positions[v] == meeting) v = count;
  const SolidityReport report = check(mesh);
  EXPECT_EQ(report.nonManifoldVertices, 1u);
  EXPECT_EQ(report.nonManifoldEdges, 0u);
  EXPECT_THAT(wordsOf(report), testing::ElementsAre("1 vertex where parts touch in a point only"));
}

TEST(Solidity, CountsAnEdgeOfFourTriangles) {
  Mesh mesh = shapes::together(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {2, 2, 0}));
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t)
      for (std::uint32_t w = 0; w < v; ++w)
        if (mesh.positions[w] == mesh.positions[v]) v = w;
  const SolidityReport report = check(mesh);
  EXPECT_EQ(report.nonManifoldEdges, 1u);
  EXPECT_EQ(report.openEdges, 0u);
  EXPECT_FALSE(report.manifold());
}

TEST(Solidity, DistinguishesExactlyFromNearlyCollinear) {
  // Two triangles of a box's side are split at a point on their diagonal, then at one that is one float off it.
  for (const bool exact : {true, false}) {
    Mesh mesh = shapes::box({2, 2, 2});
    const Triangle t = mesh.triangles[0];
    Vec3f middle = (mesh.positions[t[0]] + mesh.positions[t[1]]) * 0.5f;
    if (!exact) middle += (mesh.positions[t[2]] - middle) * 1e-7f;
    const auto m = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(middle);
    mesh.triangles[0] = {t[0], m, t[2]};
    mesh.triangles.push_back({m, t[1], t[2]});
    mesh.triangles.push_back({t[0], t[1], m});
    const SolidityReport report = check(mesh);
    EXPECT_EQ(report.degenerateTriangles, exact ? 1u : 0u);
    EXPECT_EQ(report.openEdges + report.nonManifoldEdges, 0u);
  }
}

TEST(Solidity, CountsADuplicateTriangle) {
  Mesh mesh = shapes::box({2, 3, 5});
  const Triangle t = mesh.triangles[3];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  EXPECT_EQ(check(mesh).duplicateTriangles, 1u);
}

TEST(Solidity, FindsASolidThatIsInsideOut) {
  const SolidityReport report = check(shapes::insideOut(shapes::box({2, 3, 5})));
  EXPECT_NEAR(report.volumeMm3, -30, 1e-9);
  EXPECT_FALSE(report.solid());
  EXPECT_THAT(wordsOf(report), testing::ElementsAre("inside out: its volume is -30 mm³"));
}

TEST(Solidity, FindsCrossingPartsOfAShellAmongTheSuspectsOnly) {
  const Mesh mesh = shapes::tangledSphere();
  const SolidityReport all = check(mesh);
  EXPECT_EQ(all.selfIntersections, 5u);
  EXPECT_EQ(all.selfIntersectionAt, crossingPoint(mesh, findSelfIntersections(mesh)->front()));
  EXPECT_FALSE(all.solid());
  std::vector<std::uint32_t> apart;  // the lower half; the tangle is in the upper one
  const double tangleZ = mesh.positions[100].z;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.corner(t, 0).z * tangleZ < 0 && std::abs(mesh.corner(t, 0).z - tangleZ) > 5) apart.push_back(t);
  ASSERT_FALSE(apart.empty());
  EXPECT_EQ(check(mesh, apart).selfIntersections, 0u);
}

TEST(Solidity, AcceptsShellsThatOverlap) {
  const Mesh mesh = shapes::together(shapes::box({2, 2, 2}), shapes::translated(shapes::box({1, 1, 4}), {0.1, 0.2, 0}));
  EXPECT_TRUE(check(mesh).solid());
}

TEST(Solidity, ReportsThePlaceOfTheFirstOfEach) {
  const auto near = [](const SolidityReport& report, const char* problem, Vec3 at) {
    const auto findings = report.findings();
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(sentence(findings[0].message), problem);
    ASSERT_TRUE(findings[0].at);
    EXPECT_NEAR(glm::length(*findings[0].at - at), 0, 1e-6);
  };
  const auto middle = [](const Mesh& mesh, std::size_t t) {
    return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
  };
  Mesh mesh = shapes::box({2, 3, 5});
  mesh.triangles.push_back({mesh.triangles[3][1], mesh.triangles[3][2], mesh.triangles[3][0]});
  const auto doubled = check(mesh).findings();
  const auto duplicate = std::find_if(doubled.begin(), doubled.end(), [](const SolidityFinding& f) {
    return f.message == message<"solid-duplicate-triangles">(with::count<"count">(1));
  });
  ASSERT_NE(duplicate, doubled.end());
  EXPECT_NEAR(glm::length(*duplicate->at - middle(mesh, 3)), 0, 1e-6);

  mesh = shapes::icosphere(10, 2);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const auto turned = check(mesh).findings();
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_LT(glm::length(*turned[0].at - middle(mesh, 5)), 5);  // the triangle itself or a neighbour

  mesh = shapes::icosphere(10, 2);
  const Vec3 hole = middle(mesh, 7);
  mesh.triangles.erase(mesh.triangles.begin() + 7);
  const auto open = check(mesh).findings();
  ASSERT_EQ(open.size(), 1u);
  EXPECT_LT(glm::length(*open[0].at - hole), 3);

  mesh = shapes::together(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {2, 2, 2}));
  std::uint32_t count = 0;
  while (mesh.positions[count] != Vec3f(1, 1, 1)) ++count;
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t)
      if (mesh.positions[v] == Vec3f(1, 1, 1)) v = count;
  near(check(mesh), "1 vertex where parts touch in a point only", {1, 1, 1});
}

TEST(Solidity, ReportsAnEmptyMesh) {
  const SolidityReport report = check(Mesh{});
  EXPECT_FALSE(report.solid());
  EXPECT_THAT(wordsOf(report), testing::ElementsAre("no triangle"));
}

}  // namespace
}  // namespace qrelief
