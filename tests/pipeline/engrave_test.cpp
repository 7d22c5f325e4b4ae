// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/engrave.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "io/write_stl.h"
#include "messages/sentences.h"
#include "native/zxing_decoder.h"
#include "pipeline/add_inlay.h"
#include "pipeline/default_patterns.h"
#include "report/report.h"
#include "support/brute_force.h"
#include "support/follow_job.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class EngraveTest : public GlTest {
 protected:
  static std::shared_ptr<const EngravableModel> upload(const Mesh& mesh) {
    auto prepared = prepareModel(shapes::soupOf(mesh), {});
    EXPECT_TRUE(prepared.has_value());
    return EngravableModel::upload(std::move(*prepared));
  }
  static EngraveRequest request(Vec3 centre, double sizeMm) {
    EngraveRequest result;
    result.code.text = "https://qrelief.example";
    result.code.symbol.errorCorrection = ErrorCorrection::M;
    result.placement.centreMm = centre;
    result.placement.sizeMode = SizeMode::Fixed;
    result.placement.sizeMm = sizeMm;
    return result;
  }
  /// Returns the triangles by their corners' positions, to compare meshes.
  static std::set<std::array<std::array<float, 3>, 3>> corners(const Mesh& mesh) {
    std::set<std::array<std::array<float, 3>, 3>> all;
    for (const Triangle& t : mesh.triangles) {
      std::array<std::array<float, 3>, 3> triple{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3f p = mesh.positions[t[k]];
        triple[k] = {p.x, p.y, p.z};
      }
      std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end()), triple.end());
      all.insert(triple);
    }
    return all;
  }
};

TEST_F(EngraveTest, ABumpySphereGetsADecodableCodeAndStaysASolid) {
  const auto model = upload(shapes::bumpySphere(40, 1.5, 5, 5));
  const auto result = engrave(model, request({0, 0, 40}, 25));
  ASSERT_TRUE(result.has_value()) << result.error().message;

  EXPECT_TRUE(result->solidity.solid()) << testing::PrintToString(result->solidity.problems());
  EXPECT_EQ(readWithZxing(result->readerView), "https://qrelief.example");
  EXPECT_EQ(result->placement.symbolMm, 25);
  EXPECT_EQ(result->symbol.size, 17 + 4 * result->symbol.version);

  // Untouched facets come out bit for bit, as many as reported.
  const auto before = corners(model->prepared.mesh);
  const auto after = corners(result->mesh);
  std::size_t unchanged = 0;
  for (const auto& triangle : before) unchanged += after.count(triangle);
  EXPECT_EQ(unchanged, result->keptTriangles);
  EXPECT_GT(unchanged, before.size() * 3 / 4);
  EXPECT_LT(result->solidity.volumeMm3, signedVolume(model->prepared.mesh));
}

TEST_F(EngraveTest, ReusesTheMeasurementsOfThePlaceForAnotherCode) {
  const auto model = upload(shapes::bumpySphere(40, 1.5, 5, 5));
  const auto carve = [&](EngraveRequest engraving, std::shared_ptr<PlacementMeasurement> measured) {
    auto job = CarveJob::create(model, std::move(engraving), {.measured = std::move(measured)});
    EXPECT_TRUE(job.has_value());
    EXPECT_EQ((*job)->placementMeasurement(), nullptr);
    EXPECT_TRUE(runToEnd(**job).has_value());
    return std::move(*job);
  };
  EngraveRequest engraving = request({0, 0, 40}, 25), other = engraving;
  other.code.text = "https://example.org/abcde";  // as long: the same place
  const auto expected = engrave(model, engraving);
  ASSERT_TRUE(expected.has_value());
  const auto before = carve(other, nullptr)->placementMeasurement();
  auto job = CarveJob::create(model, engraving, {.measured = before});
  ASSERT_TRUE(job.has_value());
  const auto result = runToEnd(**job);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ((*job)->placementMeasurement(), before);
  EXPECT_EQ(writeStl(result->mesh), writeStl(expected->mesh));
  EXPECT_EQ(result->luminance, expected->luminance);

  engraving.marking.albedo = 0.5;  // a place measured for other settings is not reused
  EXPECT_NE(carve(engraving, before)->placementMeasurement(), before);
}

