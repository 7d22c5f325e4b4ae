// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_model.h"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "base/random.h"
#include "io/read_model.h"
#include "mesh/prepare.h"
#include "messages/sentences.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using ::testing::HasSubstr;

struct Kind {
  ModelFormat format;
  bool ascii;
  const char* name;
};
constexpr Kind kKinds[] = {{ModelFormat::Stl, false, "a.stl"},
                           {ModelFormat::Stl, true, "a.stl"},
                           {ModelFormat::Obj, false, "a.obj"},
                           {ModelFormat::Ply, false, "a.ply"},
                           {ModelFormat::ThreeMf, false, "a.3mf"}};

void expectSameTriangles(const PolygonSoup& soup, const Mesh& mesh, const Kind& kind) {
  ASSERT_EQ(soup.triangles.size(), mesh.triangles.size()) << kind.name << kind.ascii;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_EQ(Vec3f(soup.positions[soup.triangles[t][k]]), mesh.positions[mesh.triangles[t][k]])
          << kind.name << kind.ascii << ", triangle " << t;
}

TEST(WriteModel, KeepsEveryFloatBitForBit) {
  // Random floats cover every magnitude; the hard ones are added.
  Random random(7);
  Mesh mesh;
  const auto anyFloat = [&] {
    for (;;) {
      const auto bits = static_cast<std::uint32_t>(random.next() >> 32);
      float value;
      std::memcpy(&value, &bits, sizeof(value));
      if (std::isfinite(value)) return value;
    }
  };
  for (int i = 0; i < 30'000; ++i) mesh.positions.emplace_back(anyFloat(), anyFloat(), anyFloat());
  using Limits = std::numeric_limits<float>;
  mesh.positions.emplace_back(Limits::denorm_min(), Limits::max(), -Limits::min());
  mesh.positions.emplace_back(0.1f, 1.0f / 3, 16777216.0f);
  mesh.positions.emplace_back(9007199254740992.0f, 1e-5f, -1e10f);
  for (std::uint32_t v = 0; v + 2 < mesh.positions.size(); v += 3) mesh.triangles.push_back({v, v + 1, v + 2});
  for (const Kind& kind : kKinds) {
    const auto bytes = writeModel(mesh, kind.format, {.ascii = kind.ascii});
    ASSERT_TRUE(bytes);
    const auto soup = readModel(*bytes, kind.name);
    ASSERT_TRUE(soup) << soup.error().message;
    expectSameTriangles(*soup, mesh, kind);
  }
}

TEST(WriteModel, KeepsTheSolidInEveryFormat) {
  const Mesh mesh = shapes::bumpySphere(40, 3, 5, 4);
  for (const Kind& kind : kKinds) {
    const auto soup = readModel(*writeModel(mesh, kind.format, {.ascii = kind.ascii}), kind.name);
    ASSERT_TRUE(soup) << soup.error().message;
    EXPECT_TRUE(soup->warnings.empty()) << soup->warnings.front();
    const auto model = prepareModel(*soup, {});
    ASSERT_TRUE(model);
    EXPECT_TRUE(model->findings.empty()) << kind.name;
    EXPECT_EQ(model->mesh.positions.size(), mesh.positions.size()) << kind.name;
    EXPECT_EQ(signedVolume(model->mesh), signedVolume(mesh)) << kind.name;
  }
}

TEST(WriteModel, WritesObjectsOneAfterTheOther) {
  const Mesh box = shapes::box({1, 2, 3});
  const Mesh ball = shapes::translated(shapes::icosphere(5, 1), {20, 0, 0});
  const std::vector<ModelObject> objects = {{"a box", {{"", box, {}}}}, {"a\nball\\", {{"", ball, {}}}}};
  for (const Kind& kind : kKinds) {
    const auto soup = readModel(*writeModel(objects, kind.format, {.ascii = kind.ascii}), kind.name);
    ASSERT_TRUE(soup) << kind.name << ": " << soup.error().message;
    expectSameTriangles(*soup, shapes::together(box, ball), kind);
    EXPECT_TRUE(soup->warnings.empty());
  }
}

TEST(WriteModel, DoesNotReadATitleAsContent) {
  for (const Kind& kind : kKinds)
    for (const char* title : {"facet\nvertex 1 2 3", "solid\\", "end_header\nx", "v 1 2 3", "<a>&\"\xff\x01"}) {
      const auto bytes = writeModel(shapes::box({1, 2, 3}), kind.format, {.title = title, .ascii = kind.ascii});
      const auto soup = readModel(*bytes, kind.name);
      ASSERT_TRUE(soup) << kind.name << ", " << title << ": " << soup.error().message;
      expectSameTriangles(*soup, shapes::box({1, 2, 3}), kind);
      EXPECT_TRUE(soup->warnings.empty());
    }
}

TEST(WriteModel, WritesEveryWritableFormat) {
  for (const Kind& kind : kKinds) EXPECT_TRUE(isWritable(kind.format)) << kind.name;
}

TEST(WriteModel, RefusesUnsupportedFormats) {
  for (const ModelFormat format : {ModelFormat::Off, ModelFormat::Gltf, ModelFormat::Unknown}) {
    EXPECT_FALSE(isWritable(format)) << nameOf(format);
    const auto bytes = writeModel(shapes::box({1, 2, 3}), format);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().kind, ErrorKind::BadUsage);
    EXPECT_THAT(hint(bytes.error().message), HasSubstr(".3mf"));
  }
}

