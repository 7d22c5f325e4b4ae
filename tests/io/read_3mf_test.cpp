// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/read_3mf.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/three_mf/model.h"
#include "io/three_mf/source.h"
#include "math/box.h"
#include "messages/sentences.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using ::testing::HasSubstr;
using zip_file::boxObject;
using zip_file::modelPart;
using zip_file::threeMf;

constexpr const char* kProduction =
    "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" requiredextensions=\"p\"";

std::string errorOf(const std::string& model, const ReadLimits& limits = {}) {
  const auto soup = read3mf(threeMf(model), limits);
  if (soup) return "no error";
  EXPECT_EQ(soup.error().kind, ErrorKind::BadInput);
  EXPECT_FALSE(hint(soup.error().message).empty());
  return sentence(soup.error().message);
}

Box3 boxOf(const PolygonSoup& soup) {
  Box3 box;
  for (const Vec3& p : soup.positions) box.add(p);
  return box;
}

double volumeOf(const PolygonSoup& soup) {
  double six = 0;
  for (const auto& [a, b, c] : soup.triangles)
    six += glm::dot(soup.positions[a], glm::cross(soup.positions[b], soup.positions[c]));
  return six / 6;
}

/// Returns the soup of one box of 1 × 2 × 3 that the given item places.
PolygonSoup placedBox(const std::string& item) {
  const auto soup = read3mf(threeMf(modelPart(boxObject(1, 1, 2, 3), item)), {});
  EXPECT_TRUE(soup) << soup.error().message;
  return soup ? *soup : PolygonSoup();
}

TEST(ThreeMfReader, ReadsAnObject) {
  const PolygonSoup soup = placedBox("<item objectid=\"1\"/>");
  EXPECT_EQ(soup.format, "3MF");
  EXPECT_EQ(soup.positions.size(), 8u);
  EXPECT_EQ(soup.triangles.size(), 12u);
  EXPECT_EQ(soup.unitMm, 1);
  EXPECT_EQ(volumeOf(soup), 6);
  EXPECT_EQ(boxOf(soup).max, Vec3(1, 2, 3));
  EXPECT_TRUE(soup.warnings.empty());
}

TEST(ThreeMfReader, AppliesTransformsRowByRow) {
  // The transform maps x to y, y to z and z to x, then moves by (10, 20, 30).
  const PolygonSoup soup = placedBox("<item objectid=\"1\" transform=\"0 1 0 0 0 1 1 0 0 10 20 30\"/>");
  EXPECT_EQ(boxOf(soup).min, Vec3(10, 20, 30));
  EXPECT_EQ(boxOf(soup).max, Vec3(13, 21, 32));
  EXPECT_EQ(volumeOf(soup), 6);
}

TEST(ThreeMfReader, FlipsMirroredInstances) {
  const PolygonSoup soup = placedBox("<item objectid=\"1\" transform=\"-2 0 0 0 1 0 0 0 1 0 0 0\"/>");
  EXPECT_EQ(boxOf(soup).min, Vec3(-2, 0, 0));
  EXPECT_EQ(volumeOf(soup), 12);
}

TEST(ThreeMfReader, KnowsEveryUnit) {
  const std::pair<const char*, double> units[] = {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10},
                                                  {"inch", 25.4},    {"foot", 304.8},   {"meter", 1000}};
  for (const auto& [name, mm] : units) {
    const auto soup = read3mf(
        threeMf(modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1\"/>", fmt::format("unit=\"{}\"", name))), {});
    ASSERT_TRUE(soup) << name;
    EXPECT_EQ(soup->unitMm, mm);
    EXPECT_EQ(boxOf(*soup).max, Vec3(1, 2, 3));
  }
  EXPECT_THAT(errorOf(modelPart("", "", "unit=\"mile\"")), HasSubstr("the unit \"mile\" is unknown"));
}

