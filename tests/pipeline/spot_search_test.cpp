// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/spot_search.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

#include "message_codes/pipeline.h"
#include "message_codes/printing.h"
#include "messages/sentences.h"
#include "pipeline/best_spot.h"
#include "pipeline/engrave.h"
#include "pipeline/placement.h"
#include "pipeline/requested_symbol.h"
#include "pipeline/spot_light.h"
#include "projection/flatness.h"
#include "support/follow_job.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class SpotSearchTest : public GlTest {
 protected:
  static std::shared_ptr<const EngravableModel> upload(const Mesh& mesh) {
    auto prepared = prepareModel(shapes::soupOf(mesh), {});
    EXPECT_TRUE(prepared.has_value());
    return EngravableModel::upload(std::move(*prepared));
  }
  static SpotSearchRequest request(double sizeMm) {
    SpotSearchRequest result;
    if (sizeMm > 0) result.placement.sizeMode = SizeMode::Fixed;
    result.placement.sizeMm = sizeMm;
    return result;
  }
};

TEST_F(SpotSearchTest, RanksSpotsThatFaceDownLast) {
  for (const double up : {1.0, -1.0}) {
    SpotSearchRequest parameters = request(30);
    parameters.count = 2;
    parameters.buildUp = BuildDirection{.up = Vec3(0, 0, up)};
    const auto search = findSpots(upload(shapes::box({60, 60, 12})), parameters);
    ASSERT_TRUE(search.has_value());
    ASSERT_FALSE(search->spots.empty());
    EXPECT_GT(search->spots.front().direction.z * up, 0.9);
    EXPECT_FALSE(search->spots.front().facesDown);
  }
}

TEST_F(SpotSearchTest, WarnsOfALampThatGrazesACylinderAndProposesOneAlongIt) {
  SpotSearchRequest parameters = request(22);
  parameters.count = 1;
  parameters.lamps = {{.azimuthDeg = 0, .elevationDeg = 30, .strength = 1}};
  const auto model = upload(shapes::cylinder(20, 80, 128));
  const auto across = findSpots(model, parameters);
  ASSERT_TRUE(across.has_value());
  ASSERT_EQ(across->spots.front().concerns.size(), 1u);
  const Message& concern = across->spots.front().concerns.front();
  EXPECT_EQ(concern.code, "spot-wants-another-lamp");
  EXPECT_THAT(sentenceAndHint(concern), testing::AnyOf(testing::HasSubstr("90,30,1"), testing::HasSubstr("270,30,1")));

  parameters.lamps.front().azimuthDeg = 90;
  const auto along = findSpots(model, parameters);
  ASSERT_TRUE(along.has_value());
  EXPECT_THAT(along->spots.front().concerns, testing::IsEmpty());
}

TEST_F(SpotSearchTest, WarnsOfLampsOnABumpySphereThatNoLampLightsEvenly) {
  SpotSearchRequest parameters = request(25);
  parameters.count = 1;
  parameters.lamps = {{.azimuthDeg = 0, .elevationDeg = 20, .strength = 4}};
  const auto model = upload(shapes::bumpySphere(30, 1.5, 5, 5));
  const auto one = findSpots(model, parameters);
  ASSERT_TRUE(one.has_value());
  ASSERT_FALSE(one->spots.front().concerns.empty());
  EXPECT_EQ(one->spots.front().concerns.back().code, "spot-lit-unevenly-by-lamps");
  EXPECT_THAT(sentenceAndHint(one->spots.front().concerns.back()), testing::HasSubstr("The lamp lights"));

  parameters.lamps.push_back({.azimuthDeg = 180, .elevationDeg = 20, .strength = 4});
  const auto two = findSpots(model, parameters);
  ASSERT_TRUE(two.has_value());
  ASSERT_FALSE(two->spots.front().concerns.empty());
  EXPECT_THAT(sentenceAndHint(two->spots.front().concerns.back()), testing::HasSubstr("The lamps light"));
}

