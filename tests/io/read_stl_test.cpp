// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_stl.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.h"
#include "io/write_stl.h"
#include "message_codes/files.h"
#include "messages/sentences.h"
#include "support/model_files.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using model_files::Bytes;
using model_files::bytesOf;
using ::testing::HasSubstr;

Bytes binaryTetrahedron() { return writeStl(shapes::tetrahedron(2)); }

void setCount(Bytes& bytes, std::uint32_t count) { std::memcpy(bytes.data() + 80, &count, 4); }

void expectSameFacets(const PolygonSoup& soup, const Mesh& mesh) {
  ASSERT_EQ(soup.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(Vec3f(soup.positions[soup.triangles[t][k]]), mesh.positions[mesh.triangles[t][k]]);
}

std::string errorOf(const Bytes& bytes) {
  const auto soup = readStl(bytes, {});
  return soup ? "no error" : sentence(soup.error().message);
}

TEST(StlReader, ReadsBinaryFacetsBitForBit) {
  const auto soup = readStl(binaryTetrahedron(), {});
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->format, "STL (binary)");
  EXPECT_TRUE(soup->warnings.empty());
  expectSameFacets(*soup, shapes::tetrahedron(2));
}

TEST(StlReader, ReadsAsciiWithEveryLineEnding) {
  for (const char* lineEnd : {"\n", "\r\n", "\r", " "}) {
    const auto soup = readStl(bytesOf(model_files::asciiStl(shapes::tetrahedron(2), lineEnd)), {});
    ASSERT_TRUE(soup) << soup.error().message;
    EXPECT_EQ(soup->format, "STL (ASCII)");
    expectSameFacets(*soup, shapes::tetrahedron(2));
  }
}

TEST(StlReader, ReadsSolidsOnOneLineWhateverTheirNames) {
  const std::string facet = "facet normal nan 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet ";
  const auto one = readStl(bytesOf("solid the facet normal to us " + facet + facet + "endsolid the facet"), {});
  ASSERT_TRUE(one) << sentence(one.error().message);
  EXPECT_EQ(one->triangles.size(), 2);
  EXPECT_TRUE(one->warnings.empty());
  const auto two = readStl(bytesOf("solid a " + facet + "endsolid a solid b " + facet + "endsolid b"), {});
  ASSERT_TRUE(two) << sentence(two.error().message);
  EXPECT_EQ(two->triangles.size(), 2) << "nothing is lost";
}

TEST(StlReader, DetectsBinaryBySizeEvenIfTheHeaderSaysSolid) {
  Bytes bytes = binaryTetrahedron();
  std::memcpy(bytes.data(), "solid facet", 11);
  const auto soup = readStl(bytes, {});
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->format, "STL (binary)");
}

TEST(StlReader, ReadsUpperCaseAndSeveralSolids) {
  std::string text = model_files::asciiStl(shapes::tetrahedron(2));
  for (char& c : text) c = static_cast<char>(std::toupper(c));
  const auto soup = readStl(bytesOf(text + text), {});
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->triangles.size(), 8u);
}

TEST(StlReader, IgnoresNormalsThatAreNotNumbers) {
  std::string text = model_files::asciiStl(shapes::tetrahedron(2));
  text.replace(text.find("normal 0 0 0"), 12, "normal nan - ?");
  EXPECT_TRUE(readStl(bytesOf(text), {}));
}

TEST(StlReader, RefusesATruncatedBinaryFileAndNamesBothSizes) {
  Bytes bytes = binaryTetrahedron();
  bytes.resize(84 + 50 * 2 + 20);
  const std::string error = errorOf(bytes);
  EXPECT_THAT(error, HasSubstr("4 facets"));
  EXPECT_THAT(error, HasSubstr("284 bytes"));
  EXPECT_THAT(error, HasSubstr("204 bytes"));
  EXPECT_THAT(error, HasSubstr("room for 2 facets"));
}

TEST(StlReader, ReadsWholeFacetsDespiteAWrongCountAndWarns) {
  for (const std::uint32_t count : {0u, 5u, 8u, 0x7fffffffu, 0xffffffffu}) {
    Bytes bytes = binaryTetrahedron();
    setCount(bytes, count);
    const auto soup = readStl(bytes, {});
    ASSERT_TRUE(soup) << sentence(soup.error().message);
    expectSameFacets(*soup, shapes::tetrahedron(2));
    ASSERT_EQ(soup->warnings.size(), 1u);
    EXPECT_EQ(soup->warnings[0], message<"stl-wrong-count">(with::count<"announced">(count), with::count<"count">(4)));
  }
}

