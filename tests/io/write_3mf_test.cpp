// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/write_3mf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/read_model.h"
#include "io/write_checked.h"
#include "io/zip_archive.h"
#include "messages/sentences.h"
#include "support/shapes.h"
#include "support/slicer_rules.h"

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
  EXPECT_THAT(model, HasSubstr("<object id=\"3\" name=\"body\" type=\"model\" pid=\"1\" pindex=\"0\">"));
  EXPECT_THAT(model, HasSubstr("<object id=\"4\" name=\"QR inlay\" type=\"model\" pid=\"2\" pindex=\"0\">"));
  EXPECT_THAT(model, HasSubstr("<object id=\"5\" name=\"plate\" type=\"model\">\n   <components>\n"
                               "    <component objectid=\"3\"/>\n    <component objectid=\"4\"/>\n"));
  EXPECT_THAT(model, HasSubstr("<object id=\"6\" name=\"beside\" type=\"model\" pid=\"1\" pindex=\"0\">"));
  EXPECT_THAT(model, HasSubstr("<build>\n  <item objectid=\"5\"/>\n  <item objectid=\"6\"/>\n </build>"));
  EXPECT_THAT(model, HasSubstr("unit=\"millimeter\""));
}

TEST(Write3mf, TurnsAllObjectsTogetherToTheirPoseOnThePrinter) {
  std::vector<ModelObject> objects = inlaidPlate();  // 30 × 30 × 4 mm, and a cube from x = 38.5 to 41.5
  for (ModelObject& object : objects) object.up = {1, 0, 0};
  for (const Slicer slicer : {Slicer::Any, Slicer::PrusaSlicer, Slicer::OrcaSlicer, Slicer::BambuStudio}) {
    const auto bytes = writeChecked(objects, ModelFormat::ThreeMf, {.slicer = slicer});
    ASSERT_TRUE(bytes) << sentence(bytes.error().message);
    const auto soup = readModel(*bytes, "turned.3mf");
    ASSERT_TRUE(soup);
    Box3 box;
    for (const Vec3 p : soup->positions) box.add(p);
    EXPECT_NEAR(glm::distance(box.size(), Vec3(4, 30, 56.5)), 0, 1e-5);
    const bool isInTheMiddle = slicer == Slicer::OrcaSlicer || slicer == Slicer::BambuStudio;
    const Vec3 foot = {box.centre().x, box.centre().y, box.min.z};
    EXPECT_NEAR(glm::distance(foot, isInTheMiddle ? Vec3(128, 128, 0) : Vec3(13.25, 0, 0)), 0, 1e-5);
  }
}

TEST(Write3mf, WritesPlacesAndTypesOfObjects) {
  const std::vector<ModelObject> objects = {
      {"A", {{"", shapes::box({1, 1, 1}), {}}}, "https://example.org/?a=1&b=<2>", {0.1, 20, -3}},
      {"B", {{"", shapes::box({1, 1, 1}), {}}}}};
  const auto bytes = writeChecked(objects, ModelFormat::ThreeMf);
  ASSERT_TRUE(bytes);
  EXPECT_THAT(
      partOf(*bytes, "3D/3dmodel.model"),
      HasSubstr("  <item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0.1 20 -3\">\n   <metadatagroup><metadata "
                "name=\"Description\">https://example.org/?a=1&amp;b=&lt;2&gt;</metadata></metadatagroup>\n"
                "  </item>\n  <item objectid=\"2\"/>\n"));
}

TEST(Write3mf, WritesOneColourGroupForEachColour) {
  const std::string model = partOf(*write3mf(inlaidPlate(), {}), "3D/3dmodel.model");
  EXPECT_THAT(model, HasSubstr("xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\""));
  EXPECT_THAT(model, HasSubstr("requiredextensions=\"m\""));
  EXPECT_THAT(model, HasSubstr("<m:colorgroup id=\"1\">\n   <m:color color=\"#FFFFFFFF\"/>\n  </m:colorgroup>\n"
                               "  <m:colorgroup id=\"2\">\n   <m:color color=\"#10000AFF\"/>\n  </m:colorgroup>"));
  EXPECT_THAT(model, HasSubstr("<metadata name=\"cura:extruder_nr\" preserve=\"1\" type=\"xs:integer\">0</metadata>"));
  EXPECT_THAT(model, HasSubstr("<metadata name=\"cura:extruder_nr\" preserve=\"1\" type=\"xs:integer\">1</metadata>"));
}

/// Returns a plate with two painted facets, and a separate box next to it.
std::vector<ModelObject> paintedPlate() {
  return {{"plate", {{"body", shapes::box({30, 30, 4}), kWhite, FacetPaint{kBlack, {2, 7}}}}},
          {"beside", {{"", shapes::translated(shapes::box({3, 3, 3}), {40, 0, 0}), {}}}}};
}

