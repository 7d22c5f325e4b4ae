// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/verify.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/three_mf/source.h"
#include "math/affine.h"
#include "messages/sentences.h"
#include "native/zxing_decoder.h"
#include "pipeline/engrave.h"
#include "report/report.h"
#include "report/verify_report.h"
#include "settings/preset.h"
#include "support/follow_job.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// Plate that the engraver carved, and its report; every sample here derives from it.
struct Sample {
  Mesh mesh;
  std::string report;
};

Sample engravedPlate(const std::string& text, double maxDepthMm) {
  auto prepared = prepareModel(shapes::soupOf(shapes::box({50, 50, 10})), {});
  const auto model = EngravableModel::upload(std::move(*prepared));
  EngraveRequest request;
  request.code.text = text;
  request.code.symbol.version = 1;
  request.placement.centreMm = {0, 0, 5};
  request.placement.upHint = {0, 1, 0};
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 25.2;
  request.depth.maxDepthMm = maxDepthMm;
  const auto result = engrave(model, request);
  EXPECT_TRUE(result.has_value()) << result.error().message;
  return {result->mesh, makeReport(request, *model, *result, {})};
}

class VerifyTest : public GlTest {
 protected:
  static const Sample& good() {
    static const Sample sample = engravedPlate("QRELIEF", 0.8);
    return sample;
  }
  static VerifyRequest requestOf(const Sample& sample) {
    auto request = requestFromReport(sample.report);
    EXPECT_TRUE(request.has_value()) << request.error().message;
    request->ranges = false;
    return *request;
  }
  struct Verified : VerifyResult {
    Verdict verdict;
  };
  static Verified verify(const Mesh& mesh, const VerifyRequest& request) {
    auto job = VerifyJob::create(mesh, request, zxingDecoders());
    EXPECT_TRUE(job.has_value());
    EXPECT_THAT(followJob(**job),
                testing::ElementsAre("checking-solid", "measuring-carving", "tracing-light", "reading-pictures"));
    VerifyResult result = (*job)->takeResult();
    Verdict verdict = judge(request, result);
    return {std::move(result), std::move(verdict)};
  }
  static VerifyReportContext contextOf(const Verified& verified) {
    VerifyReportContext context;
    context.fileName = "a.stl";
    context.verdict = verified.verdict;
    return context;
  }
  static std::vector<std::string> codesOf(const Verified& verified) {
    std::vector<std::string> codes;
    for (const Message& failure : verified.verdict.failed()) codes.push_back(failure.code);
    return codes;
  }
};

TEST_F(VerifyTest, AGoodEngravingPassesEveryCheckByItsMesh) {
  VerifyRequest request = requestOf(good());
  request.ranges = true;
  const Verified result = verify(good().mesh, request);
  EXPECT_THAT(codesOf(result), IsEmpty());
  EXPECT_TRUE(result.solidity.solid());
  EXPECT_TRUE(result.reading.frontal.enough()) << result.reading.frontal.reads;
  EXPECT_GE(result.reading.tiltDeg.value_or(-1), 15);
  EXPECT_LE(result.reading.pixelsPerModule.value_or(99), 5);
  EXPECT_LT(result.reading.cornerErrorModules.value_or(99), 0.5);
  ASSERT_TRUE(result.features);
  EXPECT_EQ(result.features->pattern, ModulePattern::ThickPlus);
  EXPECT_NEAR(result.features->pocketMm, 0.72, 1e-9);
  // The mesh has the carving that the engraver reports; `verify` finds it without using the report.
  const auto report = nlohmann::json::parse(good().report);
  EXPECT_NEAR(result.features->meanDepthMm, report["depth"]["meanMm"].get<double>(), 0.02);
  ASSERT_TRUE(result.features->wallMm);
  EXPECT_NEAR(*result.features->wallMm, 10 - report["depth"]["maxMm"].get<double>(), 0.02);
  ASSERT_TRUE(result.grades);
  EXPECT_EQ(result.grades->fixedPatternDamage.grade, 4);
}

