// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/rewrite_3mf.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/three_mf/read_3mf.h"
#include "io/three_mf/text.h"
#include "messages/sentences.h"
#include "support/shapes.h"
#include "support/slicer_rules.h"
#include "support/xml_document.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using zip_file::boxObject;
using zip_file::File;
using What = KeptAttributes::What;

const std::array<Material, 2> kMaterials = {{{"model", {250, 240, 230}}, {"QR code", {1, 2, 3}}}};

constexpr const char* kSpaces =
    "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
    "xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\"";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// Returns a file as Bambu Studio writes it: two objects on plates, each in a part file, with a modifier, and paint.
std::vector<std::uint8_t> bambuProject() {
  const auto part = [](int body, int modifier) {
    std::string box = boxObject(body, 10, 20, 30);
    box = replaced(box, "<triangle ", "<triangle paint_color=\"8\" paint_seam=\"4\" ");
    return zip_file::modelPart(box + boxObject(modifier, 3, 3, 3, "type=\"other\""), "");
  };
  const std::string root = zip_file::modelPart(
      "<object id=\"3\" p:UUID=\"00000001-61cb-4c03-9d28-80fed5dfa1dc\" type=\"model\"><components>"
      "<component p:path=\"/3D/Objects/a.model\" objectid=\"1\" p:UUID=\"00010000-b206-40ff-9872-83e8017abed1\" "
      "transform=\"1 0 0 0 1 0 0 0 1 5 6 7\"/>"
      "<component p:path=\"/3D/Objects/a.model\" objectid=\"2\"/></components></object>"
      "<object id=\"6\" type=\"model\"><components><component p:path=\"/3D/Objects/b.model\" objectid=\"4\"/>"
      "<component p:path=\"/3D/Objects/b.model\" objectid=\"5\"/></components></object>",
      "<item objectid=\"3\" transform=\"0 1 0 -1 0 0 0 0 1 128 100.5 0\"/><item objectid=\"6\"/>", kSpaces);
  const std::string settings =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<config>\n"
      "  <object id=\"3\">\n    <metadata key=\"name\" value=\"lid &amp; box\"/>\n"
      "    <metadata key=\"extruder\" value=\"2\"/>\n    <part id=\"1\" subtype=\"normal_part\">\n"
      "      <metadata key=\"name\" value=\"lid\"/>\n      <metadata key=\"matrix\" value=\"1 0 0 5 0 1 0 6 0 0 1 7 0 "
      "0 0 1\"/>\n"
      "    </part>\n    <part id=\"2\" subtype=\"modifier_part\">\n    </part>\n  </object>\n"
      "  <object id=\"6\">\n    <part id=\"4\" subtype=\"normal_part\">\n    </part>\n"
      "    <part id=\"5\" subtype=\"support_blocker\">\n    </part>\n  </object>\n"
      "  <plate>\n    <metadata key=\"plater_id\" value=\"1\"/>\n  </plate>\n</config>\n";
  return zip_file::threeMf(root,
                           {{"3D/Objects/a.model", part(1, 2)},
                            {"3D/Objects/b.model", part(4, 5)},
                            {"3D/_rels/3dmodel.model.rels",
                             "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
                             "<Relationship Target=\"/3D/Objects/a.model\"/>"
                             "<Relationship Target=\"/3D/Objects/b.model\"/></Relationships>"},
                            {"Metadata/model_settings.config", settings},
                            {"Metadata/plate_1.png", std::string("\x89PNG\0\1", 6)}});
}

