// SPDX-License-Identifier: GPL-3.0-or-later
#include "delivery/carved_objects.h"

#include <cmath>
#include <gtest/gtest.h>

#include "pipeline/engrave.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

const std::vector<std::string> kNames = {"left", "nothing", "right"};

/// Returns the corners of every triangle, bit for bit, regardless of which vertices they share.
std::vector<Vec3f> cornersOf(const Mesh& mesh) {
  std::vector<Vec3f> corners;
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle) corners.push_back(mesh.positions[v]);
  return corners;
}

void expectSameMesh(const Mesh& actual, const Mesh& expected) {
  EXPECT_EQ(actual.positions, expected.positions);
  EXPECT_EQ(actual.triangles, expected.triangles);
}

/// Returns a result as if the right one of two boxes had been carved. The part between them has no triangle.
EngraveResult twoBoxes() {
  EngraveResult result;
  result.mesh = shapes::together(shapes::box({1, 2, 3}), shapes::translated(shapes::box({4, 4, 4}), {10, 0, 0}));
  result.mesh.bodyOf.assign(12, 0);
  result.mesh.bodyOf.resize(24, 1);
  result.bodies = {{"", 0}, {"", 2}};
  result.carvedBody = 1;
  return result;
}

TEST(CarvedObjects, EveryPartIsANamedObjectWithoutColour) {
  const std::vector<ModelObject> objects = carvedObjects(twoBoxes(), kNames, true, true);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].name, "left");
  EXPECT_EQ(objects[1].name, "right");
  for (const ModelObject& object : objects) {
    ASSERT_EQ(object.bodies.size(), 1u);
    EXPECT_FALSE(object.bodies[0].colour);
  }
  expectSameMesh(objects[0].bodies[0].mesh, shapes::box({1, 2, 3}));
  expectSameMesh(objects[1].bodies[0].mesh, shapes::translated(shapes::box({4, 4, 4}), {10, 0, 0}));
}

TEST(CarvedObjects, TheInlayIsTheSecondBodyOfTheCarvedObjectInAnotherColour) {
  EngraveResult result = twoBoxes();
  result.inlay = shapes::translated(shapes::box({1, 1, 1}), {10, 0, 1.5});
  for (const std::uint32_t carved : {0u, 1u}) {
    result.carvedBody = carved;
    const std::vector<ModelObject> objects = carvedObjects(result, kNames, true, true);
    ASSERT_EQ(objects.size(), 2u);
    const ModelObject& whole = objects[carved == 0 ? 1 : 0];
    EXPECT_EQ(whole.bodies.size(), 1u);
    EXPECT_FALSE(whole.bodies[0].colour);
    const ModelObject& object = objects[carved == 0 ? 0 : 1];
    EXPECT_EQ(object.name, kNames[carved == 0 ? 0 : 2]);
    ASSERT_EQ(object.bodies.size(), 2u);
    expectSameMesh(object.bodies[1].mesh, *result.inlay);
    EXPECT_EQ(object.bodies[1].name, "QR code");
    EXPECT_EQ(object.bodies[0].material, "Model");
    EXPECT_EQ(object.bodies[1].material, "QR code");
    ASSERT_TRUE(object.bodies[0].colour && object.bodies[1].colour);
    EXPECT_NE(*object.bodies[0].colour, *object.bodies[1].colour);
  }
}

TEST(CarvedObjects, OmitsAnUnrequestedInlay) {
  EngraveResult result = twoBoxes();
  result.inlay = shapes::box({1, 1, 1});
  for (const ModelObject& object : carvedObjects(result, kNames, false, true)) {
    ASSERT_EQ(object.bodies.size(), 1u);
    EXPECT_FALSE(object.bodies[0].colour);
  }
}

TEST(CarvedObjects, AModelOfOnePartIsOneUnchangedObject) {
  EngraveResult result;
  result.mesh = shapes::icosphere(10, 2);
  result.inlay = shapes::box({1, 1, 1});
  const std::vector<ModelObject> objects = carvedObjects(result, {}, true, true);
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].name, "");
  ASSERT_EQ(objects[0].bodies.size(), 2u);
  expectSameMesh(objects[0].bodies[0].mesh, result.mesh);
}

TEST(CarvedObjects, PaintsTheCarvedPart) {
  EngraveResult result;
  result.mesh = shapes::together(shapes::box({5, 6, 7}), shapes::translated(shapes::box({5, 6, 7}), {100, 0, 0}));
  for (std::uint32_t t = 0; t < 24; ++t) result.mesh.bodyOf.push_back(t < 12 ? 0 : 1);
  result.bodies = {{"", 0}, {"", 1}};
  result.carvedBody = 1;
  result.painted = {12, 15, 23};
  const std::vector<ModelObject> objects = carvedObjects(result, {}, false, true);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_FALSE(objects[0].bodies[0].paint);
  ASSERT_TRUE(objects[1].bodies[0].paint);
  EXPECT_EQ(objects[1].bodies[0].paint->triangles, (std::vector<std::uint32_t>{0, 3, 11}));
  EXPECT_NE(objects[1].bodies[0].paint->colour, objects[1].bodies[0].colour);
}

