// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/prepare.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/self_intersection.h"
#include "message_codes/model.h"
#include "messages/sentences.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using ::testing::HasSubstr;
using Severity = Finding::Severity;

PreparedModel prepared(const Mesh& mesh, double scale = 1) {
  auto model = prepareModel(shapes::soupOf(mesh), {.scaleToMm = scale});
  EXPECT_TRUE(model) << model.error().message;
  return std::move(*model);
}

const Finding* find(const PreparedModel& model, std::string_view code) {
  for (const Finding& finding : model.findings)
    if (finding.message.code == code) return &finding;
  return nullptr;
}

/// Returns a finding's count; 1 if it has none.
double countIn(const Message& message) {
  for (const MessageValue& value : message.values) {
    if (value.name == "count") return value.numbers[0];
    if (value.name == "pairs") return countIn(value.cause.front());
  }
  return 1;
}

void expectFinding(const PreparedModel& model, std::string_view code, Severity severity, std::size_t count) {
  const Finding* finding = find(model, code);
  ASSERT_TRUE(finding) << code;
  EXPECT_EQ(finding->severity, severity);
  EXPECT_EQ(countIn(finding->message), static_cast<double>(count));
  EXPECT_EQ(sentence(finding->message).find('{'), std::string::npos) << sentence(finding->message);
  if (severity == Severity::Note) {
    EXPECT_EQ(hint(finding->message), "");
  }
  if (severity == Severity::Blocking) {
    EXPECT_NE(hint(finding->message), "");
  }
  EXPECT_EQ(model.engravable().has_value(), severity != Severity::Blocking);
}

std::string wordsOf(const PreparedModel& model, std::string_view code) { return sentence(find(model, code)->message); }
std::string hintOf(const PreparedModel& model, std::string_view code) { return hint(find(model, code)->message); }

Message refusalOf(const Mesh& mesh, double scale = 1) {
  const auto model = prepareModel(shapes::soupOf(mesh), {.scaleToMm = scale});
  EXPECT_FALSE(model);
  return model ? Message{} : model.error().message;
}

