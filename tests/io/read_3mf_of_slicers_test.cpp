// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of what slicers write into 3MF files: volumes, paint, filaments, helper meshes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/three_mf/read_3mf.h"
#include "io/three_mf/source.h"
#include "messages/sentences.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using ::testing::HasSubstr;
using zip_file::boxObject;
using zip_file::modelPart;
using zip_file::threeMf;

std::string errorOf(const std::string& model, const ReadLimits& limits = {}) {
  const auto soup = read3mf(threeMf(model), limits);
  if (soup) return "no error";
  EXPECT_EQ(soup.error().kind, ErrorKind::BadInput);
  EXPECT_FALSE(hint(soup.error().message).empty());
  return sentence(soup.error().message);
}

/// Returns a box as Cura marks it with a setting, in its new and old ways.
std::vector<std::string> curaBoxes(const std::string& setting, const std::string& value) {
  const std::string box = boxObject(2, 9, 9, 9), space = "xmlns=\"http://software.ultimaker.com/xml/cura/3mf/2015/10\"";
  const auto with = [&](const std::string& settings) {
    std::string marked = box;
    return marked.insert(marked.find("<mesh>"), settings);
  };
  return {with("<metadatagroup><metadata name=\"cura:" + setting + "\" preserve=\"1\" type=\"xs:boolean\">" + value +
               "</metadata></metadatagroup>"),
          with("<settings " + space + "><setting key=\"" + setting + "\">" + value + "</setting></settings>")};
}

TEST(ThreeMfReader, TellsPaintedFacetsAndPlates) {
  const auto sourceOf = [](const std::string& attribute, int plates) {
    std::string object = boxObject(1, 1, 2, 3);
    object.insert(object.find("<triangle ") + 10, attribute);
    std::string settings = "<config><object id=\"1\"/>";
    for (int k = 0; k < plates; ++k) settings += "<plate/>";
    const char* const kSpace = "xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\"";
    const auto soup = read3mf(threeMf(modelPart(object, "<item objectid=\"1\"/>", kSpace),
                                      {{"Metadata/model_settings.config", settings + "</config>"}}),
                              {});
    EXPECT_TRUE(soup) << soup.error().message;
    return *soup->source;
  };
  EXPECT_FALSE(sourceOf("", 0).isPainted);
  EXPECT_FALSE(sourceOf("pid=\"5\" p1=\"0\" ", 0).isPainted);
  EXPECT_TRUE(sourceOf("paint_color=\"8\" ", 0).isPainted);
  EXPECT_TRUE(sourceOf("slic3rpe:mmu_segmentation=\"8\" ", 0).isPainted);
  EXPECT_EQ(sourceOf("", 0).plates, 0u);
  EXPECT_EQ(sourceOf("", 2).plates, 2u);
}

TEST(ThreeMfReader, LeavesHelperMeshesOfCuraOut) {
  const std::string build = "<item objectid=\"1\"/><item objectid=\"2\"/>";
  for (const char* setting : {"support_mesh", "anti_overhang_mesh", "infill_mesh", "cutting_mesh"})
    for (const char* value : {"True", "False", " true\n", "1", "0"})
      for (const std::string& marked : curaBoxes(setting, value)) {
        const bool isHelper = std::string_view(value) != "False" && std::string_view(value) != "0";
        const auto soup = read3mf(threeMf(modelPart(boxObject(1, 1, 2, 3) + marked, build)), {});
        ASSERT_TRUE(soup) << sentence(soup.error().message);
        EXPECT_EQ(soup->triangles.size(), isHelper ? 12u : 24u) << marked;
        ASSERT_EQ(soup->warnings.size(), isHelper ? 1u : 0u);
        if (isHelper) {
          EXPECT_THAT(sentence(soup->warnings[0]), HasSubstr(std::string("helper mesh of Cura (") + setting));
        }
      }
  const auto other =
      read3mf(threeMf(modelPart(curaBoxes("drop_to_buildplate", "True")[0], "<item objectid=\"2\"/>")), {});
  EXPECT_TRUE(other);
  EXPECT_EQ(errorOf(modelPart(curaBoxes("support_mesh", "True")[0], "<item objectid=\"2\"/>")),
            "The only item of the 3MF file contains no model: object 2 is a helper mesh of Cura (support_mesh)");
}

