// SPDX-License-Identifier: GPL-3.0-or-later
// Tests a text alone (Content::Text) from request to verdict.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "io/write_stl.h"
#include "messages/sentences.h"
#include "native/read_carving.h"
#include "pipeline/best_spot.h"
#include "pipeline/engrave.h"
#include "pipeline/label_pockets.h"
#include "pipeline/printed_view.h"
#include "pipeline/verify.h"
#include "report/report.h"
#include "report/verify_report.h"
#include "settings/settings.h"
#include "support/follow_job.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class TextAlone : public GlTest {
 protected:
  static std::shared_ptr<const EngravableModel> upload(const Mesh& mesh) {
    return EngravableModel::upload(*prepareModel(shapes::soupOf(mesh), {}));
  }
  static std::shared_ptr<const EngravableModel> plate(double thickness = 6) {
    return upload(shapes::plate({60, 60}, thickness, 5, 5));
  }
  static EngraveRequest requestFor(const std::string& text, Mark mark = Mark::Shadow) {
    EngraveRequest request = defaultRequest();
    request.code.content = Content::Text;
    request.code.text = text;
    request.marking.mark = mark;
    request.placement.upHint = {0, 1, 0};
    return request;
  }
  static EngraveResult engraved(const std::shared_ptr<const EngravableModel>& model, const EngraveRequest& request) {
    auto result = engrave(model, request);
    EXPECT_TRUE(result.has_value()) << (result ? "" : sentence(result.error().message));
    return result ? std::move(*result) : EngraveResult{};
  }
  static double areaOf(const OutlinedPockets& letters) {
    double area = 0;
    for (const Ring& ring : letters.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) area += cross2(ring[i], ring[(i + 1) % ring.size()]) / 2;
    return area;
  }
  static Verdict judged(const EngraveRequest& request, const EngraveResult& result) {
    return judge(request, result, readCarving(request, result));
  }
};

TEST_F(TextAlone, TakesItsAreaTwoLayersDeepFromAPlate) {
  const auto model = plate();
  const EngraveRequest request = requestFor("Rev B\n2026");
  const EngraveResult result = engraved(model, request);
  EXPECT_TRUE(result.solidity.solid()) << testing::PrintToString(result.solidity.problems());
  EXPECT_NEAR(result.label.depthMm, kLabelLayers * request.print.printer.layerMm, 1e-9);
  const double lost = signedVolume(model->prepared.mesh) - result.solidity.volumeMm3;
  EXPECT_NEAR(lost, areaOf(result.label) * result.label.depthMm, 0.03 * lost);
  EXPECT_NEAR(result.placement.symbolMm, request.placement.maxSizeMm, 1e-9);
  const Verdict verdict = judged(request, result);
  EXPECT_TRUE(verdict.passed());
  EXPECT_EQ(verdict.reads.level, Level::Good);
  EXPECT_EQ(verdict.prints.level, Level::Good);
  EXPECT_EQ(verdict.reads.summary.code, "text-reads");
}

TEST_F(TextAlone, FollowsACylinder) {
  const auto model = upload(shapes::cylinder(20, 60, 96));
  EngraveRequest request = requestFor("Rev B");
  request.placement.centreMm = {20, 0, 0};
  request.placement.upHint = {0, 0, 1};
  request.code.label.frame = LabelFrame::Rounded;
  const EngraveResult result = engraved(model, request);
  EXPECT_TRUE(result.solidity.solid()) << testing::PrintToString(result.solidity.problems());
  EXPECT_TRUE(judged(request, result).passed());
  for (std::size_t t = result.keptTriangles; t < result.mesh.triangles.size(); ++t) {
    if (result.origins[t].kind != FacetOrigin::Kind::Floor) continue;
    EXPECT_TRUE(result.origins[t].isOfLabel);
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = result.mesh.corner(t, k);
      const Vec3 towards = glm::normalize(result.placement.frame.eye() - p);
      const double depth = (20 - std::hypot(p.x, p.y)) / std::max(0.1, glm::dot(towards, Vec3(p.x, p.y, 0) / 20.0));
      EXPECT_NEAR(depth, result.label.depthMm, 0.05);
    }
  }
}

