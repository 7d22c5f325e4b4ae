// SPDX-License-Identifier: GPL-3.0-or-later
// Tests codes in a second colour from request to verdict: Mark::Inlay and Mark::Paint.
#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

#include "batch/manifest.h"
#include "engine/ink_seen.h"
#include "io/write_stl.h"
#include "message_codes/printing.h"
#include "messages/sentences.h"
#include "native/read_carving.h"
#include "native/zxing_decoder.h"
#include "pipeline/engrave.h"
#include "pipeline/verify.h"
#include "report/report.h"
#include "report/verify_report.h"
#include "settings/settings.h"
#include "support/follow_job.h"
#include "support/gl_test.h"
#include "support/shapes.h"
#include "verification/baked_light.h"

namespace qrelief {
namespace {

constexpr const char* kText = "HTTPS://QRELIEF.EXAMPLE";

class MarkTest : public GlTest {
 protected:
  static std::shared_ptr<const EngravableModel> upload(const Mesh& mesh) {
    return EngravableModel::upload(*prepareModel(shapes::soupOf(mesh), {}));
  }
  static std::shared_ptr<const EngravableModel> sphere() {
    static const auto kModel = upload(shapes::bumpySphere(40, 1.5, 5, 5));
    return kModel;
  }
  static EngraveRequest requestFor(Mark mark, Vec3 centre = {0, 0, 40}, double sizeMm = 25) {
    EngraveRequest request = defaultRequest();
    request.code.text = kText;
    request.marking.mark = mark;
    request.placement.centreMm = centre;
    request.placement.sizeMode = SizeMode::Fixed;
    request.placement.sizeMm = sizeMm;
    return request;
  }
  static EngraveResult engraved(const std::shared_ptr<const EngravableModel>& model, const EngraveRequest& request) {
    auto result = engrave(model, request);
    EXPECT_TRUE(result.has_value()) << (result ? "" : sentence(result.error().message));
    return result ? std::move(*result) : EngraveResult{};
  }
  static VerifyResult verified(const VerifyRequest& request, const Mesh& mesh) {
    auto job = VerifyJob::create(mesh, request, zxingDecoders());
    EXPECT_TRUE(job.has_value());
    return *runToEnd(**job);
  }
  static std::string reportOf(const EngraveRequest& request, const EngraveResult& result) {
    ReportContext context;
    context.reading = readCarving(request, result);
    context.verdict = judge(request, result, context.reading);
    return makeReport(request, *sphere(), result, context);
  }
  static Mesh bothBodies(const EngraveResult& result) {
    const Mesh all = shapes::together(result.mesh, *result.inlay);
    return *meshAsFound(shapes::soupOf(all), 1);
  }
};

TEST_F(MarkTest, ACodeInColourSkipsTheDepthSearch) {
  for (const Mark mark : {Mark::Inlay, Mark::Paint})
    EXPECT_THAT(followJob(**CarveJob::create(sphere(), requestFor(mark))),
                testing::ElementsAre("finding-direction-and-size", "measuring-surface", "carving-mesh",
                                     "checking-solid", "looking-at-result"));
}

TEST_F(MarkTest, AnInlayIsEvenAndFillsTheModelUp) {
  const EngraveRequest request = requestFor(Mark::Inlay);
  const EngraveResult result = engraved(sphere(), request);
  ASSERT_TRUE(result.inlay);
  EXPECT_TRUE(result.solidity.solid());
  EXPECT_TRUE(result.inlaySolidity.solid());
  const std::set<double> depths(result.depths.depthMm.begin(), result.depths.depthMm.end());
  EXPECT_EQ(depths, (std::set<double>{0, result.markDepthMm}));
  EXPECT_EQ(result.modulesLeftOut, 0u);
  const double whole = signedVolume(sphere()->prepared.mesh);
  EXPECT_NEAR(result.solidity.volumeMm3 + result.inlaySolidity.volumeMm3, whole, 1e-6 * whole);
  EXPECT_EQ(result.searchIterations, 0);
  EXPECT_TRUE(result.painted.empty());
}

TEST_F(MarkTest, TheDepthOfAnInlayFollowsTheSlopeUnlessItIsGiven) {
  EngraveRequest request = requestFor(Mark::Inlay);
  request.print.buildUp.pose = BuildPose::CodeUp;
  const double lying = engraved(sphere(), request).markDepthMm;
  request.print.buildUp.pose = BuildPose::CodeUpright;
  const double upright = engraved(sphere(), request).markDepthMm;
  EXPECT_GE(lying, 0.4);
  EXPECT_LT(lying, 0.8);  // the ball bends: its rim is steeper than its middle
  EXPECT_GE(upright, 0.9);
  EXPECT_LT(upright, 1.2);
  request.marking.markDepthMm = 0.55;
  EXPECT_DOUBLE_EQ(engraved(sphere(), request).markDepthMm, 0.55);
}

TEST_F(MarkTest, PaintKeepsTheShapeAndListsTheDarkModules) {
  const EngraveResult result = engraved(sphere(), requestFor(Mark::Paint));
  const Mesh& before = sphere()->prepared.mesh;
  EXPECT_TRUE(result.solidity.solid());
  EXPECT_FALSE(result.inlay);
  EXPECT_EQ(result.markDepthMm, 0);
  EXPECT_NEAR(result.solidity.volumeMm3, signedVolume(before), 1e-7 * signedVolume(before));
  std::set<std::array<float, 3>> places;
  for (const Vec3f p : result.mesh.positions) places.insert({p.x, p.y, p.z});
  EXPECT_TRUE(std::all_of(before.positions.begin(), before.positions.end(), [&](Vec3f p) {
    return places.contains({p.x, p.y, p.z});
  }));

  // Rays through the modules' middles meet painted triangles where the symbol is dark, and only there.
  const RayTree tree(result.mesh);
  const std::set<std::uint32_t> painted(result.painted.begin(), result.painted.end());
  const Placement& placement = result.placement;
  for (int row = 0; row < result.symbol.size; ++row)
    for (int column = 0; column < result.symbol.size; ++column) {
      const Vec2 middle = Vec2(column + 0.5, -row - 0.5) * placement.moduleMm + Vec2(-0.5, 0.5) * placement.symbolMm;
      const auto hit = tree.firstHit(placement.frame.eye(), placement.frame.rayDirection(middle), 0);
      ASSERT_TRUE(hit);
      ASSERT_EQ(painted.contains(hit->triangle), result.symbol.isDark(row, column)) << row << ", " << column;
    }
}

TEST_F(MarkTest, BothDecodeAsDesignedAndAsPrinted) {
  for (const Mark mark : {Mark::Inlay, Mark::Paint})
    for (const BuildPose pose : {BuildPose::CodeUp, BuildPose::CodeUpright}) {
      EngraveRequest request = requestFor(mark);
      request.print.buildUp.pose = pose;
      const EngraveResult result = engraved(sphere(), request);
      const ReadingEvidence reading = readCarving(request, result);
      const auto printed = readPrinted(verifyRequestOf(request, result), result.mesh, [](const Progress&) {});
      ASSERT_TRUE(printed && *printed);
      EXPECT_EQ((*printed)->reading.text, kText);
      const Verdict verdict = judge(request, result, reading, &**printed);
      EXPECT_EQ(verdict.reads.level, Level::Good) << markName(mark);
      EXPECT_EQ(verdict.prints.level, Level::Good) << markName(mark) << ": " << (*printed)->reading.count.reads;
      EXPECT_TRUE(verdict.passed());
      EXPECT_GE(gradesOf(request, result).iso15415, 3) << markName(mark);
    }
}

TEST_F(MarkTest, ASecondCodeOnAPaintedOneIsWarnedOf) {
  const EngraveRequest request = requestFor(Mark::Paint);
  const EngraveResult first = engraved(sphere(), request);
  auto soup = shapes::soupOf(first.mesh);
  soup.colours.assign(soup.triangles.size(), Colour{235, 235, 230});
  for (const std::uint32_t t : first.painted) soup.colours[t] = Colour{25, 25, 30};
  const auto painted = EngravableModel::upload(*prepareModel(soup, {}));
  const auto warningsAt = [&](Vec3 centre) {
    const EngraveRequest next = requestFor(Mark::Paint, centre, 20);
    const EngraveResult second = engraved(painted, next);
    return judge(next, second, readCarving(next, second)).reads.warnings;
  };
  EXPECT_THAT(warningsAt({0, 0, 40}), testing::Contains(message<"spot-in-several-colours">()));
  EXPECT_THAT(warningsAt({0, 0, -40}), testing::Not(testing::Contains(message<"spot-in-several-colours">())));
}

TEST_F(MarkTest, ModulesNarrowerThanALineAreLostInPrint) {
  const auto plate = upload(shapes::box({50, 50, 10}));
  EngraveRequest request = requestFor(Mark::Paint, {0, 0, 5}, 9);
  request.print.buildUp.pose = BuildPose::CodeUp;
  const EngraveResult result = engraved(plate, request);
  ASSERT_LT(result.placement.moduleMm, 0.45);
  EXPECT_TRUE(readCarving(request, result).count.enough());
  const auto printed = readPrinted(verifyRequestOf(request, result), result.mesh, [](const Progress&) {});
  ASSERT_TRUE(printed && *printed);
  EXPECT_EQ((*printed)->reading.count.reads, 0);
}

TEST_F(MarkTest, SettingsOfShadowsChangeNothing) {
  const EngraveResult plain = engraved(sphere(), requestFor(Mark::Inlay));
  EngraveRequest odd = requestFor(Mark::Inlay);
  odd.code.modulePattern = ModulePattern::Diamond;
  odd.code.finderPattern = FinderPattern::Diamond;
  odd.depth.contrast = 0.5;
  odd.depth.maxDepthMm = 0.2;
  odd.depth.lights = {kOneLight};
  odd.depth.objective = DepthObjective::OneLight;
  odd.depth.surface = SurfaceMode::Resampled;
  const EngraveResult same = engraved(sphere(), odd);
  EXPECT_EQ(writeStl(same.mesh), writeStl(plain.mesh));
  EXPECT_EQ(same.luminance, plain.luminance);
}

TEST_F(MarkTest, ThinWallsLimitAnInlayButNotPaint) {
  const auto plate = upload(shapes::box({60, 60, 1.1}));
  EngraveRequest request = requestFor(Mark::Inlay, {0, 0, 0.55});  // 0.8 mm must remain
  request.print.buildUp.pose = BuildPose::CodeUp;
  const EngraveResult thin = engraved(plate, request);
  EXPECT_NEAR(thin.markDepthMm, 0.3, 0.011);  // 0.4 mm would be opaque
  EXPECT_EQ(judge(request, thin, readCarving(request, thin)).prints.reasons.front().code, "inlay-not-opaque");
  request.depth.minWallMm = 1;
  const auto refused = engrave(plate, request);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().message.code, "inlay-needs-walls");
  request.marking.mark = Mark::Paint;
  EXPECT_TRUE(engraved(plate, request).solidity.solid());
}

TEST_F(MarkTest, AnInlayOverAnotherShellNamesTheShell) {
  const Mesh sheet = shapes::box({60, 60, 0.7}), block = shapes::box({60, 60, 20});
  const auto layered = upload(shapes::together(shapes::translated(block, {0, 0, -10.3}), sheet));
  const auto refused = engrave(layered, requestFor(Mark::Inlay, {0, 0, 0.35}));
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().message.code, "inlay-needs-walls-over-shell");
  EXPECT_THAT(sentence(refused.error().message), testing::HasSubstr("lies 0.65 mm below the surface"));
  const auto alone = engrave(upload(sheet), requestFor(Mark::Inlay, {0, 0, 0.35}));
  ASSERT_FALSE(alone.has_value());
  EXPECT_EQ(alone.error().message.code, "inlay-needs-walls");
}