TEST_F(SpotSearchTest, RanksSpotsOfFewLayersFirstForASecondColour) {
  // A side of the box takes larger codes than its top.
  SpotSearchRequest parameters = request(0);
  parameters.placement.sizeMode = SizeMode::Oriented;
  parameters.count = 5;
  parameters.buildUp = BuildDirection{.up = Vec3(0, 0, 1)};
  const auto model = upload(shapes::box({30, 60, 60}));
  const auto one = findSpots(model, parameters);
  parameters.coloured = ColouredCode{};
  parameters.coloured->print.buildUp = *parameters.buildUp;
  const auto two = findSpots(model, parameters);
  ASSERT_TRUE(one.has_value() && two.has_value());
  EXPECT_LT(std::abs(one->spots.front().direction.z), 0.1);
  EXPECT_EQ(one->spots.front().colourLayers, 0);
  EXPECT_GT(two->spots.front().direction.z, 0.9);
  EXPECT_EQ(two->spots.front().colourLayers, 2);
  const Spot& onASide = two->spots.back();
  EXPECT_NEAR(onASide.colourLayers, onASide.symbolMm / 0.2, 2);
}

TEST_F(SpotSearchTest, PutsTheLargestCodeOfASecondColourOnAFlatFace) {
  // Every code on the top has two layers, although the views of the map look at it from aside.
  for (const double edge : {45.0, 60.0, 80.0}) {
    SpotSearchRequest parameters = request(0);
    parameters.count = 1;
    parameters.buildUp = BuildDirection{.up = Vec3(0, 0, 1)};
    parameters.coloured = ColouredCode{};
    parameters.coloured->print.buildUp = *parameters.buildUp;
    const auto spots = findSpots(upload(shapes::box({edge, edge, 5})), parameters);
    ASSERT_TRUE(spots.has_value());
    const Spot& best = spots->spots.front();
    EXPECT_GT(best.direction.z, 0.99) << edge;
    EXPECT_NEAR(best.symbolMm, std::min(40.0, edge * 21 / 29), 1) << edge;
  }
}

TEST_F(SpotSearchTest, RanksSpotsOnSeveralColoursLastWithAWarning) {
  auto soup = shapes::soupOf(shapes::box({60, 60, 12}));
  bool isFirst = true;  // one of the two facets of the top is black
  for (const auto& t : soup.triangles) {
    const Vec3 a = soup.positions[t[0]], b = soup.positions[t[1]], c = soup.positions[t[2]];
    const bool isTop = glm::normalize(glm::cross(b - a, c - a)).z > 0.9;
    soup.colours.emplace_back(isTop && isFirst ? Colour{0, 0, 0} : Colour{255, 255, 255});
    isFirst = isFirst && !isTop;
  }
  auto prepared = prepareModel(soup, {});
  ASSERT_TRUE(prepared.has_value());
  SpotSearchRequest parameters = request(30);
  parameters.count = 2;
  const auto search = findSpots(EngravableModel::upload(std::move(*prepared)), parameters);
  ASSERT_TRUE(search.has_value());
  ASSERT_EQ(search->spots.size(), 2u);
  EXPECT_LT(search->spots[0].direction.z, -0.9);
  EXPECT_THAT(search->spots[0].concerns, testing::IsEmpty());
  EXPECT_GT(search->spots[1].direction.z, 0.9);
  EXPECT_EQ(search->spots[1].concerns.at(0), message<"spot-in-several-colours">());
}

TEST_F(SpotSearchTest, RanksSpotsInTheModelsShadeLastWithAWarning) {
  // The larger half of the plate has a ridge in its middle.
  const Mesh model = shapes::plate(Vec2(130, 60), 10, 130, 4, [](double x, double) {
    if (x > 5) return -3.0;
    return std::abs(x + 30) < 1.1 ? 2.5 : 0.0;
  });
  SpotSearchRequest parameters = request(30);
  parameters.buildUp = BuildDirection{.up = Vec3(0, 0, 1)};
  const auto search = findSpots(upload(model), parameters);
  ASSERT_TRUE(search.has_value()) << search.error().message;
  const auto isUneven = [](const Spot& spot) { return spot.unevenLight > kMostUnevenLight; };
  const std::vector<Spot>& spots = search->spots;
  ASSERT_GE(spots.size(), 2u);
  EXPECT_TRUE(spots.front().concerns.empty());
  bool wasDoubted = false;
  for (const Spot& spot : spots) {
    EXPECT_EQ(spot.concerns.empty(), !spot.facesDown && !isUneven(spot));
    EXPECT_TRUE(spot.concerns.empty() || isUneven(spot) || spot.concerns.front().code == "faces-down");
    EXPECT_FALSE(wasDoubted && spot.concerns.empty()) << "a good one behind a doubtful one";
    wasDoubted = wasDoubted || !spot.concerns.empty();
  }
}