/// Returns the soup that an STL reader would return: every triangle has its own corners.
PolygonSoup loose(const Mesh& mesh) {
  PolygonSoup soup;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (int k = 0; k < 3; ++k) soup.positions.push_back(mesh.corner(t, k));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TEST(PrepareModel, WeldsLooseTrianglesIntoAClosedSolid) {
  const Mesh mesh = shapes::icosphere(20, 2);
  const auto model = prepareModel(loose(mesh), {});
  ASSERT_TRUE(model);
  EXPECT_EQ(model->mesh.positions.size(), mesh.positions.size());
  EXPECT_TRUE(model->findings.empty());
  EXPECT_TRUE(model->engravable());
  EXPECT_EQ(model->shells, 1u);
  EXPECT_EQ(model->normals.size(), model->mesh.positions.size());
  EXPECT_EQ(model->adjacency, buildAdjacency(model->mesh.triangles));
}

TEST(PrepareModel, LeavesAWeldedCleanModelBitForBit) {
  const Mesh mesh = shapes::bumpySphere(50, 3, 4, 3);
  const PreparedModel model = prepared(mesh);
  EXPECT_EQ(model.mesh.positions, mesh.positions);
  EXPECT_EQ(model.mesh.triangles, mesh.triangles);
}

TEST(PrepareModel, ScalesToMillimetresInDoublesAndRoundsOnce) {
  PolygonSoup soup = shapes::soupOf(shapes::box({2, 2, 2}));
  for (Vec3& p : soup.positions) p *= 0.1;
  const auto model = prepareModel(soup, {.scaleToMm = 1000});
  ASSERT_TRUE(model);
  EXPECT_EQ(model->mesh.positions[0], Vec3f(-100));
}

TEST(PrepareModel, BlocksAnOpenSurfaceAndNamesAPlaceInFileUnits) {
  Mesh mesh = shapes::box({2, 2, 2});
  mesh.triangles.resize(10);  // without the face x = 1
  const PreparedModel model = prepared(mesh, 10);
  expectFinding(model, "open-edges", Severity::Blocking, 4);
  EXPECT_THAT(wordsOf(model, "open-edges"), HasSubstr("4 open edges, one at (1, "));
  EXPECT_THAT(wordsOf(model, "open-edges"), HasSubstr("(holes or gaps: 1)"));
  EXPECT_EQ(model.engravable().error().kind, ErrorKind::BadInput);
  EXPECT_EQ(model.engravable().error().message, model.findings.front().message);
}

TEST(PrepareModel, BlocksASurfaceThatIsNotWeldable) {
  PolygonSoup soup = loose(shapes::box({10, 10, 10}));
  for (std::size_t i = 0; i < soup.positions.size(); ++i) soup.positions[i].x += 1e-2 * static_cast<double>(i);
  expectFinding(*prepareModel(soup, {}), "open-edges", Severity::Blocking, 36);
}

TEST(PrepareModel, WeldsNearlyTouchingTrianglesAndReportsTheirMovement) {
  const Mesh box = shapes::box({10, 10, 10});  // the automatic tolerance, 1/100000 of the diagonal, is 0.00017 mm
  PolygonSoup soup = loose(box);
  for (std::size_t i = 0; i < soup.positions.size(); ++i) soup.positions[i].x += 1e-6 * static_cast<double>(i);
  const auto model = prepareModel(soup, {});
  ASSERT_TRUE(model);
  expectFinding(*model, "welded-vertices", Severity::Warning, 28);
  EXPECT_THAT(wordsOf(*model, "welded-vertices"), HasSubstr("within 0.000173 mm of others"));
  EXPECT_EQ(model->mesh.positions.size(), 8u);
  EXPECT_TRUE(model->engravable());
  EXPECT_FALSE(prepareModel(soup, {.repair = {.weldNear = false}})->engravable());
  EXPECT_FALSE(prepareModel(soup, {.repair = {.weldToleranceMm = 0}})->engravable());
}

TEST(PrepareModel, FillsASmallHoleAndReportsItsPlace) {
  Mesh mesh = shapes::icosphere(10, 3);
  mesh.triangles.erase(mesh.triangles.begin() + 5);
  const PreparedModel model = prepared(mesh);
  expectFinding(model, "holes-filled", Severity::Warning, 1);
  EXPECT_THAT(wordsOf(model, "holes-filled"), HasSubstr("1 hole was filled, 1."));
  EXPECT_EQ(model.findings.size(), 1u);
  EXPECT_NEAR(signedVolume(model.mesh), signedVolume(shapes::icosphere(10, 3)), 1e-9);
}

TEST(PrepareModel, RefusesALargeOpeningAndReportsItsSize) {
  Mesh mesh = shapes::box({10, 10, 10});
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.positions[v].z > 0; });
  });
  const PreparedModel model = prepared(mesh);
  expectFinding(model, "large-openings", Severity::Blocking, 1);
  EXPECT_THAT(wordsOf(model, "large-openings"), HasSubstr("it is 14.1 mm across, has 4 edges"));
  EXPECT_EQ(model.engravable().error().message, find(model, "large-openings")->message);
  const auto filled = prepareModel(shapes::soupOf(mesh), {.repair = {.maxHoleMm = 15}});
  EXPECT_TRUE(filled->engravable());
  EXPECT_NEAR(signedVolume(filled->mesh), 1000, 1e-9);
}

TEST(PrepareModel, BlocksFaultsWhoseRepairIsSwitchedOff) {
  Mesh stray = shapes::box({10, 10, 10});
  stray.triangles.push_back(stray.triangles[0]);
  stray.triangles.push_back({0, 0, 1});
  Mesh turned = shapes::box({10, 10, 10});
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  const RepairOptions none = RepairOptions::none();
  expectFinding(*prepareModel(shapes::soupOf(stray), {.repair = none}), "duplicate-triangles", Severity::Blocking, 1);
  expectFinding(*prepareModel(shapes::soupOf(stray), {.repair = none}), "degenerate-triangles", Severity::Blocking, 1);
  expectFinding(*prepareModel(shapes::soupOf(turned), {.repair = none}), "misoriented-triangles", Severity::Blocking,
                1);
  expectFinding(*prepareModel(shapes::soupOf(shapes::insideOut(shapes::box({10, 10, 10}))), {.repair = none}),
                "inside-out", Severity::Blocking, 1);
}