/// Returns a result as if the second of two touching bodies of one object had been carved.
EngraveResult twoBodiesOfOneObject(bool areShells) {
  EngraveResult result = twoBoxes();
  result.bodies = {{"base", 0, areShells}, {"top", 0, areShells}};
  return result;
}

TEST(CarvedObjects, KeepTheBodiesOfAnObjectApart) {
  const std::vector<ModelObject> objects = carvedObjects(twoBodiesOfOneObject(false), kNames, true, true);
  ASSERT_EQ(objects.size(), 1u);
  ASSERT_EQ(objects[0].bodies.size(), 2u);
  EXPECT_EQ(objects[0].bodies[0].name, "base");
  EXPECT_EQ(objects[0].bodies[1].name, "top");
  expectSameMesh(objects[0].bodies[0].mesh, shapes::box({1, 2, 3}));
}

TEST(CarvedObjects, JoinTheBodiesOfAnObjectForFormatsThatHoldOne) {
  const EngraveResult result = twoBodiesOfOneObject(false);
  const std::vector<ModelObject> objects = carvedObjects(result, kNames, true, false);
  ASSERT_EQ(objects.size(), 1u);
  ASSERT_EQ(objects[0].bodies.size(), 1u);
  expectSameMesh(objects[0].bodies[0].mesh, result.mesh);
}

TEST(CarvedObjects, KeepTheShellsOfAFileWithoutBodiesTogether) {
  const EngraveResult result = twoBodiesOfOneObject(true);
  const std::vector<ModelObject> objects = carvedObjects(result, {}, true, true);
  ASSERT_EQ(objects.size(), 1u);
  ASSERT_EQ(objects[0].bodies.size(), 1u);
  expectSameMesh(objects[0].bodies[0].mesh, result.mesh);
}

class CarvedObjectsOfAnEngravedModel : public GlTest {};

/// Case with a small cube and, later in the file, a ball that takes the code.
TEST_F(CarvedObjectsOfAnEngravedModel, KeepTheOtherObjectBitForBitAndFillThePockets) {
  const Mesh cube = shapes::translated(shapes::box({5, 6, 7}), {100, 0, 0}), ball = shapes::icosphere(40, 4);
  PolygonSoup soup = shapes::soupOf(shapes::together(cube, ball));
  soup.parts = {{"cube", 0}, {"ball", 12}};
  soup.bodies = {{"cube", 0}, {"ball", 1}};
  soup.bodyOf.assign(12, 0);
  soup.bodyOf.resize(soup.triangles.size(), 1);
  auto prepared = prepareModel(soup, {});
  ASSERT_TRUE(prepared) << prepared.error().message;
  EngraveRequest request;
  request.code.text = "x";
  request.placement.centreMm = {0, 0, 40};
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 25;
  request.marking.mark = Mark::Inlay;
  const auto result = engrave(EngravableModel::upload(std::move(*prepared)), request);
  ASSERT_TRUE(result) << result.error().message;

  const std::vector<ModelObject> objects = carvedObjects(*result, std::vector<std::string>{"cube", "ball"}, true, true);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].name, "cube");
  EXPECT_EQ(objects[1].name, "ball");
  ASSERT_EQ(objects[0].bodies.size(), 1u);
  EXPECT_EQ(cornersOf(objects[0].bodies[0].mesh), cornersOf(cube));
  ASSERT_EQ(objects[1].bodies.size(), 2u);
  const Mesh &carved = objects[1].bodies[0].mesh, &inlay = objects[1].bodies[1].mesh;
  for (const Mesh* body : {&carved, &inlay}) {
    const auto solidity = checkSolidity(*body);
    ASSERT_TRUE(solidity);
    EXPECT_TRUE(solidity->solid()) << testing::PrintToString(solidity->problems());
  }
  // The surface over the pockets is the ball's, up to the rounding of new corners to floats.
  EXPECT_NEAR((signedVolume(carved) + signedVolume(inlay)) / signedVolume(ball), 1, 1e-6);
  double depths = 0;
  for (int row = 0; row < result->depths.size; ++row)
    for (int column = 0; column < result->depths.size; ++column) depths += result->depths.depth(row, column);
  const double pockets = depths * std::pow(25.0 / result->depths.size, 2);
  EXPECT_NEAR(signedVolume(inlay) / pockets, 1, 0.05);  // the ball curves away from the plane of the squares
}

}  // namespace
}  // namespace qrelief