TEST_F(SpotSearchTest, WarnsAboutSpotsTooSmallForTheNozzle) {
  SpotSearchRequest parameters = request(30);
  parameters.leastPrintableMm = 31;
  const auto search = findSpots(upload(shapes::box({60, 60, 12})), parameters);
  ASSERT_TRUE(search.has_value());
  for (const Spot& spot : search->spots) {
    EXPECT_FALSE(spot.prints);
    ASSERT_EQ(spot.concerns.size(), 1u);
    EXPECT_EQ(spot.concerns.front(),
              message<"spot-too-small-to-print">(with::lengthMm<"nozzle">(0.4), with::lengthMm<"needed">(31)));
  }
}

TEST_F(SpotSearchTest, PrefersAShadedSpotToEvenOnesThatAreTooSmallToPrint) {
  // Ridges shade the top, the bottom faces down, and the sides are 10 mm high.
  const Mesh model = shapes::plate(Vec2(60, 60), 10, 60, 4,
                                   [](double x, double) { return std::abs(std::remainder(x, 8)) < 1.1 ? 1.6 : 0.0; });
  SpotSearchRequest wanted = request(0);
  wanted.count = 1;
  wanted.leastPrintableMm = 15;
  wanted.buildUp = BuildDirection{.up = Vec3(0, 0, 1)};
  const auto found = findSpots(upload(model), wanted);
  ASSERT_TRUE(found.has_value()) << sentence(found.error().message);
  const Spot& best = found->spots.front();
  EXPECT_TRUE(best.prints);
  EXPECT_FALSE(best.facesDown);
  EXPECT_GT(best.symbolMm, 15);
  EXPECT_GT(best.direction.z, 0.9);
  EXPECT_GT(best.unevenLight, kMostUnevenLight);
}

TEST_F(SpotSearchTest, EveryOfferedSpotFitsTheCode) {
  const auto model = upload(shapes::bumpySphere(40, 2, 5, 5));
  const auto search = findSpots(model, request(22));
  ASSERT_TRUE(search.has_value()) << search.error().message;
  ASSERT_EQ(search->spots.size(), 5u);
  for (const Spot& spot : search->spots) {
    EXPECT_EQ(spot.symbolMm, 22);
    EXPECT_GE(spot.largestMm, 22);
    EngraveRequest engraving;
    engraving.code.text = "HELLO";  // version 1, the default of the spot search
    engraving.placement = placedAt(spot, request(22).placement);
    const auto engraved = engrave(model, engraving);
    ASSERT_TRUE(engraved.has_value()) << engraved.error().message;
    EXPECT_EQ(engraved->symbol.size, 21);
    EXPECT_NEAR(engraved->placement.guaranteedMm, spot.guaranteedMm, 1e-9);
    EXPECT_LT(glm::distance(engraved->placement.frame.normal, glm::normalize(spot.direction)), 1e-9);
    EXPECT_TRUE(engraved->solidity.solid());
  }
}

TEST_F(SpotSearchTest, HasTheSpotsPlacesAsAnEngravingFindsThem) {
  const auto model = upload(shapes::bumpySphere(30, 1.5, 5, 5));
  EngraveRequest engraving;
  engraving.code.text = "https://qrelief.example";
  const SpotSearchRequest search = spotSearchFor(engraving, *requestedSymbol(engraving.code));
  const auto found = findSpots(model, search);
  ASSERT_TRUE(found.has_value());
  for (const Spot& spot : found->spots) {
    EngraveRequest there = engraving;
    there.placement = placedAt(spot, engraving.placement);
    PlacementSearch placing(model->prepared, *model->renderer, search.modules,
                            searchedPlacement(there, search.modules));
    for (bool done = false; !done;) {
      const Result<bool> step = placing.step();
      ASSERT_TRUE(step.has_value());
      done = *step;
    }
    EXPECT_EQ(spot.placement->symbolMm, placing.placement().symbolMm);
    EXPECT_EQ(spot.placement->frame.up, placing.placement().frame.up);
    EXPECT_EQ(spot.placement->patch.triangles, placing.placement().patch.triangles);
  }
}

