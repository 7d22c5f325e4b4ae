// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of what preparation does with the bodies and colours of a file.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/prepare.h"
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

/// Returns a soup of two bodies, as a 3MF file has them.
PolygonSoup soupOfBodies(const Mesh& first, const Mesh& second) {
  PolygonSoup soup = shapes::soupOf(shapes::together(first, second));
  soup.bodies = {{"first", 0}, {"second", 0}};
  soup.bodyOf.assign(first.triangles.size(), 0);
  soup.bodyOf.resize(soup.triangles.size(), 1);
  return soup;
}

TEST(Prepare, ColoursStayWithTheirTriangles) {
  const Mesh box = shapes::box({30, 20, 10});
  PolygonSoup soup = loose(box);
  soup.triangles.push_back(soup.triangles[0]);  // a duplicate, which is dropped
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    soup.colours.emplace_back(t % 12 < 2 ? std::optional(Colour{9, 8, 7}) : std::nullopt);
  const auto model = prepareModel(soup, {});
  ASSERT_TRUE(model);
  ASSERT_EQ(model->colours.size(), model->mesh.triangles.size());
  const Vec3 coloured = triangleNormal(box, 0);
  for (std::size_t t = 0; t < model->colours.size(); ++t)
    EXPECT_EQ(model->colours[t].has_value(), glm::dot(triangleNormal(model->mesh, t), coloured) > 0.9) << t;
  soup.colours.assign(soup.triangles.size(), Colour{1, 2, 3});
  EXPECT_TRUE(prepareModel(soup, {})->colours.empty()) << "one colour tells nothing apart";
}

TEST(PrepareModel, KeepsTheBodyOfEachTriangle) {
  Mesh box = shapes::box({10, 10, 10}), ball = shapes::translated(shapes::icosphere(5, 1), {20, 0, 0});
  box.triangles.insert(box.triangles.begin(), {0, 0, 1});  // dropped, so the triangle numbers shift
  ball.triangles.pop_back();                               // a hole, to be filled
  const PolygonSoup soup = soupOfBodies(box, ball);
  const auto model = prepareModel(soup, {.repair = {.maxHoleMm = 10}});
  ASSERT_TRUE(model && model->engravable());
  ASSERT_EQ(model->bodies.size(), 2u);
  ASSERT_EQ(model->mesh.bodyOf.size(), model->mesh.triangles.size());
  for (std::size_t t = 0; t < model->mesh.triangles.size(); ++t)
    EXPECT_EQ(model->mesh.body(t), model->mesh.corner(t, 0).x > 10 ? 1u : 0u);
}

TEST(PrepareModel, HasOneBodyWithoutNumbersOfTrianglesIfThereIsOneShell) {
  const PreparedModel model = prepared(shapes::box({10, 10, 10}));
  EXPECT_EQ(model.bodies.size(), 1u);
  EXPECT_TRUE(model.mesh.bodyOf.empty());
}

TEST(PrepareModel, KeepsBodiesThatTouchOrOverlapAsTheyAre) {
  const Mesh box = shapes::box({10, 10, 10});
  for (const Vec3 offset :
       {Vec3{0, 0, 10}, Vec3{10, 0, 10}, Vec3{10, 10, 10}, Vec3{3, 2, 10}, Vec3{3, 2, 1}, Vec3{0}}) {
    const Mesh other = shapes::translated(box, offset);
    const auto model = prepareModel(soupOfBodies(box, other), {});
    ASSERT_TRUE(model && model->engravable()) << offset.x << offset.y << offset.z;
    const Mesh both = shapes::together(box, other);
    ASSERT_EQ(model->mesh.triangles.size(), both.triangles.size());
    for (std::size_t t = 0; t < both.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) EXPECT_EQ(model->mesh.corner(t, k), both.corner(t, k));
    EXPECT_TRUE(shapes::isClosed(model->mesh));
    expectFinding(*model, "several-shells", Severity::Note, 2);
    EXPECT_TRUE(find(*model, "overlapping-shells"));
    EXPECT_EQ(model->findings.size(), 2u);
    EXPECT_FALSE(model->crossesItself);
    EXPECT_TRUE(model->hasCrossings);
    EXPECT_EQ(model->crossings, *findCrossings(model->mesh));
  }
}

TEST(PrepareModel, WeldsNoSeamBetweenBodies) {
  Mesh open = shapes::box({10, 10, 10});
  open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);
  const auto model =
      prepareModel(soupOfBodies(open, shapes::translated(open, {0, 0, 20})), {.repair = {.maxHoleMm = 100}});
  ASSERT_TRUE(model);
  expectFinding(*model, "holes-filled", Severity::Warning, 2);
}

TEST(PrepareModel, MakesABodyOfEachShellWithItsCavities) {
  const Mesh box = shapes::box({20, 20, 20}), cavity = shapes::insideOut(shapes::box({8, 8, 8}));
  const Mesh other = shapes::translated(box, {30, 0, 0});
  const PreparedModel model = prepared(shapes::together(shapes::together(box, other), cavity));
  ASSERT_EQ(model.bodies.size(), 2u);
  EXPECT_TRUE(model.bodies[0].isShell);
  ASSERT_EQ(model.mesh.bodyOf.size(), 36u);
  for (std::size_t t = 0; t < 36; ++t) EXPECT_EQ(model.mesh.body(t), t >= 12 && t < 24 ? 1u : 0u) << t;
}

TEST(PrepareModel, FindsNoCavityOfAnotherBody) {
  const auto model = prepareModel(soupOfBodies(shapes::box({20, 20, 20}), shapes::box({8, 8, 8})), {});
  ASSERT_TRUE(model && model->engravable());
  EXPECT_EQ(model->findings.size(), 1u);  // several shells: a solid within another body is no mistake
  EXPECT_GT(signedVolume(model->mesh), 8000);
}

}  // namespace
}  // namespace qrelief