/// Returns a file as PrusaSlicer writes it: one mesh with a volume, a modifier and another volume.
std::vector<std::uint8_t> prusaProject() {
  std::string mesh = boxObject(1, 10, 20, 30);
  mesh = replaced(mesh, "<triangle ", "<triangle slic3rpe:mmu_segmentation=\"0C\" ");
  return zip_file::threeMf(
      zip_file::modelPart(mesh, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 9 9 9\"/>", kSpaces),
      {{"Metadata/Slic3r_PE_model.config",
        "<config>\n <object id=\"1\" instances_count=\"1\">\n  <metadata type=\"object\" key=\"extruder\" "
        "value=\"1\"/>\n"
        "  <volume firstid=\"0\" lastid=\"5\">\n  <metadata type=\"volume\" key=\"volume_type\" value=\"ModelPart\"/>\n"
        "  </volume>\n  <volume firstid=\"6\" lastid=\"7\">\n"
        "   <metadata type=\"volume\" key=\"volume_type\" value=\"ParameterModifier\"/>\n  </volume>\n"
        "  <volume firstid=\"8\" lastid=\"11\">\n   <metadata type=\"volume\" key=\"extruder\" value=\"3\"/>\n"
        "  </volume>\n </object>\n</config>\n"},
       {"Metadata/Slic3r_PE.config", "; layer_height = 0.15\n"}});
}

PolygonSoup soupOf(const std::vector<std::uint8_t>& bytes) {
  auto soup = read3mf(bytes, {});
  EXPECT_TRUE(soup) << sentence(soup.error().message);
  return soup ? *soup : PolygonSoup();
}

/// Returns a run's mesh as it was, each triangle with its attributes.
ChangedRun sameRun(const PolygonSoup& soup, std::size_t run) {
  ChangedRun change;
  change.run = run;
  const ThreeMfRun& from = soup.source->runs[run];
  for (std::size_t t = from.firstTriangle; t < from.firstTriangle + from.count; ++t) {
    const auto first = static_cast<std::uint32_t>(change.mesh.positions.size());
    for (const std::uint32_t v : soup.triangles[t]) change.mesh.positions.emplace_back(soup.positions[v]);
    change.mesh.triangles.push_back({first, first + 1, first + 2});
    change.kept.push_back({What::All, static_cast<std::uint32_t>(t)});
  }
  return change;
}

/// Returns the change and a new triangle, which keeps nothing.
ChangedRun withOneMore(ChangedRun change) {
  const auto first = static_cast<std::uint32_t>(change.mesh.positions.size());
  for (const Vec3f p : {Vec3f(100.1f, 110.3f, 7), Vec3f(101, 110, 8), Vec3f(102, 112, 9)})
    change.mesh.positions.push_back(p);
  change.mesh.triangles.push_back({first, first + 1, first + 2});
  change.kept.push_back({});
  return change;
}

TEST(Rewrite3mf, KeepsAllOtherPartsOfABambuProjectByteForByte) {
  const auto bytes = bambuProject();
  const PolygonSoup soup = soupOf(bytes);
  ASSERT_EQ(soup.source->runs.size(), 2u);
  const std::vector<ChangedRun> changes = {withOneMore(sameRun(soup, 0))};
  const auto written = rewrite3mf(*soup.source, changes, Slicer::Any, kMaterials);
  ASSERT_TRUE(written) << sentence(written.error().message);
  auto before = unzipped(bytes), after = unzipped(*written);
  EXPECT_EQ(after.size(), before.size());
  for (const auto& [name, text] : before)
    if (name != "3D/Objects/a.model") {
      EXPECT_EQ(after[name], text) << name;
    }
  // In the changed part, the modifier's object is the same, too, and so is the paint.
  const std::string modifier = boxObject(2, 3, 3, 3, "type=\"other\"");
  EXPECT_THAT(after["3D/Objects/a.model"], HasSubstr(modifier));
  EXPECT_THAT(after["3D/Objects/a.model"], HasSubstr("paint_color=\"8\" paint_seam=\"4\""));
  EXPECT_EQ(soupOf(*written).triangles.size(), soup.triangles.size() + 1);
}