TEST(Write3mf, NamesTheMaterialsInAFileForAnySlicerOnly) {
  std::vector<ModelObject> objects = inlaidPlate();
  objects[0].bodies[0].material = "White & matte";
  const std::string model = partOf(*write3mf(objects, {}), "3D/3dmodel.model");
  EXPECT_THAT(model, HasSubstr("</m:colorgroup>\n  <basematerials id=\"7\">\n"
                               "   <base name=\"White &amp; matte\" displaycolor=\"#FFFFFFFF\"/>\n"
                               "   <base name=\"Filament 2\" displaycolor=\"#10000AFF\"/>\n  </basematerials>\n"));
  for (const char* other : {"id=\"7\" ", "pid=\"7\""}) EXPECT_THAT(model, Not(HasSubstr(other)));
  for (const Slicer slicer : {Slicer::PrusaSlicer, Slicer::OrcaSlicer, Slicer::BambuStudio})
    EXPECT_THAT(partOf(*write3mf(objects, {.slicer = slicer}), "3D/3dmodel.model"), Not(HasSubstr("basematerials")));
}

TEST(Write3mf, KeepsTheFilamentsThatBodiesHave) {
  std::vector<ModelObject> objects = {
      {"sign", {{"plate", shapes::box({30, 30, 4}), {}}, {"text", shapes::box({3, 3, 5}), {}}}}};
  objects[0].bodies[0].filament = 3;
  objects[0].bodies[1].filament = 1;
  const auto bytes = write3mf(objects, {});
  EXPECT_THAT(partOf(*bytes, "Metadata/model_settings.config"),
              HasSubstr("value=\"plate\"/>\n   <metadata key=\"extruder\" value=\"3\"/>"));
  EXPECT_THAT(partOf(*bytes, "Metadata/model_settings.config"),
              HasSubstr("value=\"text\"/>\n   <metadata key=\"extruder\" value=\"1\"/>"));
  EXPECT_THAT(partOf(*bytes, "3D/3dmodel.model"), HasSubstr("<m:colorgroup id=\"3\">"));
}

TEST(Write3mf, NamesTheMaterialOfPaint) {
  std::vector<ModelObject> objects = paintedPlate();
  objects[0].bodies[0].paint->material = "QR code";
  EXPECT_THAT(partOf(*write3mf(objects, {}), "3D/3dmodel.model"),
              HasSubstr("<base name=\"QR code\" displaycolor=\"#10000AFF\"/>"));
}

using slicer_rules::Project;
using slicer_rules::PrusaVersion;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Expects the bodies as volumes, in order, at their places up to one move of everything.
void expectVolumes(const Project& project, const std::vector<ModelObject>& objects) {
  ASSERT_EQ(project.refused, "");
  ASSERT_EQ(project.objects.size(), objects.size());
  const Vec3 move = project.objects[0].volumes.at(0).triangles.at(0)[0] - Vec3(objects[0].bodies[0].mesh.corner(0, 0));
  for (std::size_t o = 0; o < objects.size(); ++o) {
    ASSERT_EQ(project.objects[o].volumes.size(), objects[o].bodies.size());
    for (std::size_t b = 0; b < objects[o].bodies.size(); ++b) {
      const Mesh& mesh = objects[o].bodies[b].mesh;
      const auto& triangles = project.objects[o].volumes[b].triangles;
      ASSERT_EQ(triangles.size(), mesh.triangles.size());
      for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
          EXPECT_LT(glm::length(triangles[t][static_cast<std::size_t>(k)] - move - Vec3(mesh.corner(t, k))), 1e-5);
    }
  }
}

void expectInlaidPlate(const Project& project) {
  expectVolumes(project, inlaidPlate());
  EXPECT_EQ(project.objects[0].name, "plate");
  EXPECT_EQ(project.objects[1].name, "beside");
  const auto& volumes = project.objects[0].volumes;
  EXPECT_EQ(volumes[0].name, "body");
  EXPECT_EQ(volumes[1].name, "QR inlay");
  EXPECT_EQ(volumes[0].filament, 1u);
  EXPECT_EQ(volumes[1].filament, 2u);
  EXPECT_EQ(project.objects[1].volumes[0].filament, 1u);
}

void expectPaintedPlate(const Project& project) {
  expectVolumes(project, paintedPlate());
  const auto& volume = project.objects[0].volumes[0];
  EXPECT_EQ(volume.filament, 1u);
  EXPECT_THAT(volume.paint, ElementsAre(0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0));
  EXPECT_THAT(project.filaments(), ElementsAre(1, 2));
}

