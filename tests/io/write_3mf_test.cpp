// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_3mf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/read_model.h"
#include "io/write_checked.h"
#include "io/zip_archive.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Bytes = std::vector<std::uint8_t>;

constexpr Colour kWhite = {255, 255, 255}, kBlack = {16, 0, 10};

/// Returns the text of a part; empty if there is none.
std::string partOf(const Bytes& bytes, const std::string& name) {
  const auto archive = ZipArchive::open(bytes);
  if (!archive || !archive->find(name)) return {};
  auto stream = ZipStream::open(*archive->find(name), 1 << 30);
  std::string text;
  for (;;) {
    const auto piece = stream->next();
    if (!piece || piece->empty()) return text;
    text.append(piece->begin(), piece->end());
  }
}

/// Returns a plate with a cube in it, and a separate box next to them.
std::vector<ModelObject> inlaidPlate() {
  return {{"plate",
           {{"body", shapes::box({30, 30, 4}), kWhite},
            {"QR inlay", shapes::translated(shapes::box({5, 5, 1}), {0, 0, 1.5}), kBlack}}},
          {"beside", {{"", shapes::translated(shapes::box({3, 3, 3}), {40, 0, 0}), {}}}}};
}

TEST(Write3mf, WritesTheBodiesOfOneObjectAsComponents) {
  const std::string model = partOf(*write3mf(inlaidPlate(), {}), "3D/3dmodel.model");
  EXPECT_THAT(model, HasSubstr("<object id=\"2\" name=\"body\" type=\"model\" pid=\"1\" pindex=\"0\">"));
  EXPECT_THAT(model, HasSubstr("<object id=\"3\" name=\"QR inlay\" type=\"model\" pid=\"1\" pindex=\"1\">"));
  EXPECT_THAT(model, HasSubstr("<object id=\"4\" name=\"plate\" type=\"model\">\n   <components>\n"
                               "    <component objectid=\"2\"/>\n    <component objectid=\"3\"/>\n"));
  EXPECT_THAT(model, HasSubstr("<object id=\"5\" name=\"beside\" type=\"model\" pid=\"1\" pindex=\"0\">"));
  EXPECT_THAT(model, HasSubstr("<build>\n  <item objectid=\"4\"/>\n  <item objectid=\"5\"/>\n </build>"));
  EXPECT_THAT(model, HasSubstr("unit=\"millimeter\""));
}

TEST(Write3mf, WritesPlacesAndTypesOfObjects) {
  const std::vector<ModelObject> objects = {
      {"A", {{"", shapes::box({1, 1, 1}), {}}}, "https://example.org/?a=1&b=<2>", {0.1, 20, -3}},
      {"B", {{"", shapes::box({1, 1, 1}), {}}}}};
  const auto bytes = writeChecked(objects, ModelFormat::ThreeMf);
  ASSERT_TRUE(bytes);
  EXPECT_THAT(
      partOf(*bytes, "3D/3dmodel.model"),
      HasSubstr("  <item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 0.1 20 -3\">\n   <metadatagroup><metadata "
                "name=\"Description\">https://example.org/?a=1&amp;b=&lt;2&gt;</metadata></metadatagroup>\n"
                "  </item>\n  <item objectid=\"3\"/>\n"));
}