TEST_F(MarkTest, ColoursThatAreTooAlikeAreRefused) {
  EngraveRequest request = requestFor(Mark::Paint);
  request.marking.darkReflectance = 0.5;
  request.marking.albedo = 0.6;
  const auto refused = engrave(sphere(), request);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().message.code, "colours-too-alike");
  request.marking.mark = Mark::Shadow;  // has no colours
  EXPECT_TRUE(checkSettings(request).has_value());
}

TEST_F(MarkTest, VerifyTakesMarkAndColoursFromTheReportAndAgrees) {
  for (const Mark mark : {Mark::Inlay, Mark::Paint}) {
    const EngraveRequest request = requestFor(mark);
    const EngraveResult result = engraved(sphere(), request);
    const std::string report = reportOf(request, result);
    const auto json = nlohmann::json::parse(report);
    EXPECT_EQ(json.at("mark"), markName(mark));
    EXPECT_EQ(json.at("markDepthMm"), result.markDepthMm);
    EXPECT_EQ(json.at("darkReflectance"), 0.05);
    EXPECT_EQ(json.at("albedo"), 0.85);
    auto fromReport = requestFromReport(report);
    ASSERT_TRUE(fromReport.has_value()) << sentence(fromReport.error().message);
    EXPECT_EQ(fromReport->mark, mark);
    fromReport->ranges = true;
    const VerifyResult verification = verified(*fromReport, mark == Mark::Inlay ? bothBodies(result) : result.mesh);
    const Verdict verdict = judge(*fromReport, verification);
    EXPECT_TRUE(verdict.passed()) << (verdict.failed().empty() ? "" : sentence(verdict.failed().front()));
    EXPECT_TRUE(verification.solidity.solid());
    ASSERT_TRUE(verification.grades);
    EXPECT_NEAR(verification.grades->symbolContrast.value, gradesOf(request, result).symbolContrast.value, 0.03);
    EXPECT_GE(verification.reading.tiltDeg.value_or(0), 10) << markName(mark);  // the bend of the sphere sets the limit
    EXPECT_TRUE(verification.reading.pixelsPerModule);
  }
}