TEST(ThreeMfReader, LeavesComponentsThatAreHelperMeshesOfCuraOut) {
  const std::string group =
      "<object id=\"5\"><components><component objectid=\"1\"/><component objectid=\"2\"/></components></object>";
  const auto soup = read3mf(
      threeMf(modelPart(boxObject(1, 1, 2, 3) + curaBoxes("infill_mesh", "True")[0] + group, "<item objectid=\"5\"/>")),
      {});
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  EXPECT_EQ(soup->triangles.size(), 12u);
}

TEST(ThreeMfReader, LeavesItemsThatAreNotPrintedOut) {
  const std::string resources = boxObject(1, 1, 2, 3) + boxObject(2, 9, 9, 9);
  for (const char* no : {"0", "false", " 0 "}) {
    const auto soup =
        read3mf(threeMf(modelPart(resources, fmt::format("<item objectid=\"1\" printable=\"1\"/><item objectid=\"2\" "
                                                         "printable=\"{}\"/>",
                                                         no))),
                {});
    ASSERT_TRUE(soup) << sentence(soup.error().message);
    EXPECT_EQ(soup->triangles.size(), 12u);
    EXPECT_THAT(sentence(soup->warnings.at(0)), HasSubstr("object 2 is set not to print"));
  }
  EXPECT_THAT(
      errorOf(modelPart(resources, "<item objectid=\"1\" printable=\"0\"/><item objectid=\"2\" printable=\"0\"/>")),
      HasSubstr("None of the 2 items of the 3MF file contains a model: object 1 is set not to print"));
}

TEST(ThreeMfReader, ReadsNamesAndFilamentsOfVolumesAndParts) {
  const auto expectBodies = [](const Result<PolygonSoup>& soup) {
    ASSERT_TRUE(soup) << sentence(soup.error().message);
    ASSERT_EQ(soup->bodies.size(), 2u);
    EXPECT_EQ(soup->bodies[0].name, "plate");
    EXPECT_EQ(soup->bodies[0].filament, 3u);
    EXPECT_EQ(soup->bodies[1].name, "text");
    EXPECT_EQ(soup->bodies[1].filament, 2u);
  };
  const std::string group =
      "<object id=\"5\"><components><component objectid=\"1\"/><component objectid=\"2\"/></components></object>";
  expectBodies(
      read3mf(threeMf(modelPart(boxObject(1, 1, 2, 3) + boxObject(2, 1, 1, 1) + group, "<item objectid=\"5\"/>"),
                      {{"Metadata/model_settings.config",
                        "<config><object id=\"5\"><metadata key=\"extruder\" value=\"3\"/>"
                        "<part id=\"1\"><metadata key=\"name\" value=\"plate\"/></part>"
                        "<part id=\"2\"><metadata key=\"name\" value=\"text\"/>"
                        "<metadata key=\"extruder\" value=\"2\"/></part></object></config>"}}),
              {}));
  expectBodies(read3mf(
      threeMf(modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1\"/>"),
              {{"Metadata/Slic3r_PE_model.config",
                "<config><object id=\"1\"><metadata type=\"object\" key=\"extruder\" value=\"3\"/>"
                "<volume firstid=\"0\" lastid=\"5\"><metadata type=\"volume\" key=\"name\" value=\"plate\"/></volume>"
                "<volume firstid=\"6\" lastid=\"11\"><metadata type=\"volume\" key=\"name\" value=\"text\"/>"
                "<metadata type=\"volume\" key=\"extruder\" value=\"2\"/></volume></object></config>"}}),
      {}));
}

/// Returns the colours of a tetrahedron's facets. @param triangles  attributes of each
std::vector<std::optional<Colour>> coloursOf(const std::string& resources, const std::string& object,
                                             const std::array<std::string, 4>& triangles,
                                             const std::vector<zip_file::File>& settings = {}) {
  constexpr std::array<const char*, 4> kCorners = {"v1=\"0\" v2=\"2\" v3=\"1\"", "v1=\"0\" v2=\"1\" v3=\"3\"",
                                                   "v1=\"1\" v2=\"2\" v3=\"3\"", "v1=\"2\" v2=\"0\" v3=\"3\""};
  std::string model = resources + "<object id=\"1\" " + object +
                      "><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
                      "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles>";
  for (std::size_t t = 0; t < 4; ++t) model += fmt::format("<triangle {} {}/>", kCorners[t], triangles[t]);
  model += "</triangles></mesh></object>";
  const auto soup =
      read3mf(threeMf(modelPart(model, "<item objectid=\"1\"/>",
                                "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
                                "xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\""),
                      settings),
              {});
  EXPECT_TRUE(soup) << sentence(soup.error().message);
  return soup ? soup->colours : std::vector<std::optional<Colour>>();
}