TEST_F(VerifyTest, ReportsAMirroredEngraving) {
  Mesh mesh = good().mesh;
  for (Vec3f& p : mesh.positions) p.x = -p.x;
  mesh = shapes::insideOut(mesh);
  const Verified result = verify(mesh, requestOf(good()));
  EXPECT_TRUE(result.solidity.solid());
  EXPECT_EQ(result.profile.pose, SymbolPose::Mirrored);
  EXPECT_FALSE(result.reading.frontal.enough());
  EXPECT_THAT(codesOf(result), testing::ElementsAre("mirrored"));
}

TEST_F(VerifyTest, ReportsARaisedCode) {
  // The plate's upper face is pushed through: floors 0.3 … 0.8 mm below it now lie as far above it.
  Mesh mesh = good().mesh;
  for (Vec3f& p : mesh.positions)
    if (p.z > 0) p.z = 10 - p.z;
  const Verified result = verify(mesh, requestOf(good()));
  EXPECT_THAT(codesOf(result), Contains("raised"));
  EXPECT_LT(result.profile.meanDepthMm, -0.1);
  EXPECT_FALSE(result.reading.frontal.enough());
}

TEST_F(VerifyTest, ReportsATooShallowEngraving) {
  Mesh mesh = good().mesh;
  for (Vec3f& p : mesh.positions)
    if (p.z > 0) p.z = 5 - (5 - p.z) * 0.15f;
  const Verified result = verify(mesh, requestOf(good()));
  EXPECT_TRUE(result.solidity.solid());
  ASSERT_THAT(codesOf(result), testing::ElementsAre("too-shallow"));
  EXPECT_THAT(sentence(result.verdict.failed()[0]), HasSubstr("mm deep on average"));
  EXPECT_EQ(result.verdict.prints.reasons.front().code, "shallower-than-layers");
}

TEST_F(VerifyTest, FindsNoCodeOnAPlainPlate) {
  const Verified result = verify(shapes::box({50, 50, 10}), requestOf(good()));
  EXPECT_THAT(codesOf(result), testing::ElementsAre("no-code"));
}

TEST_F(VerifyTest, ReportsABrokenSolidWithThePlace) {
  Mesh mesh = good().mesh;
  mesh.triangles.erase(mesh.triangles.begin());
  const Verified result = verify(mesh, requestOf(good()));
  ASSERT_THAT(codesOf(result), testing::ElementsAre("not-solid-at"));
  EXPECT_THAT(sentence(result.verdict.failed()[0]), HasSubstr("3 open edges, the first at "));
  EXPECT_TRUE(result.reading.frontal.enough());
}

TEST_F(VerifyTest, ReportsInheritedCrossingsAndPasses) {
  VerifyRequest request = requestOf(good());
  Verified result = verify(good().mesh, request);
  result.solidity.selfIntersections = 3;
  const auto codes = [&](std::size_t inherited) {
    request.inheritedSelfIntersections = inherited;
    result.verdict = judge(request, result);
    return codesOf(result);
  };
  EXPECT_THAT(codes(3), IsEmpty());
  EXPECT_EQ(result.verdict.solid.level, Level::Barely);
  EXPECT_EQ(result.verdict.solid.reasons.front().code, "inherited-crossings");
  EXPECT_THAT(codes(2), testing::SizeIs(1));
  EXPECT_EQ(result.verdict.solid.level, Level::Bad);
}

TEST_F(VerifyTest, ATurnedCodeDecodesButIsMisplaced) {
  Mesh mesh = good().mesh;
  for (Vec3f& p : mesh.positions) p = {-p.y, p.x, p.z};
  const Verified result = verify(mesh, requestOf(good()));
  EXPECT_EQ(result.profile.pose, SymbolPose::Turned90);
  EXPECT_TRUE(result.reading.frontal.enough());
  EXPECT_THAT(codesOf(result), testing::ElementsAre("turned"));
}