TEST(StlReader, RefusesAFacetCountThatTheFileCannotHold) {
  for (const std::uint32_t count : {5u, 8u, 0x7fffffffu, 0xffffffffu}) {
    Bytes bytes = binaryTetrahedron();
    bytes.push_back(0);  // no whole facet at the end
    setCount(bytes, count);
    EXPECT_THAT(errorOf(bytes), HasSubstr(std::to_string(count) + " facets"));
  }
}

TEST(StlReader, RefusesZeroFacetsAndReportsTrailingBytes) {
  Bytes bytes = binaryTetrahedron();
  bytes.push_back(0);
  setCount(bytes, 0);
  EXPECT_EQ(errorOf(bytes), "The binary STL file declares 0 facets, but 201 bytes follow, room for 4 facets");
  bytes.resize(84);
  EXPECT_EQ(errorOf(bytes), "The binary STL file declares 0 facets, and none follows");
}

TEST(StlReader, ReportsThatRandomBytesAreNotStl) {
  Random random(3);
  for (const std::size_t size : {100u, 1000u, 100'000u}) {
    Bytes bytes(size);
    for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random.next() >> 56);
    setCount(bytes, 0xe1234567);
    const auto soup = readStl(bytes, {});
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().message,
              message<"stl-neither">(with::count<"announced">(0xe1234567),
                                     with::count<"expected">(84 + 50 * 0xe1234567ull), with::count<"bytes">(size)));
  }
  EXPECT_THAT(errorOf(bytesOf(std::string(300, '<'))), HasSubstr("This is not an STL file"));
}

TEST(StlReader, ReadsAsciiWithWordsAfterEndfacetAndWarnsOnce) {
  std::string text = model_files::asciiStl(shapes::tetrahedron(2));
  const std::size_t first = text.find("endfacet");
  text.insert(text.find("endfacet", first + 1) + 8, " attribute 7");
  const std::size_t line =
      1 + static_cast<std::size_t>(
              std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(" attribute")), '\n'));
  auto soup = readStl(bytesOf(text), {});
  ASSERT_TRUE(soup) << soup.error().message;
  expectSameFacets(*soup, shapes::tetrahedron(2));
  ASSERT_EQ(soup->warnings.size(), 1u);
  EXPECT_EQ(soup->warnings[0], message<"stl-words-between-facets">(with::count<"count">(1), with::index<"line">(line)));
  text.insert(text.rfind("endfacet") + 8, " attribute 7");
  soup = readStl(bytesOf(text), {});
  ASSERT_TRUE(soup) << soup.error().message;
  ASSERT_EQ(soup->warnings.size(), 1u);
  EXPECT_EQ(sentence(soup->warnings[0]),
            "Words outside the facets were ignored in 2 lines, first in line " + std::to_string(line));
}

TEST(StlReader, SkipsTextBehindTheLastSolid) {
  const std::string text = model_files::asciiStl(shapes::tetrahedron(2));
  const std::size_t lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  const auto soup = readStl(bytesOf(text + "--\nThis mail was scanned.\n"), {});
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  expectSameFacets(*soup, shapes::tetrahedron(2));
  EXPECT_EQ(soup->warnings.at(0),
            message<"stl-words-between-facets">(with::count<"count">(2), with::index<"line">(lines + 1)));
  for (const char* word : {"facet normal 0 0 1\n", "endfacet\n", "endsolid\n"})
    EXPECT_THAT(errorOf(bytesOf(text + word)), HasSubstr("instead of \"solid\"")) << word;
}

TEST(StlReader, ReadsKeywordsThatAreWrittenAsTwoWords) {
  for (const char* keyword : {"endsolid", "endfacet", "endloop"}) {
    std::string text = model_files::asciiStl(shapes::tetrahedron(2));
    for (std::size_t at = text.find(keyword); at != std::string::npos; at = text.find(keyword, at + 4))
      text.insert(at + 3, " ");
    const auto soup = readStl(bytesOf(text), {});
    ASSERT_TRUE(soup) << sentence(soup.error().message);
    expectSameFacets(*soup, shapes::tetrahedron(2));
    EXPECT_TRUE(soup->warnings.empty());
  }
}