TEST(ThreeMfReader, MakesEveryItemAPart) {
  const auto soup = read3mf(threeMf(modelPart(boxObject(1, 1, 1, 1, "name=\"cube &amp; co\"") + boxObject(2, 2, 2, 2),
                                              "<item objectid=\"1\"/><item objectid=\"2\" partnumber=\"P2\" "
                                              "transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/><item objectid=\"1\" "
                                              "transform=\"1 0 0 0 1 0 0 0 1 9 0 0\"/>")),
                            {});
  ASSERT_TRUE(soup) << soup.error().message;
  ASSERT_EQ(soup->parts.size(), 3u);
  EXPECT_EQ(soup->parts[0].name, "cube & co");
  EXPECT_EQ(soup->parts[1].name, "P2");
  EXPECT_EQ(soup->parts[1].firstTriangle, 12u);
  EXPECT_EQ(soup->parts[2].firstTriangle, 24u);
  EXPECT_EQ(volumeOf(*soup), 1 + 8 + 1);
}

TEST(ThreeMfReader, AssemblesNestedComponents) {
  // The scene is two pairs of boxes. The boxes of a pair are 10 apart; the second pair is mirrored in x and 100 higher.
  // The whole is scaled by two.
  const std::string resources = boxObject(1, 1, 2, 3) +
                                "<object id=\"2\"><components><component objectid=\"1\"/><component objectid=\"1\" "
                                "transform=\"1 0 0 0 1 0 0 0 1 10 0 0\"/></components></object>"
                                "<object id=\"3\" name=\"pairs\"><components><component objectid=\"2\"/><component "
                                "objectid=\"2\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 100\"/></components></object>";
  const auto soup =
      read3mf(threeMf(modelPart(resources, "<item objectid=\"3\" transform=\"2 0 0 0 2 0 0 0 2 0 0 0\"/>")), {});
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->triangles.size(), 48u);
  EXPECT_EQ(volumeOf(*soup), 4 * 6 * 8);
  EXPECT_EQ(boxOf(*soup).min, Vec3(-22, 0, 0));
  EXPECT_EQ(boxOf(*soup).max, Vec3(22, 4, 206));
  ASSERT_EQ(soup->parts.size(), 1u);
  EXPECT_EQ(soup->parts[0].name, "pairs");
}

TEST(ThreeMfReader, FollowsThePathsOfTheProductionExtension) {
  const std::string root = modelPart(
      "<object id=\"1\"><components><component objectid=\"1\" "
      "p:path=\"/3D/Objects/a%20b.model\"/></components></object>",
      "<item objectid=\"1\"/><item objectid=\"7\" p:path=\"/3d/objects/C.model\"/>", kProduction);
  const auto soup = read3mf(threeMf(root, {{"3D/Objects/a b.model", modelPart(boxObject(1, 1, 2, 3), "")},
                                           {"3D/Objects/c.model", modelPart(boxObject(7, 2, 2, 2), "")}}),
                            {});
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(volumeOf(*soup), 6 + 8);
}

TEST(ThreeMfReader, ConvertsAPartOfAnotherUnit) {
  const std::string root = modelPart(
      "<object id=\"1\"><components><component objectid=\"1\" p:path=\"/3D/b.model\" "
      "transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components></object>",
      "<item objectid=\"1\"/>", kProduction);
  const auto soup =
      read3mf(threeMf(root, {{"3D/b.model", modelPart(boxObject(1, 1, 2, 3), "", "unit=\"centimeter\"")}}), {});
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(boxOf(*soup).min, Vec3(5, 0, 0));  // the transform uses the unit of the part that contains it
  EXPECT_EQ(boxOf(*soup).max, Vec3(15, 20, 30));
}

TEST(ThreeMfReader, RefusesPathsThatLeaveTheArchive) {
  for (const char* path :
       {"/../../etc/passwd", "file:///etc/passwd", "/3D/..\\\\b.model", "/..", "/%2e%2e/../b.model"}) {
    const std::string root = modelPart("", fmt::format("<item objectid=\"1\" p:path=\"{}\"/>", path), kProduction);
    EXPECT_THAT(errorOf(root), testing::AnyOf(HasSubstr("outside the file"), HasSubstr("is missing"))) << path;
  }
  const std::string inside = modelPart("", "<item objectid=\"1\" p:path=\"/a/../3D/./b.model\"/>", kProduction);
  EXPECT_TRUE(read3mf(threeMf(inside, {{"3D/b.model", modelPart(boxObject(1, 1, 1, 1), "")}}), {}));
}

