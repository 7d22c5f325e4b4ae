// SPDX-License-Identifier: GPL-3.0-or-later
#include "delivery/carved_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

#include "io/three_mf/read_3mf.h"
#include "io/three_mf/write_3mf.h"
#include "pipeline/engrave.h"
#include "support/gl_test.h"
#include "support/shapes.h"
#include "support/slicer_rules.h"
#include "support/xml_document.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

constexpr double kRadius = 40, kCodeMm = 25;

/// Returns an object with a mesh, each facet painted with filament 3 and in front with a paint that divides it.
std::string paintedObject(int id, const Mesh& mesh) {
  std::string text = fmt::format("<object id=\"{}\" type=\"model\"><mesh><vertices>\n", id);
  for (const Vec3f& p : mesh.positions) text += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", p.x, p.y, p.z);
  text += "</vertices><triangles>\n";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const bool isFront = mesh.corner(t, 0).y < 0;
    text += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\" paint_color=\"{}\"/>\n", a, b, c,
                        isFront ? "0C4841" : "0C");
  }
  return text + "</triangles></mesh></object>\n";
}

/// Returns a project of Bambu Studio: a painted ball with a modifier.
std::vector<std::uint8_t> ballProject(const Mesh& ball) {
  constexpr const char* kSpaces = "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"";
  return zip_file::threeMf(
      zip_file::modelPart("<object id=\"3\" type=\"model\"><components>"
                          "<component p:path=\"/3D/Objects/ball.model\" objectid=\"1\"/>"
                          "<component p:path=\"/3D/Objects/ball.model\" objectid=\"2\"/></components></object>",
                          "<item objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 128 128 40\"/>", kSpaces),
      {{"3D/Objects/ball.model",
        zip_file::modelPart(paintedObject(1, ball) + zip_file::boxObject(2, 50, 50, 50, "type=\"other\""), "")},
       {"3D/_rels/3dmodel.model.rels",
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/Objects/ball.model\"/></Relationships>"},
       {"Metadata/model_settings.config",
        "<config><object id=\"3\"><metadata key=\"name\" value=\"ball\"/>"
        "<part id=\"1\" subtype=\"normal_part\"><metadata key=\"extruder\" value=\"1\"/></part>"
        "<part id=\"2\" subtype=\"modifier_part\"></part></object></config>"}});
}

class WriteCarved3mfTest : public GlTest {
 protected:
  const Mesh ball_ = shapes::icosphere(kRadius, 4);

  /// Reads the project and engraves the ball's top.
  void engraveBall(Mark mark) {
    bytes_ = ballProject(ball_);
    const auto soup = read3mf(bytes_, {});
    ASSERT_TRUE(soup);
    auto prepared = prepareModel(*soup, {});
    ASSERT_TRUE(prepared);
    EngraveRequest request;
    request.code.text = "x";
    request.placement.centreMm = {128, 128, 80};
    request.placement.sizeMode = SizeMode::Fixed;
    request.placement.sizeMm = kCodeMm;
    request.marking.mark = mark;
    model_ = EngravableModel::upload(std::move(*prepared));
    auto result = engrave(model_, request);
    ASSERT_TRUE(result);
    result_ = std::move(*result);
    const auto written = writeCarved3mf(model_->prepared, result_, {}, mark == Mark::Inlay, {.title = "ball"});
    ASSERT_TRUE(written);
    EXPECT_FALSE(written->notKept);
    written_ = written->bytes;
  }

  std::vector<std::uint8_t> bytes_, written_;
  std::shared_ptr<const EngravableModel> model_;
  EngraveResult result_;
};