constexpr Colour kRed{255, 0, 0}, kGreen{0, 128, 0}, kBlue{0, 0, 255};
using Colours = std::vector<std::optional<Colour>>;

TEST(ThreeMfReader, ReadsTheColoursOfFacetsAndObjects) {
  const std::string groups =
      "<basematerials id=\"7\"><base name=\"a\" displaycolor=\"#FF0000\"/></basematerials>"
      "<m:colorgroup id=\"8\"><m:color color=\"#008000FF\"/><m:color color=\"#0000FF80\"/></m:colorgroup>";
  EXPECT_EQ(coloursOf(groups, "pid=\"7\" pindex=\"0\"", {"", "pid=\"8\" p1=\"1\"", "p1=\"0\"", "pid=\"8\" p1=\"0\""}),
            (Colours{kRed, kBlue, kRed, kGreen}));
  EXPECT_EQ(coloursOf(groups, "", {"", "pid=\"8\" p1=\"9\"", "pid=\"9\" p1=\"0\"", "pid=\"8\" p1=\"0\""}),
            (Colours{{}, {}, {}, kGreen}));
  EXPECT_EQ(coloursOf("<basematerials id=\"7\"><base name=\"a\" displaycolor=\"red\"/></basematerials>",
                      "pid=\"7\" pindex=\"0\"", {}),
            (Colours(4)));
}