TEST(ThreeMfReader, IgnoresItemsThatAreNotModels) {
  const std::string resources = boxObject(1, 1, 2, 3) + boxObject(2, 9, 9, 9, "type=\"support\"");
  const auto soup = read3mf(threeMf(modelPart(resources, "<item objectid=\"1\"/><item objectid=\"2\"/>")), {});
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->triangles.size(), 12u);
  ASSERT_EQ(soup->warnings.size(), 1u);
  EXPECT_EQ(sentence(soup->warnings[0]),
            "1 of 2 items of the 3MF file is no model to print and stays as it is: object 2 is of type \"support\"");
  EXPECT_THAT(errorOf(modelPart(resources, "<item objectid=\"2\"/>")),
              HasSubstr("The only item of the 3MF file contains no model"));
}

TEST(ThreeMfReader, ReadsClosedMeshesOfOtherTypesWithAWarning) {
  for (const std::string type : {"surface", "other"}) {
    const std::string box = boxObject(1, 1, 2, 3, "type=\"" + type + "\"");
    const auto soup = read3mf(threeMf(modelPart(box, "<item objectid=\"1\"/>")), {});
    ASSERT_TRUE(soup) << sentence(soup.error().message);
    EXPECT_EQ(volumeOf(*soup), 6);
    ASSERT_EQ(soup->warnings.size(), 1u);
    EXPECT_EQ(sentence(soup->warnings[0]),
              "1 item of the 3MF file is of type \"" + type + "\", but closed; it was read as a model");
    std::string open = box;
    open.erase(open.rfind("<triangle "), open.rfind("</triangles>") - open.rfind("<triangle "));
    EXPECT_EQ(errorOf(modelPart(open, "<item objectid=\"1\"/>")),
              "The only item of the 3MF file contains no model: object 1 is of type \"" + type +
                  "\", and its mesh is not closed");
  }
}

TEST(ThreeMfReader, ReadsClosedComponentsOfTypeSurface) {
  const std::string group =
      "<object id=\"5\"><components><component objectid=\"1\"/><component objectid=\"2\"/></components></object>";
  const std::string boxes = boxObject(1, 1, 2, 3) + boxObject(2, 1, 1, 1, "type=\"surface\"");
  EXPECT_EQ(read3mf(threeMf(modelPart(boxes + group, "<item objectid=\"5\"/>")), {})->triangles.size(), 24u);
  const std::string surfaces = group + "<object id=\"6\" type=\"surface\">" + group.substr(group.find("<components>"));
  EXPECT_EQ(read3mf(threeMf(modelPart(boxes + surfaces, "<item objectid=\"6\"/>")), {})->triangles.size(), 24u);
}

TEST(ThreeMfReader, RefusesCirclesAndDeepNestsOfSurfaces) {
  std::string objects = boxObject(1, 1, 1, 1, "type=\"surface\"");
  for (int id = 2; id < 5000; ++id)
    objects +=
        fmt::format("<object id=\"{}\" type=\"surface\"><components><component objectid=\"{}\"/></components></object>",
                    id, id - 1);
  EXPECT_THAT(errorOf(modelPart(objects, "<item objectid=\"4999\"/>")), HasSubstr("not closed"));
  EXPECT_THAT(errorOf(modelPart("<object id=\"1\" type=\"surface\"><components><component objectid=\"1\"/></components>"
                                "</object>",
                                "<item objectid=\"1\"/>")),
              HasSubstr("not closed"));
}

TEST(ThreeMfReader, ReadsNumbersWithBlanksAroundThem) {
  std::string model = modelPart(boxObject(1, 1, 2, 3), "<item objectid=\" 1\"/>", "unit=\" inch \"");
  for (const auto& [from, to] :
       {std::pair("x=\"", "x=\" "), std::pair("v2=\"", "v2=\"\n"), std::pair("id=\"1\"", "id=\"1 \"")})
    for (std::size_t at = model.find(from); at != std::string::npos; at = model.find(from, at + std::strlen(to)))
      model.replace(at, std::strlen(from), to);
  const auto soup = read3mf(threeMf(model), {});
  ASSERT_TRUE(soup) << sentence(soup.error().message);
  EXPECT_EQ(volumeOf(*soup), 6);
  EXPECT_EQ(soup->unitMm, 25.4);
}