TEST(Rewrite3mf, TurnsTheItemThatChangesAndNoOther) {
  for (const auto& bytes : {bambuProject(), prusaProject()}) {
    const PolygonSoup soup = soupOf(bytes);
    const std::vector<ChangedRun> changes = {sameRun(soup, 0)};
    const auto written = rewrite3mf(*soup.source, changes, Slicer::Any, kMaterials, {0, 1, 0});
    ASSERT_TRUE(written) << sentence(written.error().message);
    const PolygonSoup turned = soupOf(*written);
    ASSERT_EQ(turned.triangles.size(), soup.triangles.size());
    Box3 before, after;
    for (const ThreeMfRun& run : soup.source->runs) {
      const bool isTurned = run.item == soup.source->runs[0].item;
      for (std::size_t t = run.firstTriangle; t < run.firstTriangle + run.count; ++t)
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3 then = soup.positions[soup.triangles[t][k]], now = turned.positions[turned.triangles[t][k]];
          if (isTurned) {
            before.add(then);
            after.add(now);
          } else {
            EXPECT_EQ(now, then);
          }
        }
    }
    const Vec3 size = before.size();
    EXPECT_NEAR(glm::distance(after.size(), Vec3(size.x, size.z, size.y)), 0, 1e-4);
    EXPECT_NEAR(after.min.z, before.min.z, 1e-4);
    EXPECT_NEAR(after.centre().x, before.centre().x, 1e-4);
    EXPECT_NEAR(after.centre().y, before.centre().y, 1e-4);
  }
}

TEST(Rewrite3mf, MovesATurnedItemClearOfItsNeighbour) {
  const std::string post = boxObject(1, 10, 10, 40), cube = boxObject(2, 10, 10, 10);
  const PolygonSoup soup = soupOf(zip_file::threeMf(zip_file::modelPart(
      post + cube, "<item objectid=\"1\"/><item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 15 0 0\"/>", "")));
  const std::vector<ChangedRun> changes = {sameRun(soup, 0)};
  const auto boxOf = [](const PolygonSoup& read, const ThreeMfRun& run) {
    Box3 box;
    for (std::size_t t = run.firstTriangle; t < run.firstTriangle + run.count; ++t)
      for (const std::uint32_t v : read.triangles[t]) box.add(read.positions[v]);
    return box;
  };
  const auto written = rewrite3mf(*soup.source, changes, Slicer::Any, kMaterials, {1, 0, 0});
  ASSERT_TRUE(written) << sentence(written.error().message);
  const PolygonSoup turned = soupOf(*written);
  const Box3 moved = boxOf(turned, soup.source->runs[0]), other = boxOf(turned, soup.source->runs[1]);
  EXPECT_NEAR(moved.size().x, 40, 1e-4);
  EXPECT_NEAR(moved.min.x, other.max.x + 5, 1e-4);
}

TEST(Rewrite3mf, AddsAnInlayAsAPartOfABambuObject) {
  const PolygonSoup soup = soupOf(bambuProject());
  ChangedRun change = sameRun(soup, 0);
  change.inlay = ModelBody{"QR code", shapes::translated(shapes::box({1, 1, 1}), {110, 110, 9}), {}};
  const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::BambuStudio, kMaterials);
  ASSERT_TRUE(written) << sentence(written.error().message);
  const auto project = slicer_rules::openInBambuStudio(*written);
  ASSERT_EQ(project.objects.size(), 2u);
  const auto& volumes = project.objects[0].volumes;
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_EQ(project.objects[0].name, "lid & box");
  EXPECT_EQ(volumes[0].name, "lid");
  EXPECT_EQ(volumes[0].filament, 2u);
  EXPECT_EQ(volumes[0].paint[0], 2u);
  EXPECT_EQ(volumes[1].name, "QR code");
  EXPECT_EQ(volumes[1].filament, 1u);  // the object has 2
  EXPECT_EQ(volumes[1].kind, "normal_part");
  EXPECT_LT(glm::length(volumes[1].triangles[0][0] - Vec3(change.inlay->mesh.corner(0, 0))), 1e-5);
  EXPECT_EQ(volumes[2].kind, "modifier_part");
  EXPECT_EQ(project.objects[1].volumes[1].kind, "support_blocker");
  // PrusaSlicer's file would need its own settings.
  const auto refused = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::PrusaSlicer, kMaterials);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::NoSolution);
}

