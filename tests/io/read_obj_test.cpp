// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_obj.h"

#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "message_codes/files.h"
#include "messages/sentences.h"
#include "support/model_files.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using model_files::bytesOf;
using ::testing::HasSubstr;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Result<PolygonSoup> read(std::string_view text) { return readObj(bytesOf(text), {}); }

std::string errorOf(std::string_view text) {
  const auto soup = read(text);
  return soup ? "no error" : sentence(soup.error().message);
}

TEST(ObjReader, ReadsVerticesAndTriangles) {
  const Mesh mesh = shapes::icosphere(3, 1);
  const auto soup = read(model_files::obj(mesh));
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->format, "OBJ");
  EXPECT_EQ(soup->triangles, mesh.triangles);
  ASSERT_EQ(soup->positions.size(), mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) EXPECT_EQ(Vec3f(soup->positions[v]), mesh.positions[v]);
}

TEST(ObjReader, ReadsTheFirstVertexAfterAByteOrderMark) {
  const auto soup = read("\xEF\xBB\xBF" + kSquare + "f 1 2 3\n");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->positions.size(), 4u);
  EXPECT_EQ(soup->triangles[0], (Triangle{0, 1, 2}));
}

TEST(ObjReader, ReadsKeywordsInCapitals) {
  const auto soup = read("V 0 0 0\nV\t1 0 0\nv 1 1 0\nV 0 1 0\nVN 0 0 1\nO a\nF 1 2 3\nFO 1 3 4\n");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ObjReader, CountsNegativeIndicesFromTheVerticesReadSoFar) {
  const auto soup = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ObjReader, ReadsEveryFormOfACornerAndEveryLineEnding) {
  for (const char* lineEnd : {"\n", "\r\n", "\r"}) {
    std::string text = "mtllib a.mtl\no thing\n" + kSquare +
                       "vt 0 0\nvn 0 0 1\ng a b\nusemtl none\ns 1\nf 1/1 2/1 3/1\nf 1//1\t3//1 4//1 # comment\n"
                       "f 1/1/1 2/1/1 3/1/1\nl 1 2\np 1\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += std::strlen(lineEnd))
      text.replace(at, 1, lineEnd);
    const auto soup = read(text);
    ASSERT_TRUE(soup) << soup.error().message;
    EXPECT_EQ(soup->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
  }
}

TEST(ObjReader, JoinsContinuedLines) {
  const auto soup = read(kSquare + "f 1 2 \\\n3 \\\r\n4\n");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->triangles.size(), 2u);
}