TEST(ThreeMfReader, RefusesBeams) {
  std::string model = modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1\"/>",
                                "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\"");
  model.insert(model.find("</mesh>"),
               "<b:beamlattice radius=\"1\"><b:beams><b:beam v1=\"0\" v2=\"1\"/></b:beams></b:beamlattice>");
  EXPECT_THAT(errorOf(model), HasSubstr("object 1 in \"3D/3dmodel.model\" is a lattice of beams"));
}

TEST(ThreeMfReader, NamesTheExtensionThatHoldsAShape) {
  EXPECT_THAT(errorOf(modelPart("<object id=\"1\"><v:levelset/></object>", "<item objectid=\"1\"/>",
                                "xmlns:v=\"urn:volumetric\"")),
              HasSubstr("object 1: its shape is in the extension \"urn:volumetric\""));
}

TEST(ThreeMfReader, RefusesABuildWithoutItems) {
  EXPECT_THAT(errorOf(modelPart(boxObject(1, 1, 2, 3), "")),
              HasSubstr("build is empty: it has 1 object, but does not place it"));
}

TEST(ThreeMfReader, DistinguishesAMissingBuildFromAnEmptyOne) {
  std::string model = modelPart(boxObject(1, 1, 2, 3) + boxObject(2, 1, 2, 3), "");
  EXPECT_THAT(errorOf(model), HasSubstr("build is empty: it has 2 objects, but places none"));
  const std::size_t begin = model.find("<build"), end = model.find("</build>");
  ASSERT_NE(end, std::string::npos);
  model.erase(begin, end + 8 - begin);
  EXPECT_EQ(errorOf(model),
            "The 3MF file has no element \"build\", which places objects on the plate; it has 2 objects");
}

TEST(ThreeMfReader, NamesTheFirstIndexOutOfRangeAndItsLine) {
  const std::string object =
      "<object id=\"5\">\n<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/></vertices><triangles>\n"
      "<triangle v1=\"0\" v2=\"0\" v3=\"0\"/>\n<triangle v1=\"0\" v2=\"0\" v3=\"8\"/>\n"
      "<triangle v1=\"0\" v2=\"-1\" v3=\"0\"/></triangles></mesh></object>";
  const std::string model = modelPart(object, "<item objectid=\"5\"/>");
  const auto line =
      1 + std::count(model.begin(), model.begin() + static_cast<std::ptrdiff_t>(model.find("v3=\"8\"")), '\n');
  EXPECT_EQ(errorOf(model), fmt::format("Part \"3D/3dmodel.model\" of the 3MF file, line {}: object 5: triangle 2: it "
                                        "refers to vertex 8 (counted from 0), but there is only 1",
                                        line));
}

TEST(ThreeMfReader, RefusesAPackageWithoutTheModelItNames) {
  const auto messageOf = [](const std::vector<zip_file::File>& files) {
    return sentence(read3mf(zip_file::zip(files), {}).error().message);
  };
  EXPECT_THAT(messageOf({{"3D/3dmodel.model", "x"}}), HasSubstr("no part \"_rels/.rels\""));
  const auto rels = [](const std::string& relationships) {
    return zip_file::File{"_rels/.rels",
                          "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">" +
                              relationships + "</Relationships>"};
  };
  const std::string type = "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"";
  const std::string one = "<Relationship Target=\"/3D/3dmodel.model\" " + type + "/>";
  EXPECT_THAT(messageOf({rels("<Relationship Target=\"/a\" Type=\"b\"/>")}), HasSubstr("no relationship in"));
  EXPECT_THAT(messageOf({rels(one + one)}), HasSubstr("2 relationships"));
  EXPECT_THAT(messageOf({rels(one)}), HasSubstr("model part \"3D/3dmodel.model\" is missing"));
  EXPECT_THAT(messageOf({rels("<Relationship Target=\"http://a.b/c\" " + type + "/>")}),
              HasSubstr("names \"http://a.b/c\" as its 3D model, which is an address outside the file"));
  EXPECT_THAT(messageOf({rels("<Relationship TargetMode=\"External\" Target=\"c\" " + type + "/>")}),
              HasSubstr("names \"c\" as its 3D model, which is an address outside the file"));
  for (const char* target : {"/../3D/a.model", "/3D/../../a.model", "/%2e%2E/a.model", "..\\a.model"})
    EXPECT_THAT(messageOf({rels(fmt::format("<Relationship Target=\"{}\" {}/>", target, type))}),
                HasSubstr(fmt::format("names \"{}\" as its 3D model, a path that leads out of the file", target)));
  EXPECT_THAT(messageOf({rels("<Relationship Target=\"\" " + type + "/>")}), HasSubstr("has no target"));
}