TEST(ThreeMfReader, PaintedFacetsHaveTheColoursOfTheirFilaments) {
  const std::array<std::string, 4> painted = {"", "paint_color=\"8\"", "slic3rpe:mmu_segmentation=\"0C\"", ""};
  EXPECT_EQ(
      coloursOf("", "", painted,
                {{"Metadata/project_settings.config", R"({"filament_colour": ["#FFFFFF", "#008000", "#0000FFFF"]})"}}),
      (Colours{{}, kGreen, kBlue, {}}));
  EXPECT_EQ(coloursOf("", "", painted,
                      {{"Metadata/Slic3r_PE.config",
                        "; extruder_colour = \"\";#008000;\n; filament_colour = #FFFFFF;#FF0000;#0000FF\n"},
                       {"Metadata/Slic3r_PE_model.config",
                        "<config><object id=\"1\"><metadata type=\"object\" key=\"extruder\" value=\"1\"/>"
                        "<volume firstid=\"0\" lastid=\"3\"></volume></object></config>"}}),
            (Colours{Colour{255, 255, 255}, kGreen, kBlue, Colour{255, 255, 255}}));
  const Colours unknown = coloursOf("", "", painted);
  EXPECT_FALSE(unknown[0]);
  ASSERT_TRUE(unknown[1] && unknown[2]);
  EXPECT_NE(unknown[1], unknown[2]) << "told apart though the file names no colours";
}

TEST(ThreeMfReader, LeavesModifiersOfBambuStudioOut) {
  const std::string resources = boxObject(1, 1, 2, 3) + boxObject(2, 9, 9, 9) + boxObject(3, 8, 8, 8) +
                                boxObject(4, 7, 7, 7, "type=\"other\"") +
                                "<object id=\"5\"><components><component objectid=\"2\"/><component objectid=\"1\"/>"
                                "<component objectid=\"3\"/><component objectid=\"4\"/></components></object>";
  const auto settings = [](const std::string& kind, const std::string& object) {
    return zip_file::File{"Metadata/model_settings.config",
                          "<config><object id=\"" + object + "\"><part id=\"2\" subtype=\"" + kind +
                              "\"/><part id=\"1\" subtype=\"normal_part\"/><part id=\"3\" subtype=\"unknown\"/>"
                              "</object></config>"};
  };
  const std::string model = modelPart(resources, "<item objectid=\"5\"/>");
  for (const char* kind : {"modifier_part", "negative_part", "support_blocker", "support_enforcer"}) {
    const auto soup = read3mf(threeMf(model, {settings(kind, "5")}), {});
    ASSERT_TRUE(soup) << sentence(soup.error().message);
    EXPECT_EQ(soup->triangles.size(), 24u);
    EXPECT_EQ(soup->positions.size(), 16u);
    ASSERT_EQ(soup->warnings.size(), 1u);
    EXPECT_THAT(sentence(soup->warnings[0]), HasSubstr("2 volumes of the 3MF file are not models"));
    ASSERT_EQ(soup->source->runs.size(), 2u);
    EXPECT_EQ(soup->source->runs[0].object, 1u);
    EXPECT_EQ(soup->source->runs[1].object, 3u);
    EXPECT_EQ(soup->source->runs[1].firstTriangle, 12u);
    EXPECT_EQ(soup->source->runs[1].itemObject, 5u);
  }
  // The settings of another object do not count.
  EXPECT_EQ(read3mf(threeMf(model, {settings("modifier_part", "6")}), {})->triangles.size(), 36u);
}

TEST(ThreeMfReader, LeavesModifiersOfPrusaSlicerOut) {
  std::string two = boxObject(1, 1, 2, 3);  // 12 triangles, of which the settings make two volumes
  const auto read = [&](const std::string& volumes) {
    return read3mf(
        threeMf(modelPart(two, "<item objectid=\"1\"/>"),
                {{"Metadata/Slic3r_PE_model.config", "<config><object id=\"1\">" + volumes + "</object></config>"}}),
        {});
  };
  const auto volume = [](int first, int last, const std::string& key, const std::string& value) {
    return "<volume firstid=\"" + std::to_string(first) + "\" lastid=\"" + std::to_string(last) +
           "\"><metadata type=\"volume\" key=\"" + key + "\" value=\"" + value + "\"/></volume>";
  };
  for (const char* kind : {"ParameterModifier", "NegativeVolume", "SupportBlocker", "SupportEnforcer"}) {
    const auto soup = read(volume(0, 7, "volume_type", "ModelPart") + volume(8, 11, "volume_type", kind));
    ASSERT_TRUE(soup) << sentence(soup.error().message);
    EXPECT_EQ(soup->triangles.size(), 8u);
    EXPECT_EQ(soup->source->runs.size(), 1u);
  }
  EXPECT_EQ(read(volume(0, 3, "modifier", "1") + volume(4, 11, "modifier", "0"))->triangles.size(), 8u);
  // Ranges may come in any order. Triangles in no volume are models.
  EXPECT_EQ(read(volume(8, 11, "modifier", "0") + volume(0, 3, "modifier", "1"))->triangles.size(), 8u);
  EXPECT_EQ(read(volume(3, 5, "modifier", "1"))->triangles.size(), 9u);
}

TEST(ThreeMfReader, IgnoresVolumesOfPrusaSlicerThatDoNotDivideTheMesh) {
  using Range = std::pair<std::string, std::string>;
  const auto trianglesRead = [](const std::vector<Range>& ranges) {
    std::string volumes;
    for (const auto& [first, last] : ranges)
      volumes += "<volume firstid=\"" + first + "\" lastid=\"" + last +
                 "\"><metadata type=\"volume\" key=\"modifier\" value=\"1\"/></volume>";
    const auto soup = read3mf(
        threeMf(modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1\"/>"),
                {{"Metadata/Slic3r_PE_model.config", "<config><object id=\"1\">" + volumes + "</object></config>"}}),
        {});
    EXPECT_TRUE(soup) << sentence(soup.error().message);
    return soup ? soup->triangles.size() : 0;
  };
  EXPECT_EQ(trianglesRead({{"0", "2"}, {"5", "6"}}), 7u);
  const std::vector<std::vector<Range>> invalid = {
      {{"0", "4"}, {"4", "6"}},         // overlap in one triangle, and leave a gap
      {{"5", "8"}, {"6", "7"}},         // one within the other
      {{"3", "4"}, {"3", "4"}},         // the same twice
      {{"0", "2"}, {"10", "12"}},       // ends after the last triangle
      {{"0", "99999999999999999999"}},  // does not fit into a number
      {{"0", "2"}, {"5", "4"}},         // reversed
      {{"-3", "4"}},
      {{"0", "-1"}},
      {{"", "4"}}};
  for (const std::vector<Range>& ranges : invalid)
    EXPECT_EQ(trianglesRead(ranges), 12u) << ranges.front().first << ' ' << ranges.back().second;
}

TEST(ThreeMfReader, ReadsTheModelsOfAFileWhoseSettingsAreDamaged) {
  const auto soup = read3mf(threeMf(modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1\"/>"),
                                    {{"Metadata/model_settings.config", "<config><object id=\"1\">"}}),
                            {});
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  EXPECT_EQ(soup->triangles.size(), 12u);
  ASSERT_EQ(soup->warnings.size(), 1u);
  EXPECT_THAT(sentence(soup->warnings[0]), HasSubstr("modifiers count as models"));
}

}  // namespace
}  // namespace qrelief
