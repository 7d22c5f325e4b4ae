// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/engrave_oracle.h"

#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <numeric>

#include "support/gl_test.h"
#include "support/paths.h"
#include "support/shapes.h"
#include "support/solid_oracle.h"

// An oracle that never says no proves nothing, so these tests also show it faults that it must find.
namespace qrelief {
namespace {

using testing::HasSubstr;

std::vector<std::uint32_t> allOf(const Mesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

TEST(SolidOracle, CountsTheCrossingsOfATangledSphereOnly) {
  EXPECT_EQ(countCrossings(shapes::tangledSphere(), allOf(shapes::tangledSphere())), 5u);
  EXPECT_EQ(countCrossings(shapes::icosphere(10, 3), allOf(shapes::icosphere(10, 3))), 0u);
}

TEST(SolidOracle, DetectsMeshesThatAreNotSolid) {
  EXPECT_EQ(surfaceProblems(shapes::box({2, 2, 2})), "");
  Mesh open = shapes::box({2, 2, 2});
  open.triangles.pop_back();
  EXPECT_EQ(surfaceProblems(open), "an edge is open");
  Mesh turned = shapes::box({2, 2, 2});
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  EXPECT_EQ(surfaceProblems(turned), "two triangles run along an edge the same way");
  Mesh flat = shapes::box({2, 2, 2});
  flat.positions[0] = flat.positions[1];
  EXPECT_THAT(surfaceProblems(flat), HasSubstr("has no area"));
  Mesh touching = shapes::together(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {2, 2, 2}));
  for (Triangle& t : touching.triangles)
    for (std::uint32_t& v : t) v = v == 8 ? 7 : v;  // the corner that both boxes share
  EXPECT_THAT(surfaceProblems(touching), HasSubstr("touch in a point only"));
}

class EngraveOracle : public GlTest {
 protected:
  EngraveOracle() {
    made_.mesh = shapes::icosphere(40, 4);
    made_.request.code.text = "1";
    made_.request.depth.contrast = 0.05;
    made_.request.placement.centreMm = {0, 0, 40};
    made_.request.placement.sizeMode = SizeMode::Fixed;
    made_.request.placement.sizeMm = 20;
    model_ = EngravableModel::upload(*prepareModel(shapes::soupOf(made_.mesh), {}));
  }
  std::string faultOf(const Result<EngraveResult>& result) { return judge(made_, *model_, result).fault; }

  EngraveCase made_;
  std::shared_ptr<const EngravableModel> model_;
};

TEST_F(EngraveOracle, DetectsFalseClaimsAboutASolid) {
  const EngraveResult result = *engrave(model_, made_.request);
  EXPECT_EQ(faultOf(result), "");

  EngraveResult open = result;
  open.mesh.triangles.pop_back();
  EXPECT_EQ(faultOf(open), "an edge is open");

  EngraveResult miscounted = result;
  ++miscounted.keptTriangles;
  EXPECT_THAT(faultOf(miscounted), HasSubstr("said to be kept"));

  EngraveResult deeper = result;
  for (double& depth : deeper.depths.depthMm) depth += depth > 0 ? 0.01 : 0;
  EXPECT_THAT(faultOf(deeper), HasSubstr("mm deep, not"));

  EngraveResult larger = result;
  larger.placement.symbolMm = 70;
  EXPECT_THAT(faultOf(larger), HasSubstr("broken by the silhouette"));

  made_.request.depth.minWallMm = 79.9;
  EXPECT_THAT(faultOf(result), HasSubstr("of wall are left"));
}

TEST_F(EngraveOracle, DetectsFalseReasons) {
  const auto refused = [&](ErrorKind kind, const char* code) {
    return faultOf(tl::unexpected(Error{kind, Message(code, {})}));
  };
  EXPECT_THAT(refused(ErrorKind::NoSolution, "code-too-large"), HasSubstr("no ray contradicts it"));
  EXPECT_THAT(refused(ErrorKind::NoSolution, "modules-too-small-here"), HasSubstr("no ray contradicts it"));
  EXPECT_THAT(refused(ErrorKind::NoSolution, "centre-hidden"), HasSubstr("before the centre"));
  EXPECT_THAT(refused(ErrorKind::NoSolution, "centre-faces-away"), HasSubstr("from no direction"));
  EXPECT_THAT(refused(ErrorKind::NoSolution, "nothing-can-be-carved"), HasSubstr("to spare"));
  EXPECT_THAT(refused(ErrorKind::NoSolution, "facets-too-fine"), HasSubstr("no facet there"));
  EXPECT_THAT(refused(ErrorKind::NoSolution, "no-spot"), HasSubstr("nobody checks"));
  EXPECT_THAT(refused(ErrorKind::BadInput, "text-empty"), HasSubstr("nobody checks"));
  EXPECT_THAT(refused(ErrorKind::Internal, "no-gl-context"), HasSubstr("no typed refusal"));
}

TEST(CarvingCase, AcceptsFacetsPartlyHiddenByOneBesideTheCode) {
  // Found by fuzzing: one corner of the code lies on a facet that is partly hidden by a ridge beside the code.
  std::ifstream stream(sourceFolder() / "tests/fuzz/seeds/carve/overlapping_facets", std::ios::binary);
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
  ASSERT_EQ(bytes.size(), 122u);
  Choices choices(bytes);
  EngraveCase engraveCase = makeEngraveCase(choices);
  engraveCase.request.code.text.resize(1);
  engraveCase.request.code.symbol.version.reset();
  const OracleVerdict verdict = runCarvingCase(engraveCase, choices);
  EXPECT_EQ(verdict.kind, "solid");
  EXPECT_EQ(verdict.fault, "");
}

}  // namespace
}  // namespace qrelief