/// Writes a file again with an inlay in its first run.
std::vector<std::uint8_t> withInlay(const std::vector<std::uint8_t>& bytes) {
  const PolygonSoup soup = soupOf(bytes);
  ChangedRun change = sameRun(soup, 0);
  change.inlay = ModelBody{"QR code", shapes::box({1, 1, 1}), {}};
  const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials);
  EXPECT_TRUE(written) << sentence(written.error().message);
  return written ? *written : std::vector<std::uint8_t>();
}

TEST(Rewrite3mf, AddsAPartToAnObjectWhoseComponentsAreInThePartFile) {
  const std::string part =
      zip_file::modelPart(boxObject(1, 10, 20, 30) +
                              "<object id=\"2\" p:UUID=\"00000002-61cb-4c03-9d28-80fed5dfa1dc\" type=\"model\">"
                              "<components><component objectid=\"1\" p:UUID=\"00000001-b206-40ff-9872-83e8017abed1\"/>"
                              "</components></object>",
                          "", kSpaces);
  const auto bytes = zip_file::threeMf(
      zip_file::modelPart("", "<item objectid=\"2\" p:path=\"/3D/Objects/tower_1.model\"/>", kSpaces),
      {{"3D/Objects/tower_1.model", part},
       {"3D/_rels/3dmodel.model.rels",
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/Objects/tower_1.model\"/></Relationships>"},
       {"Metadata/plate_1.json", "{}"},
       {"Metadata/model_settings.config",
        "<config><object id=\"2\"><part id=\"1\" subtype=\"normal_part\"></part></object></config>"}});
  const auto written = withInlay(bytes);
  auto before = unzipped(bytes), after = unzipped(written);
  for (const char* name : {"3D/3dmodel.model", "Metadata/plate_1.json", "3D/_rels/3dmodel.model.rels"})
    EXPECT_EQ(after[name], before[name]) << name;
  EXPECT_THAT(after["3D/Objects/tower_1.model"],
              HasSubstr("<component objectid=\"3\" p:UUID=\"00000003-b206-40ff-9872-83e8017abed1\"/>"));
  EXPECT_THAT(after["Metadata/model_settings.config"], HasSubstr("<part id=\"3\" subtype=\"normal_part\">"));
  EXPECT_EQ(soupOf(written).triangles.size(), 24u);
}