TEST_F(MarkTest, VerifyTakesTheAlbedoOfAShadowFromTheReport) {
  EngraveRequest request = requestFor(Mark::Shadow);
  request.marking.albedo = 0.5;
  const EngraveResult result = engraved(sphere(), request);
  const auto fromReport = requestFromReport(reportOf(request, result));
  ASSERT_TRUE(fromReport.has_value()) << sentence(fromReport.error().message);
  EXPECT_EQ(fromReport->albedo, 0.5);
}

TEST_F(MarkTest, VerifyOfTheBodyAloneSeesWhereItsInlayBelongs) {
  const EngraveRequest request = requestFor(Mark::Inlay);
  const EngraveResult result = engraved(sphere(), request);
  const VerifyRequest verification = verifyRequestOf(request, result);
  EXPECT_TRUE(judge(verification, verified(verification, result.mesh)).passed());
  EXPECT_FALSE(judge(verification, verified(verification, sphere()->prepared.mesh)).reads.passed());  // without pockets
}

TEST_F(MarkTest, AnInvertedCodeIsWarnedOf) {
  EngraveRequest request = requestFor(Mark::Paint);
  request.marking.darkReflectance = 0.85;
  request.marking.albedo = 0.05;
  const EngraveResult result = engraved(sphere(), request);
  const ReadingEvidence reading = readCarving(request, result);
  const Verdict verdict = judge(request, result, reading);
  ASSERT_FALSE(verdict.reads.warnings.empty());
  EXPECT_EQ(verdict.reads.warnings.front().code, "code-inverted");
  EXPECT_GT(gradesOf(request, result).symbolContrast.value, 0.6);
  const auto row = nlohmann::json::parse(describeRow({request, result, reading, std::nullopt, verdict, 0}));
  EXPECT_EQ(row.at("grades").at("iso15415"), gradesOf(request, result).iso15415);
}