TEST(ThreeMfReader, RefusesAFileThatIsNotAModel) {
  EXPECT_THAT(errorOf("<html/>"), HasSubstr("\"3D/3dmodel.model\" of the 3MF file, line 1: the outermost element"));
  EXPECT_THAT(errorOf("<model xmlns=\"urn:other\"/>"), HasSubstr("not a 3MF model"));
  EXPECT_THAT(errorOf("<!DOCTYPE model><model/>"), HasSubstr("DTD"));
}

TEST(ThreeMfReader, RefusesARequiredExtensionThatChangesTheGeometry) {
  EXPECT_THAT(errorOf(modelPart("", "", "xmlns:b=\"urn:lattice\" requiredextensions=\"b\"")),
              HasSubstr("requires the extension \"urn:lattice\""));
  EXPECT_THAT(errorOf(modelPart("", "", "requiredextensions=\"q\"")), HasSubstr("\"q\" is not declared"));
  EXPECT_TRUE(read3mf(threeMf(modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1\"/>",
                                        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
                                        "requiredextensions=\"m\"")),
                      {}));
}

/// Returns a box whose object tag has more attributes, in a model that declares the slice extension.
std::string slicedBox(const std::string& attributes, const std::string& required = "") {
  std::string object = boxObject(7, 1, 2, 3);
  object.insert(object.find("id="), attributes + " ");
  return modelPart("<s:slicestack id=\"3\" zbottom=\"0\"><s:slice ztop=\"1\"/></s:slicestack>" + object,
                   "<item objectid=\"7\"/>",
                   "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\" " + required);
}

TEST(ThreeMfReader, RefusesAMeshThatReplacesSlices) {
  EXPECT_THAT(errorOf(slicedBox("s:slicestackid=\"3\" s:meshresolution=\"lowres\"")),
              HasSubstr("object 7 in \"3D/3dmodel.model\" is a stack of slices"));
  EXPECT_THAT(errorOf(slicedBox("s:slicestackid=\"3\" s:meshresolution=\"lowres\"", "requiredextensions=\"s\"")),
              HasSubstr("stack of slices"));
}

TEST(ThreeMfReader, RefusesAComponentThatReplacesSlices) {
  std::string model = slicedBox("s:slicestackid=\"3\" s:meshresolution=\"lowres\"");
  const std::string outer = "<object id=\"8\"><components><component objectid=\"7\"/></components></object>";
  model.insert(model.find("</resources>"), outer);
  model.replace(model.find("item objectid=\"7\""), 17, "item objectid=\"8\"");
  EXPECT_THAT(errorOf(model), HasSubstr("object 7"));
}

TEST(ThreeMfReader, ReadsAFullMeshBesideSlices) {
  for (const char* required : {"", "requiredextensions=\"s\""}) {
    const auto soup = read3mf(threeMf(slicedBox("s:slicestackid=\"3\" s:meshresolution=\"fullres\"", required)), {});
    ASSERT_TRUE(soup) << sentence(soup.error().message);
    EXPECT_EQ(volumeOf(*soup), 6);
    EXPECT_THAT(sentence(soup->warnings.at(0)), HasSubstr("1 object of the 3MF file has slices as well as a mesh"));
  }
}

TEST(ThreeMfReader, RefusesABareBoxBesideSlices) {
  std::string model = slicedBox("s:slicestackid=\"3\"");
  EXPECT_THAT(errorOf(model), HasSubstr("object 7 in \"3D/3dmodel.model\" is a stack of slices"));
  const std::size_t corner = model.find("x=\"1\"");
  EXPECT_TRUE(read3mf(threeMf(model.replace(corner, 5, "x=\"0.9\"")), {}));  // no box any more: a full mesh
}