TEST_F(SpotSearchTest, OffersTheFacesOfACubeInFullSize) {
  const auto model = upload(shapes::box({60, 60, 60}));
  SpotSearchRequest parameters = request(0);
  parameters.placement.sizeMode = SizeMode::Oriented;
  parameters.count = 6;
  const auto search = findSpots(model, parameters);
  ASSERT_TRUE(search.has_value()) << search.error().message;
  ASSERT_EQ(search->spots.size(), 6u);
  const double most = 60.0 * 21 / 29;  // without the quiet zone
  for (const Spot& spot : search->spots) {
    const Vec3 p = glm::abs(spot.centreMm);
    EXPECT_EQ((p.x == 30) + (p.y == 30) + (p.z == 30), 1);
    EXPECT_NEAR(spot.guaranteedMm, most / std::sqrt(2), 3);
    EXPECT_EQ(spot.aimToleranceDeg, kMaxAimDeg);
  }
  // The map's vertices are up to 3.5 mm apart, and a centre off the middle loses twice its distance.
  EXPECT_GT(search->spots.front().symbolMm, most - 2 * 3.5);
  EXPECT_LT(search->spots.front().symbolMm, most + 1e-3);
}

TEST_F(SpotSearchTest, RanksTheSpotThatDecodesFromWiderAnglesFirst) {
  // A code bends on the ball. The plate has slightly less room, but a code on it stays flat.
  const auto model =
      upload(shapes::together(shapes::icosphere(18, 4), shapes::translated(shapes::box({32, 32, 8}), {60, 0, 0})));
  SpotSearchRequest parameters = request(0);
  parameters.modules = 29;
  parameters.placement.sizeMode = SizeMode::Free;
  parameters.placement.maxSizeMm = 20;
  parameters.count = 3;
  const auto search = findSpots(model, parameters);
  ASSERT_TRUE(search.has_value()) << search.error().message;
  ASSERT_EQ(search->spots.size(), 3u);
  EXPECT_GT(search->spots[0].centreMm.x, 40);
  EXPECT_EQ(search->spots[0].aimToleranceDeg, kMaxAimDeg);
  EXPECT_LT(search->spots[2].centreMm.x, 20);
  EXPECT_LT(search->spots[2].aimToleranceDeg, 10);
  EXPECT_GT(search->spots[2].symbolMm, search->spots[0].symbolMm);
}

TEST_F(SpotSearchTest, AFixedSizeMayBeTheSizeLimit) {
  const auto model = upload(shapes::box({60, 60, 20}));
  SpotSearchRequest parameters = request(25);
  parameters.placement.maxSizeMm = 25;
  const auto search = findSpots(model, parameters);
  ASSERT_TRUE(search.has_value()) << search.error().message;
  EXPECT_EQ(search->spots.front().symbolMm, 25);
}

TEST_F(SpotSearchTest, RoundsACentreToThePrintedDigits) {
  const auto model = upload(shapes::icosphere(30, 4));
  SpotSearchRequest parameters = request(12);
  parameters.scaleToMm = 1000;
  const auto search = findSpots(model, parameters);
  ASSERT_TRUE(search.has_value()) << search.error().message;
  for (const Spot& spot : search->spots) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(spot.centreFileUnits[k], std::round(spot.centreFileUnits[k] * 1e6) / 1e6);
    EXPECT_EQ(spot.centreMm, spot.centreFileUnits * 1000.0);
    EXPECT_NEAR(glm::length(spot.centreMm), 30, 0.2);
  }
}

TEST_F(SpotSearchTest, NamesTheLargestSizeIfTheRequestedOneFitsNowhere) {
  const auto search = findSpots(upload(shapes::icosphere(20, 4)), request(60));
  ASSERT_FALSE(search.has_value());
  EXPECT_EQ(search.error().kind, ErrorKind::NoSolution);
  const std::size_t at = sentence(search.error().message).find("the largest size found is ");
  ASSERT_NE(at, std::string::npos) << search.error().message;
  const double largest = std::stod(sentence(search.error().message).substr(at + 26));
  // From 250 mm the visible cap has a half angle of acos(20/270) about the point; on the plane it ends 250·tan φ from
  // its middle.
  const double rim = 250 * std::tan(std::asin(20.0 / 270));
  EXPECT_NEAR(largest, std::sqrt(2) * rim * 21 / 29, 1);
}

TEST_F(SpotSearchTest, NamesTheLargestSizeEvenIfItIsAboveTheLimit) {
  const auto search = findSpots(upload(shapes::box({100, 100, 20})), request(90));
  ASSERT_FALSE(search.has_value());
  const std::string words = sentence(search.error().message);
  const std::size_t at = words.find("the largest size found is ");
  ASSERT_NE(at, std::string::npos) << words;
  EXPECT_NEAR(std::stod(words.substr(at + 26)), 100.0 * 21 / 29, 1);
}