TEST_F(EngraveTest, RecordsEveryPassOfTheSearchOnRequest) {
  const auto model = upload(shapes::icosphere(40, 5));
  EngraveRequest engraving = request({0, 0, 40}, 25);
  const auto plain = engrave(model, engraving);
  ASSERT_TRUE(plain.has_value());
  EXPECT_TRUE(plain->search.passes.empty());

  engraving.depth.recordSearch = true;
  const auto result = engrave(model, engraving);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->depths.depthMm, plain->depths.depthMm);  // recording changes nothing
  const SearchRecord& record = result->search;
  ASSERT_EQ(record.passes.size(), static_cast<std::size_t>(result->searchIterations));
  const SubmoduleMask mask =
      submodulesToCarve(result->symbol, *result->request.code.modulePattern, *result->request.code.finderPattern);
  ASSERT_EQ(record.carved.size(), static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 1)));
  EXPECT_EQ(record.luminance, Grid<float>(result->luminance));
  // The last pass measured the final depths.
  const SearchRecord::Pass& last = record.passes.back();
  constexpr int kQuiet = kQuietZoneSubmodules;
  for (std::size_t k = 0; k < record.carved.size(); ++k) {
    const auto i = static_cast<int>(record.carved[k]);
    ASSERT_TRUE(mask[record.carved[k]]);
    ASSERT_EQ(last.depthMm[k], static_cast<float>(result->depths.depthMm[record.carved[k]]));
    ASSERT_LE(last.depthMm[k], record.limitMm[k]);
    ASSERT_EQ(last.luminance[k], record.luminance.at(i / mask.rows() + kQuiet, i % mask.rows() + kQuiet));
  }
  EXPECT_NE(record.passes.front().depthMm, last.depthMm);
}

TEST_F(EngraveTest, DefaultPatternsCarveLikeTheSameExplicitSettings) {
  const auto model = upload(shapes::icosphere(40, 5));
  EngraveRequest left = request({0, 0, 40}, 25);
  left.depth.carveFor = CarveFor::Print;
  const auto byDefault = engrave(model, left);
  ASSERT_TRUE(byDefault.has_value()) << byDefault.error().message;
  EngraveRequest said = left;
  said.code.modulePattern = ModulePattern::ThickPlus;
  said.code.finderPattern = FinderPattern::None;
  said.depth.contrast = kWholeFinderContrastSmall * left.depth.contrastAsked();
  said.depth.maxDepthMm = kMaxDepthModules * byDefault->placement.moduleMm;
  const auto same = engrave(model, said);
  ASSERT_TRUE(same.has_value()) << same.error().message;
  EXPECT_EQ(writeStl(byDefault->mesh), writeStl(same->mesh));
}

TEST_F(EngraveTest, FinderPatternsArePatternedWhereWallsAreThin) {
  EngraveRequest left = request({0, 0, 0}, 30);  // modules of 1.2 mm
  left.placement.upHint = {0, 1, 0};
  const auto findersOn = [&](double thicknessMm) {
    const auto result = engrave(upload(shapes::plate({60, 60}, thicknessMm, 4, 4)), left);
    EXPECT_TRUE(result.has_value());
    return result ? result->request.code.finderPattern : std::nullopt;
  };
  EXPECT_EQ(findersOn(left.depth.minWallMm + 1.9), FinderPattern::None);
  EXPECT_EQ(findersOn(left.depth.minWallMm + 1.6), FinderPattern::ThickPlusSharp);
}

TEST_F(EngraveTest, TheDepthVariesBySubmoduleAndOnlyMaskedSubmodulesAreCarved) {
  EngraveRequest engraving = request({0, 0, 40}, 25);
  engraving.code.modulePattern = ModulePattern::Square;
  const auto result = engrave(upload(shapes::icosphere(40, 5)), engraving);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  const SubmoduleMask mask =
      submodulesToCarve(result->symbol, ModulePattern::Square, *result->request.code.finderPattern);
  std::set<double> depths;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int column = 0; column < mask.rows(); ++column) {
      const double depth = result->depths.depth(row, column);
      ASSERT_EQ(depth > 0, mask.at(row, column));
      if (depth > 0) depths.insert(depth);
    }
  }
  EXPECT_GE(depths.size(), 4u);
  // Wide finder patterns need more depth than single modules.
  double finder = 0, data = 0;
  int finderCount = 0, dataCount = 0;
  for (int row = 0; row < mask.rows(); ++row)
    for (int column = 0; column < mask.rows(); ++column) {
      const double depth = result->depths.depth(row, column);
      if (depth == 0) continue;
      const bool isFinder = result->symbol.role(row / 5, column / 5) == ModuleRole::Finder;
      (isFinder ? finder : data) += depth;
      ++(isFinder ? finderCount : dataCount);
    }
  EXPECT_GT(finder / finderCount, data / dataCount);
}