TEST(WriteModel, RefusesAsciiForFormatsWithoutThatChoice) {
  for (const ModelFormat format : {ModelFormat::Obj, ModelFormat::Ply, ModelFormat::ThreeMf})
    EXPECT_EQ(writeModel(shapes::box({1, 2, 3}), format, {.ascii = true}).error().kind, ErrorKind::BadUsage);
}

TEST(WriteModel, RefusesSeveralBodiesInFormatsThatHoldOneSurface) {
  const Mesh box = shapes::box({1, 2, 3});
  const std::vector<ModelObject> objects = {{"", {{"body", box, {}}, {"inlay", box, {}}}}};
  for (const ModelFormat format : {ModelFormat::Stl, ModelFormat::Ply}) {
    const auto bytes = writeModel(objects, format);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().kind, ErrorKind::BadUsage);
    EXPECT_THAT(hint(bytes.error().message), HasSubstr("3MF"));
  }
  for (const ModelFormat format : {ModelFormat::Obj, ModelFormat::ThreeMf}) EXPECT_TRUE(writeModel(objects, format));
  std::vector<ModelObject> painted = {{"", {{"body", box, Colour{1, 2, 3}}}}};
  painted[0].bodies[0].paint = FacetPaint{{4, 5, 6}, {0}};
  EXPECT_EQ(writeModel(painted, ModelFormat::Obj).error().kind, ErrorKind::BadUsage);  // no file with the colours
  EXPECT_TRUE(writeModel(painted, ModelFormat::Obj, {.materialFile = "x.mtl"}));
}

TEST(WriteModel, WritesAnAsciiStlThatStartsAndEndsWithItsName) {
  const auto bytes = writeModel(shapes::tetrahedron(1), ModelFormat::Stl, {.title = "a name", .ascii = true});
  const std::string text(bytes->begin(), bytes->end());
  EXPECT_TRUE(text.starts_with("solid a name\nfacet normal "));
  EXPECT_TRUE(text.ends_with("endfacet\nendsolid a name\n"));
}

TEST(ObjectsOf, KeepsASingleMeshUnchanged) {
  const Mesh box = shapes::box({1, 2, 3});
  const std::vector<std::string> names = {"box"};
  const auto objects = objectsOf(box, {}, names);
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].name, "box");
  EXPECT_EQ(objects[0].bodies.at(0).mesh.triangles, box.triangles);
}

TEST(ObjectsOf, SplitsPartsAndOmitsEmptyOnes) {
  const Mesh box = shapes::box({1, 2, 3});
  const Mesh ball = shapes::icosphere(5, 1);
  const Mesh both = shapes::together(box, ball);
  std::vector<std::uint32_t> partOf(box.triangles.size(), 2);
  partOf.resize(both.triangles.size(), 0);
  const std::vector<std::string> names = {"ball", "nothing", "box"};
  const auto objects = objectsOf(both, partOf, names);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].name, "ball");
  EXPECT_EQ(objects[0].bodies.at(0).mesh.positions, ball.positions);
  EXPECT_EQ(objects[0].bodies.at(0).mesh.triangles, ball.triangles);
  EXPECT_EQ(objects[1].name, "box");
  EXPECT_EQ(objects[1].bodies.at(0).mesh.positions, box.positions);
  EXPECT_EQ(objects[1].bodies.at(0).mesh.triangles, box.triangles);
}

TEST(ObjectsOf, GivesSharedPositionsToBothParts) {
  const Mesh box = shapes::box({1, 2, 3});
  std::vector<std::uint32_t> partOf(12, 0);
  std::fill(partOf.begin() + 6, partOf.end(), 1);
  const auto objects = objectsOf(box, partOf, {});
  ASSERT_EQ(objects.size(), 2u);
  for (std::size_t t = 0; t < 12; ++t)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(objects[t / 6].bodies[0].mesh.corner(t % 6, k), box.corner(t, k));
}

}  // namespace
}  // namespace qrelief