TEST_F(SpotSearchTest, SaysThatTheRequestedSizeIsTooSmall) {
  SpotSearchRequest limited = request(0);
  limited.placement.sizeMode = SizeMode::Best;
  limited.placement.maxSizeMm = 2;
  for (const SpotSearchRequest& small : {request(4), limited}) {
    const auto search = SpotSearchJob::create(upload(shapes::box({60, 60, 10})), small);
    ASSERT_FALSE(search.has_value());
    EXPECT_EQ(search.error().kind, ErrorKind::NoSolution);
    EXPECT_THAT(sentenceAndHint(search.error().message), testing::HasSubstr("Allow a larger size (at least 4.2 mm)"));
  }
}

TEST_F(SpotSearchTest, RefusesAThinShellAndReportsItsThickness) {
  const Mesh shell = shapes::together(shapes::icosphere(40, 5), shapes::insideOut(shapes::icosphere(39.2, 5)));
  const auto model = upload(shell);
  const auto refused = findSpots(model, request(20));
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::NoSolution);
  EXPECT_NE(sentence(refused.error().message).find("their walls are at most 0."), std::string::npos)
      << refused.error().message;
  EXPECT_NE(hint(refused.error().message).find("--mark auto"), std::string::npos) << hint(refused.error().message);
  SpotSearchRequest thinner = request(20);
  thinner.minWallMm = 0.4;
  EXPECT_TRUE(findSpots(model, thinner).has_value());
}

TEST_F(SpotSearchTest, OffersThinWallsLastIfTheMarkMayBecomePaint) {
  EngraveRequest open;
  open.code.text = "HELLO";
  open.marking.isOpen = true;
  const Symbol symbol = *encodeSymbol(open.code.text, open.code.symbol);
  EXPECT_TRUE(spotSearchFor(open, symbol).offersThinWalls);
  open.marking.isOpen = false;
  EXPECT_FALSE(spotSearchFor(open, symbol).offersThinWalls);

  SpotSearchRequest wanted = request(20);
  wanted.offersThinWalls = true;
  const auto thin = findSpots(
      upload(shapes::together(shapes::icosphere(40, 5), shapes::insideOut(shapes::icosphere(39.2, 5)))), wanted);
  ASSERT_TRUE(thin.has_value()) << sentence(thin.error().message);
  for (const Spot& spot : thin->spots) {
    EXPECT_FALSE(spot.takesPockets);
    ASSERT_FALSE(spot.concerns.empty());
    EXPECT_EQ(spot.concerns.front(), message<"nothing-can-be-carved">(with::lengthMm<"wall">(0.8)));
  }
  // The left half of the plate is 0.7 mm thick.
  wanted.count = 8;
  const auto both = findSpots(
      upload(shapes::plate(Vec2(120, 60), 10, 120, 4, [](double x, double) { return x < 0 ? -9.3 : 0.0; })), wanted);
  ASSERT_TRUE(both.has_value()) << sentence(both.error().message);
  bool wasThin = false;
  for (const Spot& spot : both->spots) {
    if (std::abs(spot.centreMm.x) > 20) {
      EXPECT_EQ(spot.takesPockets, spot.centreMm.x > 0) << spot.centreMm.x;
    }
    EXPECT_FALSE(wasThin && spot.takesPockets) << "a thick wall behind a thin one";
    wasThin = wasThin || !spot.takesPockets;
  }
  EXPECT_TRUE(both->spots.front().takesPockets);
  EXPECT_TRUE(wasThin);
}

TEST_F(SpotSearchTest, UsesTheRequestedDirection) {
  SpotSearchRequest parameters = request(15);
  parameters.placement.direction = Vec3(0, 3, 0);
  const auto search = findSpots(upload(shapes::icosphere(40, 4)), parameters);
  ASSERT_TRUE(search.has_value()) << search.error().message;
  for (const Spot& spot : search->spots) {
    EXPECT_FALSE(spot.needsDirection);
    EXPECT_LT(glm::distance(glm::normalize(spot.direction), Vec3(0, 1, 0)), 1e-12);
  }
}

