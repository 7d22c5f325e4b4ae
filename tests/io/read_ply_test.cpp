// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_ply.h"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages/sentences.h"
#include "support/model_files.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using model_files::Bytes;
using model_files::bytesOf;
using model_files::PlyKind;
using ::testing::HasSubstr;

std::string errorOf(const Bytes& bytes) {
  const auto soup = readPly(bytes, {});
  return soup ? "no error" : sentence(soup.error().message);
}

std::string header(std::string_view elements, std::string_view format = "ascii") {
  return "ply\nformat " + std::string(format) + " 1.0\n" + std::string(elements) + "end_header\n";
}

const std::string kVertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kThreePoints = "0 0 0\n1 0 0\n0 1 0\n";

TEST(PlyReader, ReadsTextAndBothByteOrders) {
  const Mesh mesh = shapes::icosphere(3, 1);
  for (const PlyKind kind : {PlyKind::Ascii, PlyKind::LittleEndian, PlyKind::BigEndian}) {
    const auto soup = readPly(model_files::ply(mesh, kind), {});
    ASSERT_TRUE(soup) << soup.error().message;
    EXPECT_EQ(soup->triangles, mesh.triangles);
    ASSERT_EQ(soup->positions.size(), mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) EXPECT_EQ(Vec3f(soup->positions[v]), mesh.positions[v]);
  }
}

TEST(PlyReader, IgnoresOtherElementsPropertiesAndLists) {
  const auto soup = readPly(
      bytesOf(
          header("comment made by hand\nobj_info 1\nelement extra 2\nproperty list int float junk\nelement vertex 4\n"
                 "property uchar red\nproperty double z\nproperty double y\nproperty list ushort short more\n"
                 "property double x\nelement face 1\nproperty uchar flag\nproperty list ushort uint vertex_index\n"
                 "property list uchar float texcoord\n") +
          "3 1 2 3\n0\n255 0 0 0 0\n255 0 0 2 7 8 2\n255 0 2 0 2\n255 0 2 1 9 0\n7 4 0 1 2 3 2 0.5 0.5\n"),
      {});
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->triangles.size(), 2u);
  EXPECT_EQ(soup->positions[2], Vec3(2, 2, 0));
}

TEST(PlyReader, AFacesColourIsTheMeanOfItsVertices) {
  const auto coloursWith = [](const std::string& properties, const std::string& points) {
    const auto soup = readPly(bytesOf(header(kVertices + properties + kFaces) + points + "3 0 1 2\n"), {});
    EXPECT_TRUE(soup) << sentence(soup.error().message);
    return soup ? soup->colours : std::vector<std::optional<Colour>>();
  };
  EXPECT_EQ(coloursWith("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n",
                        "0 0 0 255 0 9 1\n1 0 0 255 0 9 1\n0 1 0 255 90 9 1\n"),
            (std::vector<std::optional<Colour>>{Colour{255, 30, 9}}));
  EXPECT_EQ(coloursWith("property float red\nproperty float green\nproperty float blue\n",
                        "0 0 0 1 0 0.5\n1 0 0 1 0 0.5\n0 1 0 7 -3 0.5\n"),
            (std::vector<std::optional<Colour>>{Colour{255, 0, 128}}));
  EXPECT_TRUE(coloursWith("property uchar red\nproperty uchar green\n", "0 0 0 1 1\n1 0 0 1 1\n0 1 0 1 1\n").empty());
}