TEST_F(EngraveTest, NoFloorIsNearerToTheBackThanTheMinimumWall) {
  // A plate of 1.3 mm leaves 0.3 mm to carve with 1 mm of wall; the code needs more.
  const Mesh plate = shapes::plate({60, 60}, 1.3, 6, 6);
  EngraveRequest engraving = request({0, 0, 0}, 30);
  engraving.depth.minWallMm = 1;
  const auto result = engrave(upload(plate), engraving);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  EXPECT_GT(result->limitedSubmodules, 0u);
  // The patch reaches as far as walls matter: beyond the quiet zone by the wall and the deepest pocket, 1.2 modules.
  const double moduleMm = result->placement.moduleMm;
  EXPECT_GE(result->placement.patch.radiusMm, (30 + 8 * moduleMm) / std::sqrt(2.0) + 1 + 1.2 * moduleMm);
  double lowest = 0;
  for (const Vec3f& p : result->mesh.positions)
    if (p.z > -1.29f) lowest = std::min<double>(lowest, p.z);
  EXPECT_GE(-lowest, 0.25);
  EXPECT_LE(-lowest, 0.3 + 1e-4);
}

TEST_F(EngraveTest, RefusesAWallWithNothingToSpareWithTheReason) {
  EngraveRequest engraving = request({0, 0, 0}, 30);
  engraving.depth.minWallMm = 2;
  const auto result = engrave(upload(shapes::plate({60, 60}, 1.3, 6, 6)), engraving);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
  EXPECT_NE(sentence(result.error().message).find("2 mm"), std::string::npos) << result.error().message;
}

TEST_F(EngraveTest, RefusesASizeThatDoesNotFitAndNamesTheLargestThatDoes) {
  const Mesh plate = shapes::plate({40, 40}, 5, 4, 4);
  const auto result = engrave(upload(plate), request({0, 0, 0}, 35));
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().kind, ErrorKind::NoSolution);
  // Version 2 has 25 modules, 33 with the quiet zone, so 40 mm · 25/33 = 30.30 mm fit.
  EXPECT_NE(sentence(result.error().message).find("30.3 mm"), std::string::npos) << result.error().message;

  // The size named in the message does fit.
  EXPECT_TRUE(engrave(upload(plate), request({0, 0, 0}, 30.29)).has_value());
}

TEST_F(EngraveTest, TheFreeSizeFitsAtEveryRotation) {
  const auto model = upload(shapes::plate({40, 40}, 5, 4, 4));
  EngraveRequest engraving = request({0, 0, 0}, 0);
  engraving.placement.sizeMode = SizeMode::Free;
  for (const double angle : {0.0, 30.0, 45.0}) {
    engraving.placement.rotateDeg = angle;
    const auto result = engrave(model, engraving);
    ASSERT_TRUE(result.has_value()) << result.error().message;
    EXPECT_NEAR(result->placement.symbolMm, 40 / std::sqrt(2.0) * 25 / 33, 0.01);
    EXPECT_TRUE(result->solidity.solid());
  }
}

TEST_F(EngraveTest, EveryPatternMakesASolid) {
  const auto model = upload(shapes::bumpySphere(40, 1, 4, 5));
  for (const ModulePattern modules :
       {ModulePattern::None, ModulePattern::ThinPlus, ModulePattern::Diamond, ModulePattern::ThickPlus}) {
    for (const FinderPattern finders : {FinderPattern::None, FinderPattern::AsModules, FinderPattern::Diamond}) {
      EngraveRequest engraving = request({0, 0, 40}, 25);
      engraving.code.modulePattern = modules;
      engraving.code.finderPattern = finders;
      const auto result = engrave(model, engraving);
      ASSERT_TRUE(result.has_value()) << result.error().message;
      EXPECT_TRUE(result->solidity.solid()) << static_cast<int>(modules) << " " << static_cast<int>(finders) << " "
                                            << testing::PrintToString(result->solidity.problems());
    }
  }
}