TEST(Write3mf, WritesColoursForEverySlicer) {
  const Bytes bytes = *write3mf(inlaidPlate(), {});
  const std::string model = partOf(bytes, "3D/3dmodel.model");
  EXPECT_THAT(model, HasSubstr("xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\""));
  EXPECT_THAT(model, HasSubstr("requiredextensions=\"m\""));
  EXPECT_THAT(model, HasSubstr("<m:colorgroup id=\"1\">\n   <m:color color=\"#FFFFFFFF\"/>\n   <m:color "
                               "color=\"#10000AFF\"/>\n  </m:colorgroup>"));
  EXPECT_THAT(model, HasSubstr("<metadata name=\"cura:extruder_nr\" preserve=\"1\" type=\"xs:integer\">0</metadata>"));
  EXPECT_THAT(model, HasSubstr("<metadata name=\"cura:extruder_nr\" preserve=\"1\" type=\"xs:integer\">1</metadata>"));
  const std::string bambu = partOf(bytes, "Metadata/model_settings.config");
  EXPECT_THAT(bambu, HasSubstr("<object id=\"4\">"));
  EXPECT_THAT(bambu,
              HasSubstr("<part id=\"3\" subtype=\"normal_part\">\n   <metadata key=\"name\" value=\"QR inlay\"/>\n"
                        "   <metadata key=\"extruder\" value=\"2\"/>"));
  const std::string prusa = partOf(bytes, "Metadata/Slic3r_PE_model.config");
  EXPECT_THAT(prusa, HasSubstr("<object id=\"3\" instances_count=\"1\">\n"
                               "  <metadata type=\"object\" key=\"name\" value=\"QR inlay\"/>\n"
                               "  <metadata type=\"object\" key=\"extruder\" value=\"2\"/>\n"
                               "  <volume firstid=\"0\" lastid=\"11\">"));
}

TEST(Write3mf, WritesNoColoursIfThereAreNone) {
  const std::vector<ModelObject> objects = {{"plain", {{"", shapes::box({1, 2, 3}), {}}}}};
  const Bytes bytes = *write3mf(objects, {});
  const std::string model = partOf(bytes, "3D/3dmodel.model");
  EXPECT_THAT(model, Not(HasSubstr("colorgroup")));
  EXPECT_THAT(model, Not(HasSubstr("requiredextensions")));
  EXPECT_EQ(partOf(bytes, "Metadata/model_settings.config"), "");
  EXPECT_EQ(partOf(bytes, "Metadata/Slic3r_PE_model.config"), "");
}

TEST(Write3mf, KeepsTheNamesOfObjects) {
  const auto soup = readModel(*write3mf(inlaidPlate(), {}), "a.3mf");
  ASSERT_TRUE(soup) << soup.error().message;
  ASSERT_EQ(soup->parts.size(), 2u);
  EXPECT_EQ(soup->parts[0].name, "plate");
  EXPECT_EQ(soup->parts[1].name, "beside");
  EXPECT_EQ(soup->parts[1].firstTriangle, 24u);
  EXPECT_EQ(soup->unitMm, 1);
}

TEST(Write3mf, KeepsNamesOfEveryKind) {
  const auto nameAfter = [](const std::string& name) {
    const std::vector<ModelObject> objects = {{name, {{"", shapes::box({1, 2, 3}), {}}}}};
    return readModel(*write3mf(objects, {}), "a.3mf")->parts.at(0).name;
  };
  EXPECT_EQ(nameAfter("a < b & \"c\" > d"), "a < b & \"c\" > d");
  EXPECT_EQ(nameAfter("Ünïcödé 🐇 – 兔"), "Ünïcödé 🐇 – 兔");
  // XML cannot hold these: control characters; cut-off, overlong and surrogate sequences; U+FFFF.
  EXPECT_EQ(nameAfter("a\x01\n\xe2\x82"), "a????");
  EXPECT_EQ(nameAfter("\xc0\xaf \xed\xa0\x80 \xef\xbf\xbf \xf5"), "?? ??? ??? ?");
}

TEST(Write3mf, NamesObjectsThatHaveNoName) {
  const Mesh box = shapes::box({1, 2, 3});
  const std::vector<ModelObject> one = {{"", {{"", box, {}}}}};
  EXPECT_EQ(readModel(*write3mf(one, {.title = "knight"}), "a.3mf")->parts.at(0).name, "knight");
  const std::vector<ModelObject> two = {{"", {{"", box, {}}}}, {"", {{"", box, {}}}}};
  EXPECT_EQ(readModel(*write3mf(two, {.title = "knight"}), "a.3mf")->parts.at(1).name, "Object 2");
}

TEST(Write3mf, IsDeterministic) { EXPECT_EQ(*write3mf(inlaidPlate(), {}), *write3mf(inlaidPlate(), {})); }

}  // namespace
}  // namespace qrelief