TEST_F(WriteCarved3mfTest, CarriesThePoseOnThePrinter) {
  bytes_ = ballProject(ball_);
  ASSERT_NO_FATAL_FAILURE(engraveBall(Mark::Shadow));
  result_.request.print.buildUp = {BuildPose::CodeUpright, {}};
  const auto written = writeCarved3mf(model_->prepared, result_, {}, false, {});
  ASSERT_TRUE(written);
  EXPECT_FALSE(written->notKept);
  const auto before = read3mf(written_, {}), posed = read3mf(written->bytes, {});
  ASSERT_TRUE(before && posed);
  ASSERT_EQ(posed->triangles, before->triangles);
  // The ball is turned about its middle.
  const Vec3 middle(128, 128, 40), up = result_.placement.frame.up;
  for (std::size_t v = 0; v < before->positions.size(); ++v)
    EXPECT_NEAR(glm::dot(before->positions[v] - middle, up), posed->positions[v].z - middle.z, 0.1);
}

TEST_F(WriteCarved3mfTest, KeepsPaintOutsideTheCode) {
  ASSERT_NO_FATAL_FAILURE(engraveBall(Mark::Shadow));
  const auto project = slicer_rules::openInBambuStudio(written_);
  const auto& volumes = project.objects.at(0).volumes;
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_EQ(volumes[1].kind, "modifier_part");
  EXPECT_EQ(volumes[1].triangles.size(), 12u);
  const auto& ball = volumes[0];
  ASSERT_EQ(ball.triangles.size(), result_.mesh.triangles.size());
  const ProjectionFrame& frame = result_.placement.frame;
  std::size_t keptPieces = 0;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    const auto& [a, b, c] = ball.triangles[t];
    const Vec3 middle = (a + b + c) / 3.0;
    const Vec2 p = frame.project(middle);
    const double out = std::max(std::abs(p.x), std::abs(p.y)) - kCodeMm / 2;  // mm outside of the symbol
    const bool isTop = middle.z > 60;
    const bool isPiece = t >= result_.keptTriangles;
    if (isTop && out < -0.1) {
      EXPECT_EQ(ball.paint[t], 0u) << "under the code";
    }
    if (middle.y > 131 && (!isTop || out > 0.1)) {
      EXPECT_EQ(ball.paint[t], 3u) << "outside of the code";
      keptPieces += isPiece;
    }
    if (middle.y < 125 && isPiece) {
      EXPECT_EQ(ball.paint[t], 0u) << "a piece of a divided facet";
    }
  }
  EXPECT_GT(keptPieces, 10u);
}

TEST_F(WriteCarved3mfTest, KeepsEverythingButTheEngravedMesh) {
  ASSERT_NO_FATAL_FAILURE(engraveBall(Mark::Inlay));
  auto before = unzipped(bytes_), after = unzipped(written_);
  const std::set<std::string> changed = {"3D/Objects/ball.model", "3D/3dmodel.model", "Metadata/model_settings.config"};
  ASSERT_EQ(after.size(), before.size());
  for (const auto& [name, text] : before)
    if (!changed.count(name)) {
      EXPECT_EQ(after[name], text) << name;
    }
  const auto project = slicer_rules::openInBambuStudio(written_);
  const auto& volumes = project.objects.at(0).volumes;
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_EQ(volumes[1].name, "QR code");
  EXPECT_EQ(volumes[1].filament, 2u);
  EXPECT_EQ(volumes[1].triangles.size(), result_.inlay->triangles.size());
  EXPECT_EQ(volumes[2].kind, "modifier_part");
}

TEST_F(WriteCarved3mfTest, WritesTheModelsAnewAndSaysWhy) {
  ASSERT_NO_FATAL_FAILURE(engraveBall(Mark::Inlay));
  const auto anew =
      writeCarved3mf(model_->prepared, result_, {}, true, {.title = "ball", .slicer = Slicer::PrusaSlicer});
  ASSERT_TRUE(anew);
  ASSERT_TRUE(anew->notKept);
  EXPECT_EQ(anew->notKept->code, "rewrite-other-slicer");
  EXPECT_EQ(openInPrusaSlicer(anew->bytes, slicer_rules::PrusaVersion::V2_5).objects.at(0).volumes.size(), 2u);
}

}  // namespace
}  // namespace qrelief