TEST_F(VerifyTest, ReportsAnotherText) {
  VerifyRequest request = requestOf(good());
  request.text = "SOMETHING";
  request.symbol = *encodeSymbol("SOMETHING", {.version = 1});
  const Verified result = verify(good().mesh, request);
  ASSERT_THAT(codesOf(result), Contains("other-text"));
  EXPECT_EQ(result.reading.otherText, "QRELIEF");
}

TEST_F(VerifyTest, ReportsACodeBesideItsPlace) {
  VerifyRequest request = requestOf(good());
  request.frame.centre.x += 4;
  const Verified result = verify(good().mesh, request);
  EXPECT_THAT(codesOf(result), Contains("misplaced"));
  EXPECT_NEAR(result.reading.cornerErrorModules.value_or(0), 4 / 1.2, 0.5);
}

TEST_F(VerifyTest, IsDeterministic) {
  const auto reportOf = [&] {
    const VerifyRequest request = requestOf(good());
    const Verified verified = verify(good().mesh, request);
    return makeVerifyReport(request, verified, contextOf(verified));
  };
  EXPECT_EQ(reportOf(), reportOf());
}

TEST_F(VerifyTest, TheReportHasTheKeysOfTheContract) {
  const VerifyRequest request = requestOf(good());
  const Verified verified = verify(good().mesh, request);
  const auto json = nlohmann::json::parse(makeVerifyReport(request, verified, contextOf(verified)));
  EXPECT_EQ(json["text"], "QRELIEF");
  EXPECT_EQ(json["verified"], true);
  EXPECT_EQ(json["verification"]["decoded"], true);
  EXPECT_EQ(json["verification"]["text"], "QRELIEF");
  EXPECT_EQ(json["verification"]["iso15415"]["simulated"], true);
  EXPECT_EQ(json["verification"]["views"].size(), kFrontalViews.size());
  EXPECT_EQ(json["carving"]["pose"], "as wanted");
  EXPECT_EQ(json["mesh"]["closed"], true);
}

TEST_F(VerifyTest, TheReportOfEngraveHasLayersAndPrintability) {
  const auto report = nlohmann::json::parse(good().report);
  const auto& features = report["depth"]["features"];
  EXPECT_NEAR(features["meanDepthLayers"].get<double>(), report["depth"]["meanMm"].get<double>() / 0.2, 1e-9);
  EXPECT_EQ(features["layerMm"], 0.2);
  EXPECT_EQ(features["pattern"], "thick-plus");
  EXPECT_TRUE(report["verification"]["printability"].is_array());
}

TEST_F(VerifyTest, WarnsOfALabelTooLowToPrint) {
  auto report = nlohmann::json::parse(good().report);
  const auto warnings = [&](const std::string& label) {
    report["label"] = {{"text", label}, {"frame", "square"}};
    const VerifyRequest request = requestOf({{}, report.dump()});
    EXPECT_EQ(request.label, (LabelOptions{label, LabelFrame::Square}));
    return verify(good().mesh, request).verdict.prints.warnings;
  };
  EXPECT_THAT(warnings("A-001"), IsEmpty());
  const auto tooLow = warnings(std::string(69, 'A'));
  ASSERT_EQ(tooLow.size(), 1u);
  EXPECT_EQ(tooLow[0].code, "label-too-small");
}