TEST(StlReader, ReadsSolidsWithoutEndsolidBetweenThem) {
  std::string text = model_files::asciiStl(shapes::tetrahedron(2));
  text.resize(text.find("endsolid"));
  const auto soup = readStl(bytesOf(text + model_files::asciiStl(shapes::tetrahedron(2))), {});
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  EXPECT_EQ(soup->triangles.size(), 8u);
  EXPECT_EQ(soup->warnings.at(0), message<"stl-no-endsolid">());
}

TEST(StlReader, SkipsColoursBeforeTheFirstFacet) {
  std::string text = model_files::asciiStl(shapes::tetrahedron(2));
  text.insert(text.find("  facet"), "color 0.5 0.5 0.5\n");
  ASSERT_TRUE(looksLikeAsciiStl(bytesOf(text)));
  const auto soup = readStl(bytesOf(text), {});
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  expectSameFacets(*soup, shapes::tetrahedron(2));
  EXPECT_EQ(soup->warnings.at(0), message<"stl-words-between-facets">(with::count<"count">(1), with::index<"line">(2)));
}

TEST(StlReader, RefusesAFacetThatLacksItsKeyword) {
  std::string text = model_files::asciiStl(shapes::tetrahedron(2));
  text.replace(text.rfind("facet normal"), 12, "fxcet normal");
  EXPECT_THAT(errorOf(bytesOf(text)), HasSubstr("\"outer\" instead of"));
}

TEST(StlReader, WarnsAboutBytesAfterTheLastFacet) {
  Bytes bytes = binaryTetrahedron();
  bytes.resize(bytes.size() + 7);
  const auto soup = readStl(bytes, {});
  ASSERT_TRUE(soup);
  ASSERT_EQ(soup->warnings.size(), 1u);
  EXPECT_EQ(sentence(soup->warnings[0]), "7 bytes after the last of the 4 declared facets were ignored");
}

TEST(StlReader, RefusesCoordinatesThatAreNotFiniteAndNamesTheFacet) {
  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    Bytes bytes = binaryTetrahedron();
    std::memcpy(bytes.data() + 84 + 50 * 2 + 12, &bad, 4);
    EXPECT_THAT(errorOf(bytes), HasSubstr("Facet 3"));
  }
  std::string text = model_files::asciiStl(shapes::tetrahedron(2));
  text.replace(text.find("vertex "), 8, "vertex nan ");
  EXPECT_THAT(errorOf(bytesOf(text)), HasSubstr("not finite"));
}

TEST(StlReader, NamesTheLineOfAWordThatShouldBeANumber) {
  EXPECT_EQ(errorOf(bytesOf("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1,5 2 3\n")),
            "Line 4 of the STL file: \"1,5\" has a decimal comma");
  EXPECT_EQ(errorOf(bytesOf("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1;5 2 3\n")),
            "Line 4 of the ASCII STL file: \"1;5\" instead of a number");
}

TEST(StlReader, NamesTheLineWhereAnAsciiFileEnds) {
  EXPECT_EQ(errorOf(bytesOf("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 1")),
            "The ASCII STL file ends in line 5, inside facet 1, where a number should follow");
}

TEST(StlReader, RefusesAFacetOfFourCorners) {
  EXPECT_THAT(errorOf(bytesOf("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
                              "vertex 0 1 0\nendloop\nendfacet\nendsolid\n")),
              HasSubstr("Line 7"));
}

TEST(StlReader, WarnsWhenEndsolidIsMissing) {
  std::string text = model_files::asciiStl(shapes::tetrahedron(2));
  text.resize(text.find("endsolid"));
  const auto soup = readStl(bytesOf(text), {});
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->warnings.at(0), message<"stl-no-endsolid">());
}

TEST(StlReader, RefusesMoreTrianglesThanAllowed) {
  const ReadLimits limits{.maxTriangles = 3};
  EXPECT_FALSE(readStl(binaryTetrahedron(), limits));
  EXPECT_FALSE(readStl(bytesOf(model_files::asciiStl(shapes::tetrahedron(2))), limits));
}

}  // namespace
}  // namespace qrelief