/// Returns a file of the production extension as a CAD program writes it, without settings of a slicer.
std::vector<std::uint8_t> plainFile() {
  const std::string box =
      boxObject(7, 10, 20, 30, "name=\"lid &amp; box\" p:UUID=\"aaaaaaaa-61cb-4c03-9d28-80fed5dfa1dc\"");
  return zip_file::threeMf(
      zip_file::modelPart("", "<item objectid=\"7\" p:path=\"/3D/lid.model\" partnumber=\"P1\"/>", kSpaces),
      {{"3D/lid.model", zip_file::modelPart(box, "", kSpaces)},
       {"3D/_rels/3dmodel.model.rels",
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/lid.model\"/></Relationships>"},
       {"[Content_Types].xml",
        "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default Extension=\"model\" "
        "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
       {"Thumbnails/lid.png", std::string("\x89PNG\0\1", 6)}});
}

TEST(Rewrite3mf, AFileWithoutSettingsGetsThoseOfAnInlayAndKeepsTheRest) {
  const auto bytes = plainFile();
  const auto written = withInlay(bytes);
  auto before = unzipped(bytes), after = unzipped(written);
  EXPECT_EQ(after.size(), before.size() + 2);
  EXPECT_EQ(after["Thumbnails/lid.png"], before["Thumbnails/lid.png"]);
  EXPECT_THAT(after["[Content_Types].xml"], HasSubstr("Extension=\"config\""));
  EXPECT_EQ(after["3D/3dmodel.model"], replaced(before["3D/3dmodel.model"], "objectid=\"7\"", "objectid=\"12\""));
  EXPECT_THAT(after["3D/lid.model"], HasSubstr("id=\"9\"><m:color color=\"#010203FF\"/></m:colorgroup>"));
  EXPECT_THAT(after["3D/lid.model"],
              HasSubstr("<basematerials id=\"10\"><base name=\"model\" displaycolor=\"#FAF0E6FF\"/>"
                        "<base name=\"QR code\" displaycolor=\"#010203FF\"/></basematerials>"));
  EXPECT_THAT(after["3D/lid.model"],
              HasSubstr("p:UUID=\"aaaaaaaa-61cb-4c03-9d28-80fed5dfa1dc\" pid=\"8\" pindex=\"0\">"));
  const auto bambu = slicer_rules::openInBambuStudio(written);
  const auto prusa = openInPrusaSlicer(written, slicer_rules::PrusaVersion::V2_9);
  for (const auto& project : {bambu, prusa}) {
    EXPECT_EQ(project.refused, "");
    EXPECT_THAT(project.filaments(), ElementsAre(1, 2));
  }
  ASSERT_EQ(bambu.objects.size(), 1u);
  EXPECT_EQ(bambu.objects[0].name, "lid & box");
  ASSERT_EQ(bambu.objects[0].volumes.size(), 2u);
  EXPECT_EQ(bambu.objects[0].volumes[1].name, "QR code");
  EXPECT_EQ(bambu.objects[0].volumes[1].filament, 2u);
}

TEST(Rewrite3mf, AnInlayGetsTheOtherExtruderOfCura) {
  for (const auto& [own, expected] : {std::pair("0", "1"), std::pair("1", "0"), std::pair("3", "1")}) {
    std::string box = boxObject(1, 1, 2, 3);
    const std::string metadata = "<metadata name=\"cura:extruder_nr\" preserve=\"1\" type=\"xs:integer\">";
    box.insert(box.find("<mesh>"), "<metadatagroup>" + metadata + own + "</metadata></metadatagroup>");
    const PolygonSoup soup = soupOf(zip_file::threeMf(zip_file::modelPart(box, "<item objectid=\"1\"/>")));
    ChangedRun change = sameRun(soup, 0);
    change.inlay = ModelBody{"QR code", shapes::box({1, 1, 1}), {}};
    const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials);
    ASSERT_TRUE(written) << sentence(written.error().message);
    const std::string model = unzipped(*written)["3D/3dmodel.model"];
    EXPECT_THAT(model, HasSubstr(metadata + own + "</metadata>"));
    EXPECT_THAT(model.substr(model.find("\"QR code\"")), HasSubstr(metadata + expected + "</metadata>")) << own;
  }
}

TEST(Rewrite3mf, PaintOfAFileWithoutSettingsIsReadByAllSlicers) {
  const auto bytes = plainFile();
  const PolygonSoup soup = soupOf(bytes);
  ChangedRun change = sameRun(soup, 0);
  change.painted = {3};
  const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials);
  ASSERT_TRUE(written) << sentence(written.error().message);
  auto before = unzipped(bytes), after = unzipped(*written);
  EXPECT_EQ(after.size(), before.size());
  for (const auto& [name, text] : before)
    if (name != "3D/lid.model") {
      EXPECT_EQ(after[name], text) << name;
    }
  EXPECT_THAT(after["3D/lid.model"], HasSubstr(" pid=\"9\" p1=\"0\"/>"));
  const auto bambu = slicer_rules::openInBambuStudio(*written);
  const auto prusa = openInPrusaSlicer(*written, slicer_rules::PrusaVersion::V2_9);
  for (const auto& project : {bambu, prusa}) {
    const std::vector<unsigned>& paint = project.objects.at(0).volumes.at(0).paint;
    EXPECT_EQ(paint.at(3), 2u);
    EXPECT_EQ(std::count(paint.begin(), paint.end(), 0u), 11);
  }
}