TEST_F(VerifyTest, FindsTheCodeInAFileThatStandsInItsPoseOnThePrinter) {
  VerifyRequest request = requestOf(good());
  ASSERT_TRUE(request.lowMm);
  const ProjectionFrame as = request.frame;
  request.buildUp = {1, -2, 0.5};
  findInPose(request, good().mesh, nullptr);
  EXPECT_EQ(request.frame, as) << "the file is not turned";
  Affine pose = turnedUp(request.buildUp);
  pose.origin = {128, 100, 7};
  Mesh mesh = good().mesh;
  for (Vec3f& p : mesh.positions) p = Vec3f(pose(Vec3(p)));
  findInPose(request, mesh, nullptr);
  EXPECT_NEAR(glm::distance(request.frame.centre, pose(as.centre)), 0, 1e-4);
  EXPECT_NEAR(glm::distance(request.frame.onPlane({3, 4}), pose(as.onPlane({3, 4}))), 0, 1e-4);
  EXPECT_NEAR(glm::distance(request.frame.eye(), pose(as.eye())), 0, 1e-4);
  EXPECT_EQ(request.buildUp, Vec3(0, 0, 1));
}

TEST_F(VerifyTest, FindsTheCodeInAFileThatIsTurnedWithinItsBoundingBox) {
  VerifyRequest request = requestOf(good());
  const ProjectionFrame as = request.frame;
  request.buildUp = {0, 0, -1};
  Affine pose = turnedUp(request.buildUp);
  Mesh mesh = good().mesh;
  for (Vec3f& p : mesh.positions) p = Vec3f(pose(Vec3(p)));
  const Vec3 back = *request.lowMm - boundingBox(mesh).min;
  for (Vec3f& p : mesh.positions) p += Vec3f(back);
  pose.origin = back;
  findInPose(request, mesh, nullptr);
  EXPECT_NEAR(glm::distance(request.frame.centre, pose(as.centre)), 0, 1e-4);
  EXPECT_EQ(request.buildUp, Vec3(0, 0, 1));
}

TEST_F(VerifyTest, FindsTheCodeInTheOnlyItemThatIsTurned) {
  VerifyRequest request = requestOf(good());
  const ProjectionFrame as = request.frame;
  request.buildUp = {1, 0, 0};
  Affine pose = turnedUp(request.buildUp);
  pose.origin = {30, -4, 2};
  // The other item is lower and farther left, so the file's corner says nothing of the code's item.
  Mesh mesh = shapes::icosphere(10, 1);
  for (Vec3f& p : mesh.positions) p -= Vec3f(200, 0, 80);
  ThreeMfSource source;
  source.runs.resize(2);
  source.runs[0].count = source.runs[1].firstTriangle = mesh.triangles.size();
  source.runs[1].item = 1;
  source.runs[1].count = good().mesh.triangles.size();
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3f& p : good().mesh.positions) mesh.positions.emplace_back(pose(Vec3(p)));
  for (const Triangle& t : good().mesh.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  findInPose(request, mesh, &source);
  EXPECT_NEAR(glm::distance(request.frame.centre, pose(as.centre)), 0, 1e-4);
  EXPECT_NEAR(glm::distance(request.frame.eye(), pose(as.eye())), 0, 1e-4);
}