TEST(PrepareModel, KeepsCrossingsOnRequest) {
  const Mesh mesh = shapes::tangledSphere();
  const auto model = prepareModel(shapes::soupOf(mesh), {.repair = {.untangle = false}});
  expectFinding(*model, "self-intersections", Severity::Warning, 5);
  EXPECT_EQ(model->mesh.positions, mesh.positions);
  EXPECT_EQ(model->crossings, *findCrossings(model->mesh));
}

TEST(PrepareModel, ReportsTooManyShellsToFindCavities) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 4001; ++i) {
    const Vec3f at(static_cast<float>(i % 100), static_cast<float>(i / 100), 0);
    const Vec3f a(0.5f, 0, 0), b(0, 0.5f, 0), c(0, 0, 0.5f);
    mesh.positions.insert(mesh.positions.end(), {at, at + a, at + b, at + c});
    const std::uint32_t v = 4 * i;
    mesh.triangles.insert(mesh.triangles.end(),
                          {{v, v + 2, v + 1}, {v, v + 1, v + 3}, {v + 1, v + 2, v + 3}, {v + 2, v, v + 3}});
  }
  expectFinding(prepared(mesh), "nesting-not-found", Severity::Note, 4001);
}

TEST(PrepareModel, ReportsThatNotAllOpenEdgesWereCompared) {
  Mesh mesh = shapes::box({10, 10, 10});
  for (std::uint32_t i = 0; i < 12'000; ++i) {
    const auto v = static_cast<std::uint32_t>(mesh.positions.size());
    const float at = static_cast<float>(i) * 1e-8f;
    mesh.positions.insert(mesh.positions.end(), {{at, 0, 0}, {0, at + 1e-5f, 0}, {0, 0, at + 1e-5f}});
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  const PreparedModel model = prepared(mesh);
  const Finding* finding = find(model, "seams-too-crowded");
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, Severity::Warning);
  EXPECT_NE(hint(finding->message), "");
}

TEST(PrepareModel, RefusesAnInvalidTolerance) {
  for (const double mm : {-1.0, static_cast<double>(NAN)})
    EXPECT_EQ(prepareModel(shapes::soupOf(shapes::box({1, 1, 1})), {.repair = {.weldToleranceMm = mm}}).error().kind,
              ErrorKind::BadUsage);
}

TEST(PrepareModel, BlocksEdgesOfThreeTriangles) {
  Mesh mesh = shapes::box({10, 10, 10});
  mesh.positions.push_back({0, -20, 5});
  mesh.triangles.push_back({4, 8, 5});
  expectFinding(prepared(mesh), "non-manifold-edges", Severity::Blocking, 1);
}