TEST(ObjReader, JoinsLinesThatEndWithBlanksAfterTheBackslash) {
  const auto soup = read(kSquare + "f 1 2 \\ \n 3\nv 0 0 \\\t\r\n 5\n");
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  EXPECT_EQ(soup->triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(soup->positions.back(), Vec3(0, 0, 5));
}

TEST(ObjReader, ReadsVerticesWithColoursOrAFourthCoordinate) {
  const auto soup = read("v 0 0 0 1 0 0\nv 1 0 0 0.5 0.5 0.5 1\nv 0 1 0 1\nf 1 2 3\n");
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  EXPECT_EQ(soup->positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(ObjReader, AFacesColourIsTheMeanOfItsVertices) {
  const auto soup = read("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0.3 2\nf 1 2 3\n");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->colours, (std::vector<std::optional<Colour>>{Colour{255, 26, 85}}));
  const auto partly = read("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1\nf 1 2 3\n");
  ASSERT_TRUE(partly);
  EXPECT_TRUE(partly->colours.empty());
}

TEST(ObjReader, NamesADecimalComma) {
  EXPECT_EQ(errorOf("v 0 0 0\nv 1,5 0 0\nv 0 1 0\nf 1 2 3\n"), "Line 2 of the OBJ file: \"1,5\" has a decimal comma");
}

TEST(ObjReader, AcceptsFacesBeforeTheirVertices) { EXPECT_TRUE(read("f 1 2 3\n" + kSquare)); }

TEST(ObjReader, TriangulatesConcavePolygons) {
  const auto soup = read("v 0 0 0\nv 4 -1 0\nv 1 0 0\nv 4 1 0\nf 1 2 3 4\n");
  ASSERT_TRUE(soup);
  EXPECT_TRUE(soup->warnings.empty());
  EXPECT_EQ(soup->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ObjReader, ReadsAPolygonOfMoreThan255Corners) {
  std::string text;
  std::string face = "f";
  for (int i = 0; i < 300; ++i) {
    const double angle = 6.283185307 * i / 300;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  const auto soup = read(text + face + "\n");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->triangles.size(), 298u);
}

/// Returns a box's faces as OBJ, beginning at a vertex; with the box's own vertices.
std::string boxFrom(Vec3 at, int firstVertex) {
  const Mesh box = shapes::translated(shapes::box({2, 2, 2}), at);
  std::string text;
  for (const Vec3f& p : box.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const auto& [a, b, c] : box.triangles)
    text += fmt::format("f {} {} {}\n", a + firstVertex, b + firstVertex, c + firstVertex);
  return text;
}

TEST(ObjReader, MakesABodyOfEachClosedGroup) {
  const auto soup = read("o base plate\n" + boxFrom({0, 0, 0}, 1) + "  g letter\r\n" + boxFrom({0, 0, 2}, 9));
  ASSERT_TRUE(soup) << soup.error().message;
  ASSERT_EQ(soup->bodies.size(), 2u);
  EXPECT_EQ(soup->bodies[0].name, "base plate");
  EXPECT_EQ(soup->bodies[1].name, "letter");
  ASSERT_EQ(soup->bodyOf.size(), 24u);
  for (std::size_t t = 0; t < 24; ++t) EXPECT_EQ(soup->bodyOf[t], t < 12 ? 0u : 1u);
}

TEST(ObjReader, MakesOneBodyOfGroupsThatAreClosedTogether) {
  std::string box = boxFrom({0, 0, 0}, 1);
  box.insert(box.rfind("f "), "g other\n");
  const auto whole = read("g one\n" + box);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_TRUE(whole->bodies.empty());
  const auto both = read("g one\n" + box + "g closed\n" + boxFrom({5, 0, 0}, 9));
  ASSERT_TRUE(both) << both.error().message;
  ASSERT_EQ(both->bodies.size(), 2u);
  EXPECT_EQ(both->bodies[0].name, "closed");
  EXPECT_EQ(both->bodies[1].name, "");
  for (std::size_t t = 0; t < 24; ++t) EXPECT_EQ(both->bodyOf[t], t < 12 ? 1u : 0u);
}

TEST(ObjReader, FindsNoBodiesInAFileWithOneGroup) {
  const auto soup = read("o box\n" + boxFrom({0, 0, 0}, 1));
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_TRUE(soup->bodies.empty());
  EXPECT_TRUE(soup->bodyOf.empty());
}

TEST(ObjReader, NamesTheLineOfAnIndexOutOfRange) {
  EXPECT_EQ(errorOf(kSquare + "# comment\nf 1 2 3\nf 1 2 5\n"),
            "Line 7 of the OBJ file: a face refers to vertex 5, but the file has only 4");
  EXPECT_EQ(errorOf(kSquare + "f 1 2 0\n"), "Line 5 of the OBJ file: a face refers to vertex 0; OBJ counts from 1");
  EXPECT_EQ(errorOf("v 0 0 0\nv 1 0 0\nf -1 -2 -3\nv 0 0 1\n"),
            "Line 3 of the OBJ file: a face refers to vertex -3, but only 2 come before it");
  EXPECT_EQ(errorOf("v 0 0 0\nf -2 -1 -1\n"),
            "Line 2 of the OBJ file: a face refers to vertex -2, but only 1 comes before it");
  EXPECT_THAT(errorOf(kSquare + "f 1 2 99999999999999999999\n"), HasSubstr("Line 5"));
  EXPECT_THAT(errorOf(kSquare + "f 1 2 4294967298\n"), HasSubstr("vertex 4294967298"));
  EXPECT_THAT(errorOf(kSquare + "f 1 2 -9223372036854775808\n"), HasSubstr("Line 5"));
}

TEST(ObjReader, NamesTheFirstIndexOutOfRangeEvenIfLaterOnesAreLarger) {
  EXPECT_EQ(errorOf("f 1 2 9\n" + kSquare + "f 0 1 2\nf 1 2 -7\nf 1 2 x\n"),
            "Line 1 of the OBJ file: a face refers to vertex 9, but the file has only 4");
}

TEST(ObjReader, NamesTheLineOfABrokenCorner) {
  EXPECT_EQ(errorOf(kSquare + "f 1 2 x\n"), "Line 5 of the OBJ file: \"x\" is not a corner of a face");
  EXPECT_THAT(errorOf(kSquare + "f 1 2 /3\n"), HasSubstr("\"/3\""));
}

TEST(ObjReader, NamesTheLineOfABrokenVertex) {
  EXPECT_EQ(errorOf("v 0 0 0\nv 1 0\nf 1 1 1\n"), "Line 2 of the OBJ file: vertex 2: a number is missing");
  EXPECT_EQ(errorOf("v 0 0;5 0\n"), "Line 1 of the OBJ file: vertex 1: \"0;5\" is not a number");
  EXPECT_THAT(errorOf("v 0 nan 0\n"), HasSubstr("not finite"));
  EXPECT_THAT(errorOf("v 0 1e999 0\n"), HasSubstr("not finite"));
}

TEST(ObjReader, RefusesAFileWithoutVerticesOrFaces) {
  EXPECT_THAT(errorOf("hello\n"), HasSubstr("no vertex"));
  EXPECT_THAT(errorOf(kSquare), HasSubstr("no face"));
}

TEST(ObjReader, ReadsTheOldNameOfAFace) {
  const auto soup = read(kSquare + "fo 1 2 3\n \tfo\t1 3 \\\n4\n");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ObjReader, NamesCurvesAndSurfacesWithoutFaces) {
  const std::string surface = "cstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 4 3\nparm u 0 0 1 1\nparm v 0 0 1 1\nend\n";
  EXPECT_THAT(errorOf(kSquare + surface), HasSubstr("curves or exact surfaces (NURBS), but no face"));
  EXPECT_THAT(errorOf(kSquare + "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\n"), HasSubstr("NURBS"));
  EXPECT_THAT(errorOf(kSquare + "l 1 2\n"), HasSubstr("holds 4 vertices, but no face"));
  EXPECT_TRUE(read(kSquare + surface + "f 1 2 3\n"));
}

TEST(ObjReader, RefusesMoreTrianglesThanAllowed) {
  EXPECT_FALSE(readObj(bytesOf(kSquare + "f 1 2 3 4\n"), ReadLimits{.maxTriangles = 1}));
}

TEST(ObjReader, WarnsAboutSelfCrossingPolygons) {
  const auto soup = read("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 3 0\nv -1 1 0\nf 1 2 3 4 5\n");
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->warnings.at(0), message<"polygons-not-simple">(with::count<"count">(1), with::index<"face">(1),
                                                                 with::place<"at">(Vec3(0, 0, 0))));
  EXPECT_EQ(sentence(soup->warnings.at(0)),
            "1 polygon crosses itself or has no area, face 1 of the file at (0, 0, 0); it was cut into triangles "
            "anyway");
}

TEST(ObjReader, NamesTheFirstSelfCrossingPolygon) {
  const std::string crossing = "v 7 1 5\nv 9 3 5\nv 9 1 5\nv 7 4 5\nv 6 2 5\n";
  const auto soup = read(kSquare + crossing + "f 1 2 3 4\nf 5 6 7 8 9\nf 1 2 3\nf 5 6 7 8 9\n");
  ASSERT_TRUE(soup) << soup.error().message;
  ASSERT_EQ(soup->warnings.size(), 1u);
  EXPECT_THAT(sentence(soup->warnings.at(0)),
              HasSubstr("2 polygons cross themselves or have no area, the first is face 2 of the file at (7, 1, 5)"));
}

}  // namespace
}  // namespace qrelief