TEST_F(VerifyTest, RefusesAReportWithoutAPlaceByTheMissingKey) {
  auto report = nlohmann::json::parse(good().report);
  report["projection"].erase("centre");
  const auto request = requestFromReport(report.dump());
  ASSERT_FALSE(request.has_value());
  EXPECT_EQ(request.error().kind, ErrorKind::BadInput);
  EXPECT_THAT(sentence(request.error().message), HasSubstr("not valid: key 'centre' not found"));
  EXPECT_FALSE(requestFromReport("no JSON").has_value());
  EXPECT_FALSE(requestFromReport("[1, 2]").has_value());
  EXPECT_THAT(sentence(requestFromReport(std::string(100'000, '[')).error().message), HasSubstr("nests"));
  report = nlohmann::json::parse(good().report);
  report["symbol"]["rows"][3] = "0102";
  EXPECT_THAT(sentence(requestFromReport(report.dump()).error().message), HasSubstr("Row 4"));
  report["symbol"]["rows"].erase(0);
  EXPECT_THAT(sentence(requestFromReport(report.dump()).error().message), HasSubstr("20 rows"));
}

TEST_F(VerifyTest, RefusesAReportWhoseSymbolDoesNotEncodeItsText) {
  const auto fine = nlohmann::json::parse(good().report);
  const auto errorOf = [&](auto change) {
    nlohmann::json report = fine;
    change(report);
    const auto request = requestFromReport(report.dump());
    return request ? std::string("no error") : sentence(request.error().message);
  };
  const auto setAll = [](nlohmann::json& report, int firstRow, char module) {
    auto& rows = report["symbol"]["rows"];
    for (std::size_t row = firstRow; row < rows.size(); ++row) rows[row] = std::string(rows.size(), module);
  };
  const char* const kOtherText = "does not encode its text";
  EXPECT_THAT(errorOf([&](auto& report) { setAll(report, 0, '0'); }), HasSubstr(kOtherText));
  EXPECT_THAT(errorOf([&](auto& report) { setAll(report, 0, '1'); }), HasSubstr(kOtherText));
  EXPECT_THAT(errorOf([](auto& report) {
                std::string row = report["symbol"]["rows"][0];
                row[0] = '0';
                report["symbol"]["rows"][0] = row;
              }),
              HasSubstr("1 module differs from version 1, level M, mask "))
      << "a corner of a finder pattern";
  EXPECT_THAT(errorOf([](auto& report) {
                for (std::size_t i = 9; i < 13; ++i) {
                  std::string row = report["symbol"]["rows"][i];
                  for (char& module : row) module = module == '1' || &module == &row[6] ? module : '1';
                  report["symbol"]["rows"][i] = row;
                }
              }),
              HasSubstr(kOtherText))
      << "data alone, more than error correction restores";
  EXPECT_THAT(errorOf([](auto& report) { report["text"] = "another"; }), HasSubstr(kOtherText));
  EXPECT_EQ(errorOf([](auto& report) {
              std::string row = report["symbol"]["rows"][20];
              row[20] = row[20] == '1' ? '0' : '1';
              report["symbol"]["rows"][20] = row;
            }),
            "no error")
      << "one data module";
}

TEST_F(VerifyTest, RefusesInvalidRequests) {
  const VerifyRequest fine = requestOf(good());
  const auto codeOf = [&](auto change) {
    VerifyRequest request = fine;
    change(request);
    const auto job = VerifyJob::create(good().mesh, request, zxingDecoders());
    return job ? std::optional<ErrorKind>() : job.error().kind;
  };
  EXPECT_EQ(codeOf([](VerifyRequest& r) { r.text.clear(); }), ErrorKind::BadUsage);
  EXPECT_EQ(codeOf([](VerifyRequest& r) { r.symbolMm = 0; }), ErrorKind::BadUsage);
  EXPECT_EQ(codeOf([](VerifyRequest& r) { r.frame.eyeDistance = 1; }), ErrorKind::BadUsage);
  EXPECT_EQ(codeOf([](VerifyRequest& r) {
              r.frame = makeFrame({0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 250);
            }),
            ErrorKind::BadUsage);
  EXPECT_EQ(codeOf([](VerifyRequest& r) { r.printer.layerMm = 0; }), ErrorKind::BadUsage);
  EXPECT_EQ(codeOf([](VerifyRequest&) {}), std::nullopt);
}

TEST(MeshAsFound, WeldsAndScalesButRepairsNothing) {
  PolygonSoup soup = shapes::soupOf(shapes::box({2, 3, 5}));
  soup.triangles.pop_back();
  const auto mesh = meshAsFound(soup, 10);
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(mesh->triangles.size(), 11u);
  EXPECT_EQ(mesh->positions.size(), 8u);
  EXPECT_EQ(boundingBox(*mesh).size(), Vec3(20, 30, 50));
  soup.positions[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(meshAsFound(soup, 1).error().kind, ErrorKind::BadInput);
  EXPECT_EQ(meshAsFound({}, 1).error().kind, ErrorKind::BadInput);
}

}  // namespace
}  // namespace qrelief