TEST_F(TextAlone, InlayAndPaintAreExactlyItsLetters) {
  const auto model = plate();
  const EngraveRequest asInlay = requestFor("Rev B", Mark::Inlay), asPaint = requestFor("Rev B", Mark::Paint);
  const EngraveResult inlay = engraved(model, asInlay), paint = engraved(model, asPaint);
  ASSERT_TRUE(inlay.inlay);
  EXPECT_TRUE(inlay.inlaySolidity.solid());
  EXPECT_NEAR(inlay.inlaySolidity.volumeMm3, areaOf(inlay.label) * inlay.markDepthMm,
              0.03 * inlay.inlaySolidity.volumeMm3);
  EXPECT_TRUE(judged(asInlay, inlay).passed());
  EXPECT_TRUE(paint.solidity.solid());
  double painted = 0;
  for (const std::uint32_t t : paint.painted)
    painted += glm::length(glm::cross(paint.mesh.corner(t, 1) - paint.mesh.corner(t, 0),
                                      paint.mesh.corner(t, 2) - paint.mesh.corner(t, 0))) /
               2;
  EXPECT_NEAR(painted, areaOf(paint.label), 0.03 * painted);
  EXPECT_TRUE(judged(asPaint, paint).passed());
}

TEST_F(TextAlone, IsCarvedWithoutLightSearchOrPictures) {
  EXPECT_THAT(
      followJob(**CarveJob::create(plate(), requestFor("Rev B"))),
      testing::ElementsAre("finding-direction-and-size", "measuring-surface", "carving-mesh", "checking-solid"));
}

TEST_F(TextAlone, StrokesThinnerThanALineDoNotPrint) {
  EngraveRequest request = requestFor("Serial number 0123456789-ABCDEF");
  const EngraveResult result = engraved(plate(), request);
  const Verdict verdict = judged(request, result);
  EXPECT_FALSE(verdict.prints.passed());
  EXPECT_EQ(verdict.prints.failed.front().code, "text-too-fine");
  std::vector<std::string> changes;
  for (const Remedy& remedy : verdict.prints.remedies)
    changes.push_back(remedy.changes.empty() ? "" : remedy.changes.front().setting);
  EXPECT_THAT(changes, testing::ElementsAre("nozzleMm", "")) << "a plate of 60 mm has no room for strokes of a line";
  request.print.printer.nozzleMm = 0.15;
  request.print.printer.layerMm = 0.1;
  EXPECT_TRUE(judged(request, engraved(plate(), request)).prints.passed());
}

TEST_F(TextAlone, SmallCapitalsAreHardToRead) {
  EngraveRequest request = requestFor("Serial number 0123456789-ABCDEF");
  request.placement.maxSizeMm = 20;
  EXPECT_EQ(judged(request, engraved(plate(), request)).reads.level, Level::Barely);
}

TEST_F(TextAlone, AThinWallMakesItShallowerAndSaysSo) {
  const auto model = plate(1.1);
  const EngraveRequest request = requestFor("Rev B");
  const EngraveResult result = engraved(model, request);
  EXPECT_NEAR(result.label.depthMm, 0.3, 0.011);
  EXPECT_EQ(judged(request, result).prints.reasons.front().code, "text-shallow");
  const auto refused = engrave(plate(0.9), request);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().message.code, "text-too-deep");
}

TEST_F(TextAlone, NeedsLettersAndTakesNoLabel) {
  const auto codeOf = [](const EngraveRequest& request) {
    const auto job = CarveJob::create(plate(), request);
    return job ? std::string() : job.error().message.code;
  };
  EXPECT_EQ(codeOf(requestFor("")), "text-alone-empty");
  EXPECT_EQ(codeOf(requestFor(" \n ")), "text-alone-empty");
  EXPECT_EQ(codeOf(requestFor("漢")), "label-lacks-characters");
  EngraveRequest labelled = requestFor("Rev B");
  labelled.code.label.text = "No. 7";
  EXPECT_EQ(codeOf(labelled), "text-alone-has-label");
}