TEST(PrepareModel, BlocksAOneSidedSurface) {
  // The projective plane on six vertices: closed, every edge in two triangles, and one-sided.
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                                        {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  Mesh mesh;
  mesh.positions = {{0, 0, 9}, {9, 0, 0}, {3, 8, 1}, {-7, 5, 2}, {-7, -5, 3}, {3, -8, 4}};
  mesh.triangles = triangles;
  expectFinding(prepared(mesh), "one-sided", Severity::Blocking, 1);
}

TEST(PrepareModel, WarnsAboutDegenerateTriangles) {
  Mesh mesh = shapes::box({10, 10, 10});
  mesh.triangles.push_back({0, 0, 1});
  const PreparedModel model = prepared(mesh);
  expectFinding(model, "degenerate-triangles", Severity::Warning, 1);
  EXPECT_THAT(wordsOf(model, "degenerate-triangles"), HasSubstr("1 triangle has no area, at (-5, -5, -5); left out"));
}

TEST(PrepareModel, WarnsAboutDuplicateTriangles) {
  Mesh mesh = shapes::box({10, 10, 10});
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.triangles.push_back(mesh.triangles[1]);
  expectFinding(prepared(mesh), "duplicate-triangles", Severity::Warning, 2);
}

TEST(PrepareModel, WarnsAboutFlippedTriangles) {
  Mesh mesh = shapes::box({10, 10, 10});
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  const PreparedModel model = prepared(mesh);
  expectFinding(model, "misoriented-triangles", Severity::Warning, 1);
  EXPECT_NEAR(signedVolume(model.mesh), 1000, 1e-9);
}

TEST(PrepareModel, WarnsAboutAShellThatWasInsideOut) {
  const PreparedModel model = prepared(shapes::insideOut(shapes::box({10, 10, 10})));
  expectFinding(model, "inside-out", Severity::Warning, 1);
  EXPECT_NEAR(signedVolume(model.mesh), 1000, 1e-9);
}

TEST(PrepareModel, NotesACavityAndTheNumberOfShells) {
  const PreparedModel model =
      prepared(shapes::together(shapes::box({40, 40, 40}), shapes::insideOut(shapes::box({20, 20, 20}))));
  expectFinding(model, "cavities", Severity::Note, 1);
  expectFinding(model, "several-shells", Severity::Note, 2);
  EXPECT_NEAR(signedVolume(model.mesh), 64000 - 8000, 1e-9);
}

TEST(PrepareModel, WarnsAboutASolidInsideASolid) {
  expectFinding(prepared(shapes::together(shapes::box({40, 40, 40}), shapes::box({20, 20, 20}))), "nested-solids",
                Severity::Warning, 1);
}

TEST(PrepareModel, KeepsShellsThatTouchAtAPointApart) {
  const Mesh box = shapes::box({10, 10, 10});
  const PreparedModel model = prepared(shapes::together(box, shapes::translated(box, {10, 10, 10})));
  expectFinding(model, "several-shells", Severity::Note, 2);
  EXPECT_THAT(wordsOf(model, "overlapping-shells"), HasSubstr("cross or touch, the first near (5, 5, 5)"));
  EXPECT_EQ(model.findings.size(), 2u);
  EXPECT_EQ(model.mesh.positions.size(), 16u);
}

TEST(PrepareModel, WarnsAboutAShellThatTouchesItselfAtAPoint) {
  Mesh mesh = shapes::torus(10, 3, 24, 12);
  // Pinched: a vertex of the inner side moves to the one opposite to it.
  std::uint32_t inner = 0;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    if (glm::length(mesh.positions[v]) < glm::length(mesh.positions[inner])) inner = v;
  std::uint32_t opposite = 0;
  const Vec3f wanted(-mesh.positions[inner].x, -mesh.positions[inner].y, mesh.positions[inner].z);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    if (glm::distance(mesh.positions[v], wanted) < glm::distance(mesh.positions[opposite], wanted)) opposite = v;
  mesh.positions[inner] = mesh.positions[opposite] = Vec3f(0);
  expectFinding(prepared(mesh), "non-manifold-vertices", Severity::Warning, 1);
}

TEST(PrepareModel, RepairsTinySelfIntersectionsAndReportsIt) {
  const PreparedModel model = prepared(shapes::tangledSphere(), 2);
  expectFinding(model, "self-intersections-mended", Severity::Warning, 5);
  EXPECT_THAT(wordsOf(model, "self-intersections-mended"), HasSubstr("corners moved: 1, by 0."));
  EXPECT_TRUE(findSelfIntersections(model.mesh)->empty());
  EXPECT_EQ(model.normals, vertexNormals(model.mesh));
}

TEST(PrepareModel, KeepsShellsThatOverlap) {
  const Mesh sphere = shapes::icosphere(10, 4);
  const Mesh mesh = shapes::together(sphere, shapes::translated(sphere, {7, 1, 2}));
  const PreparedModel model = prepared(mesh);
  expectFinding(model, "several-shells", Severity::Note, 2);
  const Finding* overlap = find(model, "overlapping-shells");
  ASSERT_TRUE(overlap);
  EXPECT_EQ(overlap->severity, Severity::Note);
  const std::vector<double>& at = overlap->message.values.at(1).numbers;
  for (const Vec3 centre : {Vec3(0, 0, 0), Vec3(7, 1, 2)})
    EXPECT_NEAR(glm::distance(Vec3(at[0], at[1], at[2]), centre), 10, 0.05) << "on both spheres";
  EXPECT_EQ(model.findings.size(), 2u);
  EXPECT_FALSE(model.crossesItself);
  EXPECT_EQ(model.mesh.positions, mesh.positions);
}

TEST(PrepareModel, KeepsShellsThatShareAFaceClosed) {
  const Mesh box = shapes::box({10, 10, 10});
  const Mesh mesh = shapes::together(box, shapes::translated(box, {0, 0, 10}));
  const PreparedModel model = prepared(mesh);
  expectFinding(model, "several-shells", Severity::Note, 2);
  EXPECT_TRUE(find(model, "overlapping-shells"));
  EXPECT_EQ(model.findings.size(), 2u);
  EXPECT_TRUE(shapes::isClosed(model.mesh));
  EXPECT_EQ(model.mesh.triangles.size(), mesh.triangles.size());
}

TEST(PrepareModel, KeepsShellsThatShareAnEdgeClosed) {
  const Mesh box = shapes::box({10, 10, 10});
  const PreparedModel model = prepared(shapes::together(box, shapes::translated(box, {10, 0, 10})));
  EXPECT_TRUE(model.engravable());
  EXPECT_TRUE(shapes::isClosed(model.mesh));
}

TEST(PrepareModel, LooksForSelfIntersectionsOnlyInClosedModels) {
  Mesh mesh = shapes::tangledSphere();
  mesh.triangles.pop_back();
  const auto model = prepareModel(shapes::soupOf(mesh), {.repair = {.fillHoles = false}});
  expectFinding(*model, "open-edges", Severity::Blocking, 3);
  EXPECT_EQ(model->findings.size(), 1u);
  EXPECT_EQ(model->mesh.positions, mesh.positions);
}

TEST(PrepareModel, NotesUnusedVertices) {
  Mesh mesh = shapes::box({10, 10, 10});
  mesh.positions.insert(mesh.positions.begin(), {1e9f, 0, 0});  // unused vertices do not count towards the size
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) ++v;
  const PreparedModel model = prepared(mesh);
  expectFinding(model, "unused-vertices", Severity::Note, 1);
  EXPECT_EQ(model.mesh.positions.size(), 8u);
}