TEST_F(EngraveTest, APatternOfOnesOwnMakesASolid) {
  const auto model = upload(shapes::bumpySphere(40, 1, 4, 5));
  for (const char* mask : {"10101/01010/10101/01010/10101", "11111/10001/10101/10001/11111"}) {
    EngraveRequest engraving = request({0, 0, 40}, 25);
    engraving.code.ownPattern = moduleMaskFromText(mask);
    engraving.code.finderPattern = FinderPattern::AsModules;
    const auto result = engrave(model, engraving);
    ASSERT_TRUE(result.has_value()) << result.error().message;
    EXPECT_TRUE(result->solidity.solid()) << mask << " " << testing::PrintToString(result->solidity.problems());
    const SubmoduleMask expected =
        submodulesToCarve(result->symbol, *engraving.code.ownPattern, FinderPattern::AsModules);
    for (std::size_t k = 0; k < expected.size(); ++k)
      ASSERT_TRUE(expected[k] || result->depths.depthMm[k] == 0) << mask << " " << k;
  }
}

TEST_F(EngraveTest, ACodeOverAnEdgeIsViewedFromBetweenItsFaces) {
  const auto result = engrave(upload(shapes::box({80, 80, 80})), request({40, 0, 40}, 20));
  ASSERT_TRUE(result.has_value()) << result.error().message;
  EXPECT_TRUE(result->solidity.solid()) << testing::PrintToString(result->solidity.problems());
  EXPECT_GT(result->placement.frame.normal.x, 0.4);
  EXPECT_GT(result->placement.frame.normal.z, 0.4);
}

TEST_F(EngraveTest, UsesAGivenDirectionUnchanged) {
  EngraveRequest engraving = request({0, 0, 40}, 20);
  engraving.placement.direction = Vec3(0.2, 0, 1);
  const auto result = engrave(upload(shapes::icosphere(40, 5)), engraving);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  EXPECT_LT(glm::length(result->placement.frame.normal - glm::normalize(Vec3(0.2, 0, 1))), 1e-12);
  EXPECT_TRUE(result->placement.iterations.empty());
}

TEST_F(EngraveTest, TheTopOfTheSymbolPointsInTheGivenDirection) {
  EngraveRequest engraving = request({40, 0, 0}, 20);
  engraving.placement.upHint = {0, 0, 1};
  const auto upright = engrave(upload(shapes::icosphere(40, 5)), engraving);
  engraving.placement.rotateDeg = 90;
  const auto turned = engrave(upload(shapes::icosphere(40, 5)), engraving);
  ASSERT_TRUE(upright.has_value() && turned.has_value());
  EXPECT_GT(upright->placement.frame.up.z, 0.99);
  // The code turns anticlockwise for the viewer: seen from +X with +Z up, its top then points to -Y.
  EXPECT_LT(turned->placement.frame.up.y, -0.99);
}

TEST_F(EngraveTest, CountsTheCrossingsThatTheModelHad) {
  Mesh mesh = shapes::tangledSphere();
  for (Vec3f& p : mesh.positions) p *= 4.0f;
  auto prepared = prepareModel(shapes::soupOf(mesh), {.repair = {.untangle = false}});
  ASSERT_TRUE(prepared && prepared->crossesItself);
  const TrianglePair pair = prepared->crossings.value().front();
  const Vec3 opposite = -prepared->mesh.corner(pair[0], 0);
  const auto result = engrave(EngravableModel::upload(std::move(*prepared)), request(opposite, 20));
  ASSERT_TRUE(result.has_value()) << result.error().message;
  EXPECT_EQ(result->inheritedSelfIntersections, 5u);
  EXPECT_EQ(checkSolidity(result->mesh)->selfIntersections, 5u);
}

TEST_F(EngraveTest, RefusesAnOpenModelBeforeAnyWork) {
  Mesh open = shapes::box({40, 40, 40});
  open.triangles.resize(10);
  const auto job = CarveJob::create(upload(open), request({0, 0, 20}, 20));
  ASSERT_FALSE(job.has_value());
  EXPECT_EQ(job.error().kind, ErrorKind::BadInput);
}