TEST_F(SpotSearchTest, IsDeterministic) {
  const auto model = upload(shapes::bumpySphere(40, 3, 4, 4));
  const auto first = findSpots(model, request(20));
  const auto second = findSpots(model, request(20));
  ASSERT_TRUE(first.has_value() && second.has_value());
  ASSERT_EQ(first->spots.size(), second->spots.size());
  for (std::size_t i = 0; i < first->spots.size(); ++i) {
    EXPECT_EQ(first->spots[i].centreMm, second->spots[i].centreMm);
    EXPECT_EQ(first->spots[i].direction, second->spots[i].direction);
  }
}

TEST_F(SpotSearchTest, TheMapPrecedesTheSpots) {
  const auto model = upload(shapes::icosphere(40, 4));
  EXPECT_THAT(followJob(**SpotSearchJob::create(model, request(20))),
              testing::ElementsAre("looking-from-all-sides", "testing-spots"));
  const auto found = findSpots(model, request(20));
  ASSERT_TRUE(found.has_value());
  const std::vector<float>& sizes = found->map->sizeMm;
  EXPECT_GT(*std::max_element(sizes.begin(), sizes.end()), 20);
}

TEST_F(SpotSearchTest, UsesAKnownMapOnlyIfItsOptionsAreThoseOfTheSearch) {
  const auto model = upload(shapes::bumpySphere(40, 3, 4, 4));
  const auto first = findSpots(model, request(20));
  ASSERT_TRUE(first.has_value());
  SpotSearchRequest again = request(20);
  again.known = first->map;
  const auto second = findSpots(model, again);
  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->map, first->map);
  ASSERT_EQ(second->spots.size(), first->spots.size());
  for (std::size_t i = 0; i < first->spots.size(); ++i) EXPECT_EQ(second->spots[i].centreMm, first->spots[i].centreMm);
  again.placement.sizeMm = 25;
  const auto larger = findSpots(model, again);
  ASSERT_TRUE(larger.has_value());
  EXPECT_NE(larger->map, first->map);
}

TEST_F(SpotSearchTest, TheLargestSizeIsSoughtIfTheRequestedSizeFitsNowhere) {
  const auto job = *SpotSearchJob::create(upload(shapes::icosphere(40, 4)), request(75));
  std::vector<std::string> stages;
  double before = 0;
  const Status ended = advanceToEnd(*job, [&](const Progress& progress) {
    if (stages.empty() || stages.back() != progress.stage.code) stages.push_back(progress.stage.code);
    EXPECT_GE(progress.fraction, before);
    EXPECT_LT(progress.fraction, 1);
    before = progress.fraction;
  });
  EXPECT_THAT(stages, testing::ElementsAre("looking-from-all-sides", "testing-spots", "finding-largest-size"));
  ASSERT_FALSE(ended.has_value());
  EXPECT_EQ(ended.error().kind, ErrorKind::NoSolution);
}

TEST_F(SpotSearchTest, RefusesInvalidRequests) {
  const auto model = upload(shapes::icosphere(40, 2));
  SpotSearchRequest none = request(20);
  none.count = 0;
  SpotSearchRequest negative = request(-5);
  negative.placement.sizeMode = SizeMode::Fixed;
  SpotSearchRequest near = request(20);
  near.placement.eyeDistanceMm = 1;
  SpotSearchRequest wall = request(20);
  wall.minWallMm = -1;
  for (const SpotSearchRequest& wrong : {none, negative, near, wall}) {
    const auto job = SpotSearchJob::create(model, wrong);
    ASSERT_FALSE(job.has_value());
    EXPECT_EQ(job.error().kind, ErrorKind::BadUsage);
  }
}

TEST_F(SpotSearchTest, CentreDecimalsReachAMicrometre) {
  EXPECT_EQ(centreDecimals(1), 3);
  EXPECT_EQ(centreDecimals(900), 6);
  EXPECT_EQ(centreDecimals(1000), 6);
  EXPECT_EQ(centreDecimals(0.026), 2);
  EXPECT_EQ(centreDecimals(1e-9), 0);
}

TEST_F(SpotSearchTest, RefusesAModelTooSmallForAnyCodeAtOnce) {
  const auto refused = SpotSearchJob::create(upload(shapes::box({0.2, 0.2, 0.2})), request(20));
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::NoSolution);
  EXPECT_EQ(refused.error().message.code, "model-too-small");
  EXPECT_NE(hint(refused.error().message).find("--units m"), std::string::npos);
}

}  // namespace
}  // namespace qrelief
