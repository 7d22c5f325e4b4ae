// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_files.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/read_model.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr Colour kWhite = {255, 255, 255}, kBlack = {51, 0, 0};

std::vector<ModelObject> inlaid() {
  return {{"plate",
           {{"body", shapes::box({30, 30, 4}), kWhite},
            {"QR code", shapes::translated(shapes::box({5, 5, 1}), {0, 0, 1.5}), kBlack}}},
          {"other", {{"", shapes::translated(shapes::box({3, 3, 3}), {40, 0, 0}), {}}}}};
}

std::string textOf(const NamedFile& file) { return {file.bytes.begin(), file.bytes.end()}; }

TEST(FileNames, AreSeveralOnlyForTwoColours) {
  EXPECT_THAT(fileNames("out/a.b.stl", true), ElementsAre("out/a.b.stl", "out/a.b-2.stl"));
  EXPECT_THAT(fileNames("a.OBJ", true), ElementsAre("a.OBJ", "a.mtl"));
  EXPECT_THAT(fileNames("a.3mf", true), ElementsAre("a.3mf"));
  for (const char* name : {"a.stl", "a.obj", "a.3mf"}) EXPECT_THAT(fileNames(name, false), ElementsAre(name));
}

TEST(WriteFiles, WritesAnStlForEachColour) {
  const auto files = writeCheckedFiles(inlaid(), "out/x.stl");
  ASSERT_TRUE(files);
  ASSERT_EQ(files->size(), 2u);
  EXPECT_EQ((*files)[0].name, "out/x.stl");
  EXPECT_EQ(readModel((*files)[0].bytes, "x.stl")->triangles.size(), 24u);
  EXPECT_EQ((*files)[1].name, "out/x-2.stl");
  EXPECT_EQ(readModel((*files)[1].bytes, "x.stl")->triangles.size(), 12u);
}

TEST(WriteFiles, WritesAnObjWithAMaterialForEachColour) {
  const auto files = writeCheckedFiles(inlaid(), "out/x.obj");
  ASSERT_TRUE(files);
  ASSERT_EQ(files->size(), 2u);
  const std::string obj = textOf((*files)[0]);
  EXPECT_THAT(obj, StartsWith("# QRelief; millimetres\nmtllib x.mtl\no body\nv "));
  EXPECT_THAT(obj, HasSubstr("\nusemtl colour-2\nf 9 "));
  EXPECT_THAT(obj, HasSubstr("\nusemtl colour-1\nf 17 "));
  EXPECT_EQ((*files)[1].name, "out/x.mtl");
  EXPECT_EQ(textOf((*files)[1]),
            "newmtl colour-1\nKd 1.0000 1.0000 1.0000\nnewmtl colour-2\nKd 0.2000 0.0000 0.0000\n");
}

TEST(WriteFiles, PaintedFacetsHaveTheirMaterialInObjAndNoStl) {
  const std::vector<ModelObject> painted = {{"a", {{"", shapes::box({1, 1, 1}), kWhite, FacetPaint{kBlack, {3, 4}}}}}};
  const auto files = writeCheckedFiles(painted, "x.obj");
  ASSERT_TRUE(files);
  const std::string obj = textOf((*files)[0]);
  const std::size_t second = obj.find("usemtl colour-2\n"), back = obj.find("usemtl colour-1\n", second);
  ASSERT_NE(back, std::string::npos);
  const std::string between = obj.substr(second, back - second);
  EXPECT_EQ(std::count(between.begin(), between.end(), 'f'), 2);
  EXPECT_EQ(writeCheckedFiles(painted, "x.stl").error().kind, ErrorKind::BadUsage);
}

TEST(WriteFiles, WritesOneFileForOneColour) {
  const std::vector<ModelObject> plain = {{"a", {{"", shapes::box({1, 1, 1}), {}}}}};
  for (const char* name : {"x.stl", "x.obj", "x.ply", "x.3mf"}) EXPECT_EQ(writeCheckedFiles(plain, name)->size(), 1u);
}

}  // namespace
}  // namespace qrelief