TEST_F(TextAlone, SettingsOfCodesChangeNothing) {
  EngraveRequest odd = requestFor("Rev B");
  odd.code.symbol.version = 7;
  odd.code.modulePattern = ModulePattern::Diamond;
  odd.depth.contrast = 0.5;
  odd.depth.maxDepthMm = 0.2;
  odd.depth.lights = {kOneLight};
  odd.depth.objective = DepthObjective::OneLight;
  odd.depth.surface = SurfaceMode::Resampled;
  odd.placement.quietZone = false;
  EXPECT_EQ(writeStl(engraved(plate(), odd).mesh), writeStl(engraved(plate(), requestFor("Rev B")).mesh));
}

TEST_F(TextAlone, TheBestSpotHasRoomForItAndNoConcernAboutLight) {
  const auto spot = bestSpot(upload(shapes::bumpySphere(30, 1.5, 5, 5)), requestFor("Rev B"));
  ASSERT_TRUE(spot.has_value()) << sentence(spot.error().message);
  EXPECT_EQ(spot->unevenLight, 0);
  EXPECT_TRUE(spot->prints);
}

TEST_F(TextAlone, TheReportClaimsNothingDecoded) {
  const auto model = plate();
  const EngraveRequest request = requestFor("Rev B");
  const EngraveResult result = engraved(model, request);
  EXPECT_FALSE(*printedViewOf(verifyRequestOf(request, result)));
  ReportContext context;
  context.verdict = judged(request, result);
  const std::string text = makeReport(request, *model, result, context);
  const auto report = nlohmann::json::parse(text);
  EXPECT_EQ(report.at("content"), "text");
  EXPECT_TRUE(report.at("symbol").is_null());
  EXPECT_TRUE(report.at("verification").at("decoded").is_null());
  EXPECT_FALSE(report.at("verification").contains("iso15415"));
  EXPECT_EQ(report.at("label").at("capitalMm"), *capitalMmOf(result));
  const auto task = requestFromReport(text);
  ASSERT_TRUE(task.has_value()) << sentence(task.error().message);
  EXPECT_TRUE(task->isText());
  EXPECT_EQ(task->symbolMm, result.placement.symbolMm);
}

TEST_F(TextAlone, VerifyingChecksItsSolidAndDecodesNothing) {
  const EngraveRequest request = requestFor("Rev B");
  const EngraveResult result = engraved(plate(), request);
  const VerifyRequest task = verifyRequestOf(request, result);
  const auto verified = [&](const Mesh& mesh) {
    auto job = *VerifyJob::create(mesh, task, {});
    EXPECT_THAT(followJob(*job), testing::ElementsAre("checking-solid"));
    return job->takeResult();
  };
  const VerifyResult whole = verified(result.mesh);
  const Verdict good = judge(task, whole);
  EXPECT_TRUE(good.passed());
  EXPECT_EQ(good.reads.summary.code, "text-not-decoded");
  VerifyReportContext context;
  context.verdict = good;
  const auto json = nlohmann::json::parse(makeVerifyReport(task, whole, context));
  EXPECT_EQ(json.at("verified"), true);
  EXPECT_TRUE(json.at("verification").at("decoded").is_null());
  EXPECT_TRUE(json.at("size").at("moduleMm").is_null());
  EXPECT_FALSE(json.contains("carving"));
  Mesh open = result.mesh;
  open.triangles.pop_back();
  EXPECT_FALSE(judge(task, verified(open)).passed());
}

TEST_F(TextAlone, TooManyLettersAreRefusedBeforeTheSearch) {
  EngraveRequest request = requestFor(std::string(2000, 'x'));
  const auto codeOf = [](const auto& outcome) { return outcome ? std::string() : outcome.error().message.code; };
  const auto model = plate();
  EXPECT_EQ(codeOf(CarveJob::create(model, request)), "text-strokes-too-thin");
  EXPECT_EQ(codeOf(bestSpot(model, request)), "text-strokes-too-thin");
  request.placement.maxSizeMm = 1000;
  EXPECT_EQ(codeOf(CarveJob::create(model, request)), "text-strokes-too-thin") << "the plate is no larger than 60 mm";

  request.code.text = std::string(500, 'x');  // may be made at 500 mm, but not on this plate
  request.placement.eyeDistanceMm = 60;       // so near, no bound of the size is known
  EXPECT_EQ(codeOf(CarveJob::create(model, request)), "");
  EXPECT_EQ(codeOf(engrave(model, request)), "text-strokes-too-thin");
}

}  // namespace
}  // namespace qrelief
