// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_off.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages/sentences.h"
#include "support/model_files.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using model_files::bytesOf;
using ::testing::HasSubstr;

std::string errorOf(std::string_view text) {
  const auto soup = readOff(bytesOf(text), {});
  return soup ? "no error" : sentence(soup.error().message);
}

TEST(OffReader, ReadsVerticesAndTriangles) {
  const Mesh mesh = shapes::icosphere(3, 1);
  const auto soup = readOff(bytesOf(model_files::off(mesh)), {});
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->triangles, mesh.triangles);
  ASSERT_EQ(soup->positions.size(), mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) EXPECT_EQ(Vec3f(soup->positions[v]), mesh.positions[v]);
}

TEST(OffReader, IgnoresCommentsColoursAndNormals) {
  const auto soup =
      readOff(bytesOf("COFF # coloured\n# a square\n4 1 4\n0 0 0  255 0 0 255\n1 0 0 0 0 0\n1 1 0\n0 1 0\n"
                      "4 0 1 2 3  0.5 0.5 0.5\n"),
              {});
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->positions.size(), 4u);
  EXPECT_EQ(soup->triangles.size(), 2u);
}

TEST(OffReader, ReadsCountsOnTheFirstLine) {
  EXPECT_TRUE(readOff(bytesOf("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), {}));
}

/// Returns the number of triangles; 0 for an error.
std::size_t trianglesOf(std::string_view text) {
  const auto soup = readOff(bytesOf(text), {});
  EXPECT_TRUE(soup) << text << sentence(soup.error().message);
  return soup ? soup->triangles.size() : 0;
}

TEST(OffReader, ReadsSeveralVerticesOrFacesOnOneLine) {
  constexpr const char* kFaces[] = {"3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "3 0 2 1 3 0 1 3\n3 1 2 3 3 2 0 3\n"};
  constexpr const char* kVertices[] = {"0 0 0 1 0 0\n0 1 0 0 0 1\n", "0 0\n0 1 0\n0 0 1\n0\n0 0 1\n",
                                       "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"};
  const auto expected = readOff(bytesOf(fmt::format("OFF\n4 4 6\n{}{}", kVertices[2], kFaces[0])), {});
  ASSERT_TRUE(expected);
  for (const char* vertices : kVertices)
    for (const char* faces : kFaces) {
      const auto soup = readOff(bytesOf(fmt::format("OFF\n4 4 6\n{}{}", vertices, faces)), {});
      ASSERT_TRUE(soup) << vertices << faces << sentence(soup.error().message);
      EXPECT_EQ(soup->positions, expected->positions) << vertices << faces;
      EXPECT_EQ(soup->triangles, expected->triangles) << vertices << faces;
    }
}

TEST(OffReader, ReadsDataThatBeginOnTheLineOfTheCounts) {
  EXPECT_EQ(trianglesOf("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2"), 1u);
  EXPECT_EQ(trianglesOf("OFF\n3 1 3 0 0 0 1 0 0\n0 1 0\n3 0 1 2\n"), 1u);
  EXPECT_EQ(trianglesOf("OFF 3 1 0 of a scan\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), 1u) << "words there that are no data";
}

TEST(OffReader, ReadsCountsOnSeveralLinesAndWithoutEdges) {
  for (const char* counts : {"3\n1\n3\n", "3 1\n3\n", "3 1\n", "3\n1\n", "3 1 # no edges\n\n"})
    EXPECT_EQ(trianglesOf(fmt::format("OFF\n{}0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", counts)), 1u) << counts;
}

TEST(OffReader, ReadsFilesWithoutKeywordAndWithoutABlankAfterIt) {
  EXPECT_EQ(trianglesOf("3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), 1u);
  EXPECT_EQ(trianglesOf("OFF3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), 1u);
}

TEST(OffReader, KeepsColoursOfAPlainFileOutOfItsVertices) {
  EXPECT_EQ(trianglesOf("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2 255 0 0\n"), 1u);
}

TEST(OffReader, ReportsTheErrorOfThePlainLayout) {
  EXPECT_THAT(errorOf("OFF\n3 1 0\n0 0 0 1 0 0\n0 1 0\n3 0 1 9\n"), HasSubstr("Line 6"));
}

TEST(OffReader, NamesADecimalComma) {
  EXPECT_EQ(errorOf("OFF\n3 1 0\n0 0 0\n1,5 0 0\n0 1 0\n3 0 1 2\n"),
            "Line 4 of the OFF file: \"1,5\" has a decimal comma");
}

TEST(OffReader, NamesTheLineOfAnIndexOutOfRange) {
  EXPECT_EQ(errorOf("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "Line 6 of the OFF file: face 1 of 1: it refers to vertex 3 (counted from 0), but there are only 3");
  EXPECT_THAT(errorOf("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), HasSubstr("vertex -1"));
}

TEST(OffReader, RefusesCountsThatTheFileCannotHold) {
  EXPECT_THAT(errorOf("OFF\n4000000000 1 0\n0 0 0\n"), HasSubstr("declares 4000000000 vertices"));
  EXPECT_THAT(errorOf("OFF\n0 9223372036854775807 0\n"), HasSubstr("declares"));
  EXPECT_THAT(errorOf("OFF\n-3 1 0\n"), HasSubstr("number of vertices"));
}

TEST(OffReader, NamesTheLineWhereTheFileEnds) {
  EXPECT_THAT(errorOf("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1"), HasSubstr("Line 6 of the OFF file: face 1 of 1"));
}

TEST(OffReader, RefusesBinaryAndFourDimensionalFiles) {
  EXPECT_THAT(errorOf("OFF BINARY\n"), HasSubstr("binary"));
  EXPECT_THAT(errorOf("4OFF\n3 1 0\n"), HasSubstr("4OFF"));
}

TEST(OffReader, RefusesCoordinatesThatAreNotFinite) {
  EXPECT_THAT(errorOf("OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n"), HasSubstr("Vertex 2"));
}

TEST(OffReader, ReadsKeywordsInSmallLetters) {
  for (const std::string keyword : {"off", "Off", "coff", "noff", "cnoff", "off3"})
    EXPECT_EQ(trianglesOf(keyword + (keyword == "off3" ? "" : "\n3") + " 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), 1u)
        << keyword;
  EXPECT_THAT(errorOf("4off\n3 1 0\n"), HasSubstr("4OFF"));
  EXPECT_THAT(errorOf("nOFF\n3\n3 1 0\n"), HasSubstr("nOFF"));
  EXPECT_THAT(errorOf("off binary\n"), HasSubstr("binary"));
  EXPECT_THAT(errorOf("offer\n3 1 0\n"), HasSubstr("\"offer\" instead of \"OFF\""));
}

TEST(OffReader, RefusesAFileWithoutFaces) { EXPECT_THAT(errorOf("OFF\n1 0 0\n0 0 0\n"), HasSubstr("no face")); }

TEST(OffReader, WarnsAboutFacesWithFewerThanThreeCorners) {
  const auto soup = readOff(bytesOf("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n0\n"), {});
  ASSERT_TRUE(soup);
  EXPECT_EQ(sentence(soup->warnings.at(0)),
            "2 faces with fewer than three corners were skipped, the first is face 1 of the file");
}

TEST(OffReader, NamesTheOnlyFaceWithFewerThanThreeCorners) {
  const auto soup = readOff(bytesOf("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n"), {});
  ASSERT_TRUE(soup);
  EXPECT_EQ(sentence(soup->warnings.at(0)), "1 face with fewer than three corners was skipped, face 2 of the file");
}

TEST(OffReader, RefusesMoreCornersThanTheFileHasBytes) {
  EXPECT_EQ(errorOf("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4294967295 0 1"),
            "Line 6 of the OFF file: face 1 of 1: it declares 4294967295 corners, but only 4 bytes follow");
}

TEST(OffReader, NamesALineThatIsNotAVertex) {
  EXPECT_EQ(errorOf("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n"),
            "Line 6 of the OFF file: face 1 of 1: \"1.5\" is not a vertex");
}

}  // namespace
}  // namespace qrelief