TEST_F(MarkTest, ACameraFromTheSideSeesTheInkWhereItLies) {
  const EngraveResult result = engraved(sphere(), requestFor(Mark::Paint));
  const Placement& placement = result.placement;
  const ProjectionFrame camera = tilted(placement.frame, 30, 0);
  constexpr int kPixels = 200;
  BottomUp<float> picture(kPixels, kPixels, 1);
  addInkSeen(picture, camera, placement.symbolMm, *sphere()->raster, result);
  const RayTree tree(sphere()->prepared.mesh);
  int different = 0;
  for (int k = 0; k < kPixels * kPixels; ++k) {
    const Vec2 at = (Vec2(k % kPixels, k / kPixels) + 0.5 - kPixels / 2.0) * (placement.symbolMm / kPixels);
    const auto hit = tree.firstHit(camera.eye(), camera.rayDirection(at), 0);
    if (!hit) continue;
    const Vec2 module = placement.frame.project(hit->position) / placement.moduleMm;
    const int row = static_cast<int>(std::floor(result.symbol.size / 2.0 - module.y));
    const int column = static_cast<int>(std::floor(module.x + result.symbol.size / 2.0));
    const bool isInside = std::min(row, column) >= 0 && std::max(row, column) < result.symbol.size;
    const bool isDark = isInside && result.symbol.isDark(row, column);
    different += (picture[static_cast<std::size_t>(k)] < 0.5f) != isDark;
  }
  EXPECT_LT(different, 0.002 * kPixels * kPixels);
}

}  // namespace
}  // namespace qrelief