TEST(Rewrite3mf, MovesTheRangesOfPrusaSlicersVolumesAndAddsTheInlay) {
  const PolygonSoup soup = soupOf(prusaProject());
  ASSERT_EQ(soup.source->runs.size(), 2u);
  ChangedRun change = withOneMore(sameRun(soup, 0));
  change.painted = {1};
  change.inlay = ModelBody{"QR code", shapes::translated(shapes::box({1, 1, 1}), {10, 10, 9}), {}};
  const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::PrusaSlicer, kMaterials);
  ASSERT_TRUE(written) << sentence(written.error().message);
  const auto project = openInPrusaSlicer(*written, slicer_rules::PrusaVersion::V2_5);
  ASSERT_EQ(project.refused, "");
  const auto& volumes = project.objects.at(0).volumes;
  ASSERT_EQ(volumes.size(), 4u);
  EXPECT_EQ(volumes[0].triangles.size(), 7u);
  EXPECT_THAT(volumes[0].paint, ElementsAre(3, 2, 0, 0, 0, 0, 0));
  EXPECT_EQ(volumes[1].triangles.size(), 2u);
  EXPECT_EQ(volumes[1].kind, "ParameterModifier");
  EXPECT_EQ(volumes[2].triangles.size(), 4u);
  EXPECT_EQ(volumes[2].filament, 3u);
  EXPECT_EQ(volumes[3].triangles.size(), 12u);
  EXPECT_EQ(volumes[3].name, "QR code");
  EXPECT_EQ(volumes[3].filament, 2u);
  EXPECT_EQ(unzipped(*written)["Metadata/Slic3r_PE.config"], "; layer_height = 0.15\n");
}

TEST(Rewrite3mf, PiecesOfAFacetKeepOnlyPaintThatCoversItWhole) {
  for (const auto& [code, isKept] : {std::pair("8", true), std::pair("1C", true), std::pair("842", false)}) {
    const auto bytes = zip_file::threeMf(zip_file::modelPart(
        replaced(boxObject(1, 1, 2, 3), "<triangle ", fmt::format("<triangle paint_color=\"{}\" pid=\"5\" ", code)),
        "<item objectid=\"1\"/>"));
    const PolygonSoup soup = soupOf(bytes);
    ChangedRun change = sameRun(soup, 0);
    change.kept[0].what = What::WholePaint;
    const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials);
    ASSERT_TRUE(written) << sentence(written.error().message);
    const std::string model = unzipped(*written)["3D/3dmodel.model"];
    EXPECT_THAT(model, HasSubstr("pid=\"5\""));
    EXPECT_EQ(model.find("paint_color") != std::string::npos, isKept) << code;
    change.kept[0].what = What::Nothing;
    EXPECT_THAT(unzipped(*rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials))["3D/3dmodel.model"],
                Not(HasSubstr("pid")));
  }
}

TEST(Rewrite3mf, SaysWhyAFileMustBeWrittenAnew) {
  const auto whyNot = [](const std::vector<std::uint8_t>& bytes, bool hasInlay) {
    const PolygonSoup soup = soupOf(bytes);
    ChangedRun change = sameRun(soup, 0);
    if (hasInlay) change.inlay = ModelBody{"", shapes::box({1, 1, 1}), {}};
    const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials);
    if (written) return std::string("can be written");
    EXPECT_EQ(written.error().kind, ErrorKind::NoSolution);
    return sentence(written.error().message);
  };
  const std::string box = boxObject(1, 1, 2, 3);
  const auto twice = zip_file::threeMf(
      zip_file::modelPart(box, "<item objectid=\"1\"/><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 9 9 9\"/>"));
  EXPECT_THAT(whyNot(twice, false), HasSubstr("several times"));
  const auto plain = zip_file::threeMf(zip_file::modelPart(box, "<item objectid=\"1\"/>"));
  EXPECT_EQ(whyNot(plain, false), "can be written");
  EXPECT_EQ(whyNot(plain, true), "can be written");
  const std::string group = "<m:colorgroup id=\"9\"><m:color color=\"#112233\"/></m:colorgroup>";
  const auto coloured = zip_file::threeMf(
      zip_file::modelPart(group + box, "<item objectid=\"1\"/>", fmt::format("xmlns:m=\"{}\"", kMaterialSpace)));
  EXPECT_THAT(whyNot(coloured, true), HasSubstr("no settings"));
  for (const char* range : {R"(firstid="5" lastid="8")", R"(firstid="8" lastid="12")", R"(firstid="9" lastid="8")"}) {
    auto parts = unzipped(prusaProject());
    std::string& settings = parts["Metadata/Slic3r_PE_model.config"];
    settings = replaced(settings, R"(firstid="8" lastid="11")", range);
    const auto overlapping =
        zip_file::threeMf(parts["3D/3dmodel.model"], {{"Metadata/Slic3r_PE_model.config", settings}});
    EXPECT_THAT(whyNot(overlapping, false), HasSubstr("unusual form")) << range;
  }
}