TEST(ThreeMfReader, NamesLineAndObjectOfMalformedContent) {
  const auto object = [](const std::string& content) {
    return errorOf(modelPart("<object id=\"5\">\n" + content + "</object>", "<item objectid=\"5\"/>"));
  };
  const std::string vertices = "<vertices><vertex x=\"0\" y=\"0\" z=\"0\"/></vertices>";
  EXPECT_THAT(object("<mesh><vertices><vertex x=\"0\" y=\"1,5\" z=\"0\"/></vertices></mesh>"),
              HasSubstr("line 5: object 5: vertex 1: \"1,5\" has a decimal comma"));
  EXPECT_THAT(object("<mesh><vertices><vertex x=\"0\" z=\"0\"/></vertices></mesh>"),
              HasSubstr("vertex 1: it has no y"));
  EXPECT_THAT(object("<mesh><vertices><vertex x=\"0\" y=\"inf\" z=\"0\"/></vertices></mesh>"), HasSubstr("not finite"));
  EXPECT_THAT(object("<mesh>" + vertices + "<triangles><triangle v1=\"0\" v2=\"0\" v3=\"1\"/></triangles></mesh>"),
              HasSubstr("object 5: triangle 1: it refers to vertex 1 (counted from 0), but there is only 1"));
  EXPECT_THAT(object("<mesh>" + vertices + "<triangles><triangle v1=\"0\" v2=\"-1\" v3=\"0\"/></triangles></mesh>"),
              HasSubstr("triangle 1: it refers to vertex -1 (counted from 0), but there is only 1"));
  EXPECT_THAT(object("<mesh>" + vertices + "<triangles><triangle v1=\"0\" v3=\"0\"/></triangles></mesh>"),
              HasSubstr("triangle 1: it has no v2"));
  EXPECT_THAT(object(""), HasSubstr("neither a mesh nor components"));
  EXPECT_THAT(object("<mesh/><mesh/>"), HasSubstr("more than one mesh"));
}

TEST(ThreeMfReader, RefusesBadIds) {
  EXPECT_THAT(errorOf(modelPart("<object id=\"0\"/>", "")), HasSubstr("\"0\" is not a valid id"));
  EXPECT_THAT(errorOf(modelPart("<object/>", "")), HasSubstr("\"object\" has no id"));
  EXPECT_THAT(errorOf(modelPart("", "<item/>")), HasSubstr("\"item\" has no objectid"));
  EXPECT_THAT(errorOf(modelPart(boxObject(3, 1, 1, 1) + boxObject(3, 1, 1, 1), "")),
              HasSubstr("object 3: two objects have this id"));
  EXPECT_THAT(errorOf(modelPart("", "<item objectid=\"4\"/>")),
              HasSubstr("refers to object 4 of part \"3D/3dmodel.model\", which is missing"));
}

TEST(ThreeMfReader, RefusesBadTransforms) {
  const auto item = [](const std::string& transform) {
    return errorOf(modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1\" transform=\"" + transform + "\"/>"));
  };
  EXPECT_THAT(item("1 0 0 0 1 0 0 0 1 0 0"), HasSubstr("a number is missing"));
  EXPECT_THAT(item("1 0 0 0 1 0 0 0 1 0 0 0 0"), HasSubstr("more than 12 numbers"));
  EXPECT_THAT(item("1 0 0 0 1 0 0 0 nan 0 0 0"), HasSubstr("the transform"));
  EXPECT_THAT(item("1 0 0 0 1 0 0 0 0 0 0 0"), HasSubstr("flattens the object"));
  EXPECT_THAT(item("1 0 0 0 1 0 0 0 1 1e305 0 0"), HasSubstr("out of range"));
}

TEST(ThreeMfReader, RefusesComponentsThatContainThemselves) {
  EXPECT_THAT(errorOf(modelPart("<object id=\"1\"><components><component objectid=\"2\"/></components></object>"
                                "<object id=\"2\"><components><component objectid=\"1\"/></components></object>",
                                "<item objectid=\"1\"/>")),
              HasSubstr("is a component of itself"));
}

/// Returns nested objects: object 1 is `first`, each further one holds `width` copies of the one before.
std::string tower(int depth, int width, const std::string& first) {
  std::string resources = first;
  for (int level = 2; level <= depth; ++level) {
    resources += fmt::format("<object id=\"{}\"><components>", level);
    for (int k = 0; k < width; ++k) resources += fmt::format("<component objectid=\"{}\"/>", level - 1);
    resources += "</components></object>";
  }
  return modelPart(resources, fmt::format("<item objectid=\"{}\"/>", depth));
}