TEST_F(EngraveTest, RefusesInvalidRequestsAsBadUsage) {
  const auto model = upload(shapes::icosphere(40, 3));
  const auto codeOf = [&](const EngraveRequest& engraving) {
    const auto job = CarveJob::create(model, engraving);
    return job ? std::optional<ErrorKind>() : job.error().kind;
  };
  EngraveRequest engraving = request({0, 0, 40}, 20);
  engraving.depth.contrast = 1.5;
  EXPECT_EQ(codeOf(engraving), ErrorKind::BadUsage);
  engraving = request({0, 0, 40}, -3);
  EXPECT_EQ(codeOf(engraving), ErrorKind::BadUsage);
  engraving = request({0, 0, 40}, 20);
  engraving.placement.eyeDistanceMm = 0;
  EXPECT_EQ(codeOf(engraving), ErrorKind::BadUsage);
  engraving = request({0, 0, 40}, 20);
  engraving.code.text = "";
  EXPECT_EQ(codeOf(engraving), ErrorKind::BadInput);
  engraving = request({0, 0, 40}, 20);
  engraving.print.printer.nozzleMm = 0;
  EXPECT_EQ(codeOf(engraving), ErrorKind::BadUsage);
  engraving = request({0, 0, 40}, 20);
  engraving.depth.lights = {{.elevationDeg = 0}};
  EXPECT_EQ(codeOf(engraving), ErrorKind::BadUsage);
  engraving.depth.lights = {{.strength = -1}};
  EXPECT_EQ(codeOf(engraving), ErrorKind::BadUsage);
  engraving.depth.lights = std::vector<DirectionalLight>(3);
  EXPECT_EQ(codeOf(engraving), ErrorKind::BadUsage);
}

TEST_F(EngraveTest, ALampThatShinesIntoThePocketsDeepensThem) {
  const auto model = upload(shapes::box({50, 50, 10}));
  EngraveRequest engraving = request({0, 0, 5}, 25);
  const auto bySky = engrave(model, engraving);
  engraving.depth.lights = {{.azimuthDeg = 90, .elevationDeg = 60, .strength = 1}};
  const auto byLamp = engrave(model, engraving);
  ASSERT_TRUE(bySky && byLamp);
  EXPECT_GT(summarise(byLamp->depths).meanMm, summarise(bySky->depths).meanMm);
  // The quiet zone's corner is open.
  EXPECT_NEAR(byLamp->received[0].lamps, std::sin(60 * std::numbers::pi / 180), 0.01);
  EXPECT_NEAR(byLamp->luminance[0], 1, 0.01);
}

TEST_F(EngraveTest, AKnownPlaceLeavesOutTheFirstStage) {
  const auto model = upload(shapes::icosphere(40, 4));
  const EngraveRequest engraving = request({0, 0, 40}, 25);
  const Symbol symbol = *encodeSymbol(engraving.code.text, engraving.code.symbol);
  PlacementSearch search(model->prepared, *model->renderer, symbol.size, searchedPlacement(engraving, symbol.size));
  while (!*search.step()) {
  }
  const FoundPlacement placed = search.found();
  EXPECT_THAT(followJob(**CarveJob::create(model, engraving, {.placed = &placed})),
              testing::ElementsAre("measuring-surface", "finding-depth", "carving-mesh", "checking-solid",
                                   "looking-at-result"));
}

TEST_F(EngraveTest, IsDeterministic) {
  const auto model = upload(shapes::bumpySphere(40, 1, 4, 4));
  const auto first = engrave(model, request({0, 0, 40}, 25));
  const auto second = engrave(model, request({0, 0, 40}, 25));
  ASSERT_TRUE(first.has_value() && second.has_value());
  EXPECT_EQ(writeStl(first->mesh), writeStl(second->mesh));
}