TEST(PlyReader, SkipsCommentsAmongTheData) {
  const auto soup = readPly(bytesOf(header(kVertices + kFaces) + "comment vertices: 3\n0 0 0\n1 0 0 \nobj_info 1 2\n" +
                                    "comment\n0 1 0\ncomment faces\n3 0 1 2\ncomment the end\n"),
                            {});
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  EXPECT_EQ(soup->positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(soup->triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(PlyReader, ReadsABinaryFileWhoseHeaderHasWindowsLineEnds) {
  const Mesh mesh = shapes::tetrahedron(2);
  const Bytes bytes = model_files::ply(mesh, PlyKind::LittleEndian);
  std::string text(bytes.begin(), bytes.end());
  const std::size_t end = text.find("end_header\n") + 11;
  std::string windows;
  for (const char c : text.substr(0, end)) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const auto soup = readPly(bytesOf(windows + text.substr(end)), {});
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  EXPECT_EQ(soup->triangles, mesh.triangles);
}

TEST(PlyReader, ReadsBinaryDataThatStartsWithALineFeedAfterACrHeader) {
  std::string text = header(kVertices + kFaces, "binary_little_endian");
  for (char& c : text)
    if (c == '\n') c = '\r';
  Bytes bytes = bytesOf(text);
  const std::uint32_t first = 0x3f80000a;  // a float whose lowest byte is a line feed
  const std::array<float, 9> coordinates{0, 0, 0, 1, 0, 0, 0, 1, 0};
  bytes.resize(bytes.size() + 36);
  std::memcpy(bytes.data() + bytes.size() - 36, coordinates.data(), 36);
  std::memcpy(bytes.data() + bytes.size() - 36, &first, 4);
  for (const int b : {3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}) bytes.push_back(static_cast<std::uint8_t>(b));
  const auto soup = readPly(bytes, {});
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_NEAR(soup->positions[0].x, 1.0000012, 1e-7);
}

TEST(PlyReader, RefusesTriangleStripsWithTheReason) {
  EXPECT_THAT(errorOf(bytesOf(header(kVertices + "element tristrips 1\nproperty list int int vertex_indices\n") +
                              kThreePoints + "3 0 1 2\n")),
              HasSubstr("tristrips"));
}

TEST(PlyReader, RefusesAPointCloud) {
  EXPECT_THAT(errorOf(bytesOf(header(kVertices) + kThreePoints)), HasSubstr("0 elements \"face\""));
}

TEST(PlyReader, RefusesCountsThatTheFileCannotHold) {
  for (const char* format : {"ascii", "binary_little_endian"})
    EXPECT_THAT(errorOf(bytesOf(header("element vertex 9000000000000000000\nproperty float x\nproperty float y\n"
                                       "property float z\n" +
                                           kFaces,
                                       format) +
                                kThreePoints)),
                HasSubstr("declares 9000000000000000000 elements \"vertex\""));
}

TEST(PlyReader, RefusesAListLongerThanTheFile) {
  Bytes bytes =
      bytesOf(header(kVertices + "element face 1\nproperty list uint int vertex_indices\n", "binary_little_endian"));
  bytes.resize(bytes.size() + 36, 0);
  for (const int b : {0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0}) bytes.push_back(static_cast<std::uint8_t>(b));
  const std::string place = std::to_string(bytes.size() - 8);
  EXPECT_EQ(errorOf(bytes), "Element \"face\" 1 of 1 of the PLY file, byte " + place +
                                ": a list declares 4294967295 values, which take at least 17179869180 bytes, but only "
                                "4 bytes are left");
  EXPECT_EQ(errorOf(bytesOf(header(kVertices + "element face 1\nproperty list uint int vertex_indices\n") +
                            kThreePoints + "4294967295 0 1 2\n")),
            "Element \"face\" 1 of 1 of the PLY file, line 13: a list declares 4294967295 values, which take at least "
            "8589934590 bytes, but only 7 bytes are left");
}

TEST(PlyReader, RefusesAnIgnoredListLongerThanTheFile) {
  Bytes bytes = bytesOf(header(kVertices + "property list uint double junk\n" + kFaces, "binary_little_endian"));
  bytes.resize(bytes.size() + 12, 0);
  for (const int b : {0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0}) bytes.push_back(static_cast<std::uint8_t>(b));
  bytes.resize(bytes.size() + 40, 0);
  EXPECT_THAT(errorOf(bytes), HasSubstr("Element \"vertex\" 1 of 3 of the PLY file, byte "));
  EXPECT_THAT(errorOf(bytes), HasSubstr("a list declares 4294967295 values"));
}

TEST(PlyReader, NamesTheFirstIndexOutOfRangeEvenIfLaterOnesAreLarger) {
  const std::string faces = "element face 3\nproperty list uchar int vertex_indices\n";
  EXPECT_EQ(
      errorOf(bytesOf(header(kVertices + faces) + kThreePoints + "3 0 1 2\n3 0 1 3\n3 0 -1 2\n")),
      "Element \"face\" 2 of 3 of the PLY file, line 14: it refers to vertex 3 (counted from 0), but there are only 3");
}

TEST(PlyReader, ReadsVerticesThatFollowTheFaces) {
  EXPECT_TRUE(readPly(bytesOf(header(kFaces + kVertices) + "3 0 1 2\n" + kThreePoints), {}));
  EXPECT_THAT(errorOf(bytesOf(header(kFaces + kVertices) + "3 0 1 3\n" + kThreePoints)), HasSubstr("vertex 3"));
}

TEST(PlyReader, RefusesIndicesOutOfRangeNegativeOrBroken) {
  EXPECT_THAT(errorOf(bytesOf(header(kVertices + kFaces) + kThreePoints + "3 0 1 3\n")), HasSubstr("vertex 3"));
  EXPECT_THAT(errorOf(bytesOf(header(kVertices + kFaces) + kThreePoints + "3 0 1 -1\n")), HasSubstr("-1"));
  EXPECT_THAT(errorOf(bytesOf(header(kVertices + kFaces) + kThreePoints + "3 0 1 0.5\n")), HasSubstr("0.5"));
}

TEST(PlyReader, NamesTheLineOfAWordThatShouldBeANumber) {
  EXPECT_EQ(errorOf(bytesOf(header(kVertices + kFaces) + "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n")),
            "Element \"vertex\" 2 of 3 of the PLY file, line 11: \"zero\" is not a number");
}

TEST(PlyReader, RefusesCoordinatesThatAreNotFinite) {
  EXPECT_THAT(errorOf(bytesOf(header(kVertices + kFaces) + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n")), HasSubstr("Vertex 2"));
}

TEST(PlyReader, NamesErrorsInTheHeader) {
  EXPECT_THAT(errorOf(bytesOf("ply\nformat ascii 1.0\n")), HasSubstr("end_header"));
  EXPECT_THAT(errorOf(bytesOf("ply\nend_header\n")), HasSubstr("format"));
  EXPECT_THAT(errorOf(bytesOf("ply\nformat ternary 1.0\nend_header\n")), HasSubstr("\"ternary\""));
  EXPECT_THAT(errorOf(bytesOf(header("element vertex many\n"))), HasSubstr("Line 3"));
  EXPECT_THAT(errorOf(bytesOf(header("element vertex 3\nproperty quad x\n"))), HasSubstr("\"quad\""));
  EXPECT_THAT(errorOf(bytesOf(header("property float x\n"))), HasSubstr("before the first element"));
  EXPECT_THAT(
      errorOf(bytesOf(header("element vertex 3\nproperty float x\nproperty float y\n" + kFaces) + "0 0 0 0 0 0")),
      HasSubstr("\"z\""));
  EXPECT_THAT(errorOf(bytesOf(header(kVertices + "element face 1\nproperty list float int vertex_indices\n"))),
              HasSubstr("integer type"));
  EXPECT_THAT(
      errorOf(bytesOf(header(kVertices + "element face 1\nproperty int vertex_indices\n") + kThreePoints + "3")),
      HasSubstr("integer list"));
}

TEST(PlyReader, RefusesMoreTrianglesThanAllowed) {
  EXPECT_FALSE(readPly(model_files::ply(shapes::tetrahedron(1), PlyKind::Ascii), ReadLimits{.maxTriangles = 3}));
}

}  // namespace
}  // namespace qrelief