TEST(PrepareModel, WarnsAboutATinyModelAndSuggestsUnits) {
  const PreparedModel model = prepared(shapes::box({0.2, 0.1, 0.15}));
  expectFinding(model, "tiny", Severity::Warning, 1);
  EXPECT_EQ(wordsOf(model, "tiny"), "The model is tiny: 0.2 × 0.1 × 0.15 mm");
  EXPECT_EQ(hintOf(model, "tiny"),
            "If it should be larger, --units m makes it 200 × 100 × 150 mm; use --scale for any other scale");
  ASSERT_EQ(model.unitSuggestions.size(), 1u);
  EXPECT_EQ(model.unitSuggestions[0].scaleToMm, 1000);
  EXPECT_FALSE(find(prepared(shapes::box({0.2, 0.1, 0.15}), 1000), "tiny"));
}

TEST(PrepareModel, WarnsAboutAHugeModel) {
  expectFinding(prepared(shapes::box({2001, 10, 10})), "huge", Severity::Warning, 1);
  EXPECT_FALSE(find(prepared(shapes::box({2000, 10, 10})), "huge"));
  EXPECT_EQ(hintOf(prepared(shapes::box({80'000, 20'000, 20'000})), "huge"),
            "If it should be smaller, --units um makes it 80 × 20 × 20 mm; use --scale for any other scale");
}

TEST(PrepareModel, WarnsAboutAModelThatStandsOnItsYAxis) {
  Mesh pyramid;
  pyramid.positions = {{-20, 0, -20}, {20, 0, -20}, {20, 0, 20}, {-20, 0, 20}, {0, 50, 0}};
  pyramid.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  expectFinding(prepared(pyramid), "stands-on-y", Severity::Warning, 1);
  EXPECT_FALSE(find(prepared(shapes::box({20, 20, 50})), "stands-on-y"));
}

TEST(PrepareModel, WarnsIfFloatsAreTooCoarse) {
  expectFinding(prepared(shapes::translated(shapes::box({128, 128, 128}), {65536, 0, 0})), "far-away",
                Severity::Warning, 1);
}

TEST(PrepareModel, ListsBlockingFindingsFirst) {
  Mesh mesh = shapes::box({1, 1, 1});
  mesh.triangles.resize(10);
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_EQ(prepared(mesh).findings.front().severity, Severity::Blocking);
}

TEST(PrepareModel, RefusesAnImplausibleSize) {
  const auto model = prepareModel(shapes::soupOf(shapes::box({1e30, 1, 1})), {});
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().kind, ErrorKind::BadInput);
  EXPECT_THAT(sentence(model.error().message), HasSubstr("implausible"));
  EXPECT_THAT(hint(model.error().message), HasSubstr("--scale"));
  EXPECT_FALSE(prepareModel(shapes::soupOf(shapes::box({10, 10, 10})), {.scaleToMm = 1e300}));
}

TEST(PrepareModel, RefusesAModelFarFromTheOriginWithLimitAndReason) {
  const Message message = refusalOf(shapes::translated(shapes::box({8192, 8192, 8192}), {1e10, 0, 0}));
  EXPECT_EQ(message.code, "model-too-far-away");
  EXPECT_EQ(sentence(message),
            "The model lies 10000 km from the origin, where 32-bit coordinates are about 1192 mm apart; the limit is "
            "10 km");
  EXPECT_THAT(hint(message), HasSubstr("Move it to the origin"));
}

TEST(PrepareModel, RefusesCoordinatesThatAreNotFinite) {
  PolygonSoup soup = shapes::soupOf(shapes::box({10, 10, 10}));
  soup.positions[2].y = NAN;
  EXPECT_THAT(sentence(prepareModel(soup, {}).error().message), HasSubstr("Vertex 3"));
}

TEST(PrepareModel, RefusesModelsWithoutArea) {
  EXPECT_EQ(prepareModel(PolygonSoup{}, {}).error().message, message<"model-no-triangle">());
  Mesh line;
  line.positions = {{0, 0, 0}, {5, 0, 0}, {10, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_EQ(sentence(refusalOf(line)), "The model's only triangle has no area: its corners lie on a line");
  line.triangles.push_back({1, 2, 0});
  EXPECT_EQ(refusalOf(line).code, "model-no-area");
  line.triangles = {{1, 1, 1}};
  EXPECT_THAT(sentence(refusalOf(line)), HasSubstr("no size"));
}

TEST(PrepareModel, ReportsThatTheFacesOfASheetWithoutThicknessCancelOut) {
  Mesh sheet;  // 80 × 80 mm, two triangles a side
  sheet.positions = {{0, 0, 0}, {80, 0, 0}, {80, 80, 0}, {0, 80, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  const Message refusal = refusalOf(sheet);
  EXPECT_EQ(refusal, message<"model-no-thickness">(with::count<"count">(4)));
  EXPECT_EQ(sentence(refusal),
            "The model is a sheet without thickness: its 4 triangles lie in pairs back to back on the same corners, "
            "cancel each other out and enclose no volume");
  EXPECT_THAT(hint(refusal), HasSubstr("Give it a thickness"));
}

TEST(PrepareModel, ReportsAreasLostToRounding) {
  PolygonSoup soup;  // near (8192, 8192, 0) 32-bit floats are 1/1024 apart
  soup.positions = {{8192, 8192, 0}, {8192.0001, 8192, 0}, {8192, 8192.0001, 0}};
  soup.triangles = {{0, 1, 2}};
  EXPECT_EQ(prepareModel(soup, {}).error().message, message<"area-lost-in-rounding">(with::count<"count">(1)));
}

TEST(PrepareModel, RefusesAScaleThatIsNotPositive) {
  for (const double scale : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)})
    EXPECT_EQ(prepareModel(shapes::soupOf(shapes::box({1, 1, 1})), {.scaleToMm = scale}).error().kind,
              ErrorKind::BadUsage);
}

}  // namespace
}  // namespace qrelief