TEST(ThreeMfReader, LimitsHowDeepComponentsNest) {
  EXPECT_TRUE(read3mf(threeMf(tower(32, 1, boxObject(1, 1, 1, 1))), {}));
  EXPECT_THAT(errorOf(tower(33, 1, boxObject(1, 1, 1, 1))), HasSubstr("more than 32 deep"));
  EXPECT_THAT(errorOf(tower(5000, 1, boxObject(1, 1, 1, 1))), HasSubstr("more than 32 deep"));
}

TEST(ThreeMfReader, LimitsTheTrianglesThatComponentsMultiplyTo) {
  // 10 levels of 100 give 10^18 boxes; the reader refuses them before it makes any.
  EXPECT_THAT(errorOf(tower(10, 100, boxObject(1, 1, 1, 1))), HasSubstr("more than 100000 objects"));
  EXPECT_THAT(errorOf(tower(10, 100, "<object id=\"1\"><mesh><vertices/><triangles/></mesh></object>")),
              HasSubstr("more than 100000 objects"));
  EXPECT_TRUE(read3mf(threeMf(tower(3, 10, boxObject(1, 1, 1, 1))), {.maxTriangles = 1200}));
  EXPECT_THAT(errorOf(tower(3, 10, boxObject(1, 1, 1, 1)), {.maxTriangles = 1199}), HasSubstr("1199 triangles"));
}

TEST(ThreeMfReader, LimitsTrianglesVerticesAndEntries) {
  EXPECT_THAT(errorOf(modelPart(boxObject(1, 1, 1, 1), "<item objectid=\"1\"/>"), {.maxTriangles = 11}),
              HasSubstr("11 triangles"));
  EXPECT_THAT(errorOf(modelPart(boxObject(1, 1, 1, 1), "<item objectid=\"1\"/>"), {.maxTriangles = 2}),
              HasSubstr("2 triangles"));
  std::string items;
  for (int i = 0; i < 100'000; ++i) items += "<item objectid=\"1\"/>";
  EXPECT_THAT(errorOf(modelPart(boxObject(1, 1, 1, 1), items)), HasSubstr("more than 100000 objects, components"));
}

TEST(ThreeMfReader, LimitsTheExpandedSizeOfTheArchive) {
  const auto bytes = threeMf(modelPart(boxObject(1, 1, 1, 1), "<item objectid=\"1\"/>"));
  EXPECT_TRUE(read3mf(bytes, {.maxExpandedBytes = bytes.size()}));
  EXPECT_THAT(sentence(read3mf(bytes, {.maxExpandedBytes = 1000}).error().message), HasSubstr("would expand"));
}

TEST(ThreeMfReader, SurvivesAChangeOfEveryByteOfTheModel) {
  const std::string model = modelPart(boxObject(1, 1, 2, 3) +
                                          "<object id=\"2\"><components><component objectid=\"1\" "
                                          "transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components></object>",
                                      "<item objectid=\"2\" p:path=\"/3D/3dmodel.model\"/>", kProduction);
  for (std::size_t at = 0; at < model.size(); ++at)
    for (const char change : {'\0', '\xff', '9', '-', '"', '<', '/', ' '}) {
      std::string text = model;
      text[at] = change;
      const auto soup = read3mf(threeMf(text), {});
      if (!soup) {
        ASSERT_EQ(soup.error().kind, ErrorKind::BadInput);
        ASSERT_FALSE(sentence(soup.error().message).empty());
        continue;
      }
      for (const Triangle& t : soup->triangles)
        for (const std::uint32_t v : t) ASSERT_LT(v, soup->positions.size());
      for (const Vec3& p : soup->positions) ASSERT_TRUE(std::isfinite(glm::length(p)));
    }
}

TEST(ThreeMfReader, SurvivesEveryTruncationOfTheModel) {
  const std::string model = modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1\"/>");
  for (std::size_t size = 0; size + 2 < model.size(); ++size) {
    const auto soup = read3mf(threeMf(model.substr(0, size)), {});
    ASSERT_FALSE(soup) << size;
    ASSERT_EQ(soup.error().kind, ErrorKind::BadInput);
  }
}

}  // namespace
}  // namespace qrelief