TEST(Rewrite3mf, AChangedObjectLosesItsSlices) {
  const std::string stack = "<s:slicestack id=\"5\" zbottom=\"0\"></s:slicestack>";
  const auto bytes = zip_file::threeMf(zip_file::modelPart(
      stack + boxObject(1, 1, 2, 3, "s:slicestackid=\"5\" name=\"box\" s:meshresolution=\"fullres\""),
      "<item objectid=\"1\"/>", "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\""));
  const PolygonSoup soup = soupOf(bytes);
  const ChangedRun change = sameRun(soup, 0);
  const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials);
  ASSERT_TRUE(written) << sentence(written.error().message);
  const std::string model = unzipped(*written)["3D/3dmodel.model"];
  EXPECT_THAT(model, HasSubstr(stack));
  EXPECT_THAT(model, Not(HasSubstr("slicestackid")));
  EXPECT_THAT(model, Not(HasSubstr("meshresolution")));
  EXPECT_THAT(model, HasSubstr("name=\"box\""));
}

TEST(Rewrite3mf, MakesAnEngravedSurfaceAModelAndKeepsWhatIsNone) {
  std::string helper = boxObject(2, 3, 3, 3);
  helper.insert(helper.find("<mesh>"),
                "<metadatagroup><metadata name=\"cura:support_mesh\">True</metadata></metadatagroup>");
  const std::string unprinted = boxObject(3, 4, 4, 4, "type=\"surface\"");
  const std::string build = "<item objectid=\"2\"/><item objectid=\"1\"/><item objectid=\"3\" printable=\"0\"/>";
  const auto bytes =
      zip_file::threeMf(zip_file::modelPart(helper + boxObject(1, 1, 2, 3, "type=\"surface\"") + unprinted, build));
  const PolygonSoup soup = soupOf(bytes);
  ASSERT_EQ(soup.source->runs.size(), 1u);
  const ChangedRun change = sameRun(soup, 0);
  const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials);
  ASSERT_TRUE(written) << sentence(written.error().message);
  const std::string model = unzipped(*written)["3D/3dmodel.model"];
  EXPECT_THAT(model, HasSubstr("<object id=\"1\" type=\"model\">"));
  for (const std::string& kept : {helper, unprinted, build}) EXPECT_THAT(model, HasSubstr(kept));
}

TEST(Rewrite3mf, FindsMeshesWhoseNumbersHaveBlanks) {
  std::string model = zip_file::modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1 \"/>");
  model = replaced(model, "object id=\"1\"", "object id=\" 1 \"");
  for (std::size_t at = model.find("v2=\""); at != std::string::npos; at = model.find("v2=\"", at + 5))
    model.insert(at + 4, " ");
  const PolygonSoup soup = soupOf(zip_file::threeMf(model));
  const ChangedRun change = withOneMore(sameRun(soup, 0));
  const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials);
  EXPECT_TRUE(written) << sentence(written.error().message);
}

TEST(Rewrite3mf, TurnsTrianglesOfMirroredMeshesBack) {
  const auto bytes = zip_file::threeMf(
      zip_file::modelPart(boxObject(1, 1, 2, 3), "<item objectid=\"1\" transform=\"-1 0 0 0 2 0 0 0 1 4 5 6\"/>"));
  const PolygonSoup soup = soupOf(bytes);
  const ChangedRun change = withOneMore(sameRun(soup, 0));
  const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, kMaterials);
  ASSERT_TRUE(written) << sentence(written.error().message);
  EXPECT_EQ(soupOf(*written).triangles.size(), 13u);
}

}  // namespace
}  // namespace qrelief