TEST(Write3mf, PrusaSlicerOpensItsFileWithTwoVolumesAndAsksNothing) {
  const Bytes bytes = *writeChecked(inlaidPlate(), ModelFormat::ThreeMf, {.slicer = Slicer::PrusaSlicer});
  for (const PrusaVersion version : {PrusaVersion::V2_5, PrusaVersion::V2_9}) {
    const Project project = openInPrusaSlicer(bytes, version);
    expectInlaidPlate(project);
    EXPECT_EQ(project.objects[0].volumes[1].kind, "ModelPart");
  }
  const std::vector<ModelObject> one = {inlaidPlate().front()};
  EXPECT_FALSE(openInPrusaSlicer(*write3mf(one, {.slicer = Slicer::PrusaSlicer}), PrusaVersion::V2_5).asksAboutParts);
  // Two objects at several heights are always asked about; here both lie on the plate.
  EXPECT_THAT(partOf(bytes, "3D/3dmodel.model"), Not(HasSubstr("m:")));
}

TEST(Write3mf, PrusaSlicerKeepsThePaintOfItsFile) {
  const Bytes bytes = *writeChecked(paintedPlate(), ModelFormat::ThreeMf, {.slicer = Slicer::PrusaSlicer});
  for (const PrusaVersion version : {PrusaVersion::V2_5, PrusaVersion::V2_9})
    expectPaintedPlate(openInPrusaSlicer(bytes, version));
}

TEST(Write3mf, OrcaSlicerAndBambuStudioOpenTheirFilesInTheMiddleOfThePlate) {
  for (const Slicer slicer : {Slicer::OrcaSlicer, Slicer::BambuStudio}) {
    const Bytes bytes = *writeChecked(inlaidPlate(), ModelFormat::ThreeMf, {.slicer = slicer});
    const Project project = slicer_rules::openInBambuStudio(bytes);
    expectInlaidPlate(project);
    EXPECT_EQ(project.objects[0].volumes[1].kind, "normal_part");
    EXPECT_THAT(project.filamentColours, IsEmpty());
    Box3 box;
    for (const auto& object : project.objects)
      for (const auto& volume : object.volumes)
        for (const auto& corners : volume.triangles)
          for (const Vec3& p : corners) box.add(p);
    EXPECT_NEAR(box.centre().x, 128, 1e-5);
    EXPECT_NEAR(box.centre().y, 128, 1e-5);
    EXPECT_NEAR(box.min.z, 0, 1e-5);
    EXPECT_EQ(partOf(bytes, "Metadata/Slic3r_PE_model.config"), "");
    expectPaintedPlate(
        slicer_rules::openInBambuStudio(*writeChecked(paintedPlate(), ModelFormat::ThreeMf, {.slicer = slicer})));
  }
}

TEST(Write3mf, ThePaletteListsTheColoursInTheNameOfBambuStudio) {
  const Bytes bytes =
      *writeChecked(inlaidPlate(), ModelFormat::ThreeMf, {.slicer = Slicer::BambuStudio, .palette = true});
  const Project project = slicer_rules::openInBambuStudio(bytes);
  expectInlaidPlate(project);
  EXPECT_THAT(project.filamentColours, ElementsAre("#FFFFFF", "#10000A"));
  EXPECT_THAT(partOf(bytes, "3D/3dmodel.model"),
              HasSubstr("<metadata name=\"Application\">BambuStudio-02.00.00.00</metadata>"));
  for (const Slicer slicer : {Slicer::Any, Slicer::PrusaSlicer}) {
    const auto refused = writeModel(inlaidPlate(), ModelFormat::ThreeMf, {.slicer = slicer, .palette = true});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::BadUsage);
  }
}

TEST(Write3mf, AFileForAnySlicerOpensWithTwoFilamentsInAllOfThem) {
  const Bytes inlaid = *writeChecked(inlaidPlate(), ModelFormat::ThreeMf);
  expectInlaidPlate(slicer_rules::openInBambuStudio(inlaid));
  for (const PrusaVersion version : {PrusaVersion::V2_5, PrusaVersion::V2_9}) {
    const Project project = openInPrusaSlicer(inlaid, version);
    EXPECT_THAT(project.filaments(), ElementsAre(1, 2));
    EXPECT_EQ(project.objects.size(), 3u);  // after a yes to its question, two of them are parts of one
    EXPECT_TRUE(project.asksAboutParts);
  }
  const Bytes painted = *writeChecked(paintedPlate(), ModelFormat::ThreeMf);
  expectPaintedPlate(slicer_rules::openInBambuStudio(painted));
  expectPaintedPlate(openInPrusaSlicer(painted, PrusaVersion::V2_9));
}

TEST(Write3mf, OnlyOneOfTheFormatsHoldsPaint) {
  for (const ModelFormat format : {ModelFormat::Stl, ModelFormat::Obj, ModelFormat::Ply})
    EXPECT_EQ(writeModel(paintedPlate(), format).error().kind, ErrorKind::BadUsage);
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