TEST_F(EngraveTest, TheReportHasTheKeysOfTheContract) {
  const auto model = upload(shapes::icosphere(40, 5));
  const EngraveRequest engraving = request({0, 0, 40}, 25);
  const auto result = engrave(model, engraving);
  ASSERT_TRUE(result.has_value());
  ReportContext context;
  context.reading = evidenceOf(readFrontal(result->readerView), engraving.code.text);
  context.verdict = judge(engraving, *result, context.reading);
  const auto report = nlohmann::json::parse(makeReport(engraving, *model, *result, context));
  const std::map<std::string, std::vector<std::string>> keys = {
      {"input", {"file", "format", "triangles", "vertices", "scaleToMm", "sizeMm", "warnings"}},
      {"symbol", {"version", "ecc", "mask", "modules", "rows"}},
      {"projection", {"method", "centre", "normal", "up", "eyeDistanceMm", "iterations"}},
      {"size", {"symbolMm", "moduleMm", "guaranteedMm", "mode"}},
      {"depth", {"meanMm", "maxMm", "p95Mm", "iterations", "limitedSubmodules", "solver"}},
      {"mesh", {"triangles", "vertices", "keptTriangles", "closed", "manifold", "selfIntersections", "volumeMm3"}},
      {"colour", {"layers", "changes", "secondG", "firstWasteG", "secondWasteG", "wasteMinutes", "towerG"}},
      {"verification", {"decoded", "text", "tries", "reads", "readsNeeded", "views", "failedChecks", "verdict"}},
      {"timingsMs",
       {"load", "prepare", "direction", "size", "surface", "depthSearch", "embed", "verify", "write", "total"}},
      {"gl", {"renderer", "version"}}};
  for (const auto& [group, names] : keys)
    for (const std::string& name : names) EXPECT_TRUE(report.at(group).contains(name)) << group << "." << name;
  EXPECT_EQ(report["text"], engraving.code.text);
  EXPECT_EQ(report["symbol"]["rows"].size(), static_cast<std::size_t>(result->symbol.size));
  EXPECT_TRUE(report["verification"]["decoded"].get<bool>());
  EXPECT_TRUE(report["verification"]["failedChecks"].empty());
}

TEST_F(EngraveTest, ACentreOnAnEdgeOrCornerIsViewedFromBetweenTheFaces) {
  const auto model = upload(shapes::box({60, 60, 60}));
  for (const Vec3 centre : {Vec3(30, 4, 30), Vec3(30, 30, 30)}) {
    for (const SurfaceMode surface : {SurfaceMode::Preserved, SurfaceMode::Resampled}) {
      EngraveRequest engraving = request(centre, 15);
      engraving.depth.surface = surface;
      auto result = engrave(model, engraving);
      ASSERT_TRUE(result.has_value()) << result.error().message;
      ASSERT_TRUE(addInlay(*model, *result));
      EXPECT_TRUE(result->solidity.solid()) << testing::PrintToString(result->solidity.problems());
      EXPECT_TRUE(result->inlaySolidity.solid()) << testing::PrintToString(result->inlaySolidity.problems());
      if (surface == SurfaceMode::Preserved) {
        const double lost = signedVolume(model->prepared.mesh) - result->solidity.volumeMm3;
        EXPECT_NEAR(result->inlaySolidity.volumeMm3, lost, 2e-3);
      }
    }
  }
}

TEST_F(EngraveTest, AWrongOrMissingReadingFailsTheCheck) {
  const auto model = upload(shapes::icosphere(40, 4));
  const EngraveRequest engraving = request({0, 0, 40}, 25);
  const auto result = engrave(model, engraving);
  ASSERT_TRUE(result.has_value());
  const auto failed = [&](const char* read) {
    std::vector<std::string> codes;
    const ReadingEvidence reading = evidenceOf(std::vector<std::string>(72, read), engraving.code.text);
    for (const Message& failure : judge(engraving, *result, reading).failed()) codes.push_back(failure.code);
    return codes;
  };
  EXPECT_THAT(failed(engraving.code.text.c_str()), testing::IsEmpty());
  EXPECT_THAT(failed(""), testing::ElementsAre("too-shallow"));  // nothing was decoded
  EXPECT_THAT(failed("another text"), testing::ElementsAre("other-text"));
}

TEST(DepthSummary, IsTheMeanMaximumAnd95thPercentileOfTheCarvedSubmodules) {
  DepthField depths{10, 10, std::vector<double>(100, 0)};
  for (int i = 0; i < 20; ++i) depths.depthMm[static_cast<std::size_t>(i)] = 0.1 * (i + 1);
  const DepthSummary summary = summarise(depths);
  EXPECT_NEAR(summary.meanMm, 1.05, 1e-12);
  EXPECT_NEAR(summary.maxMm, 2.0, 1e-12);
  EXPECT_NEAR(summary.p95Mm, 1.9, 1e-12);
}

}  // namespace
}  // namespace qrelief
