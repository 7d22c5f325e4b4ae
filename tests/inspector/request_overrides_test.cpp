// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/request_overrides.h"

#include <gmock/gmock.h>
#include <limits>
#include <set>
#include <string_view>

namespace qrelief {
namespace {

std::size_t indexOf(std::string_view name) {
  for (std::size_t i = 0; i < tunables().size(); ++i)
    if (tunables()[i].name == name) return i;
  ADD_FAILURE() << "there is no " << name;
  return 0;
}

TEST(Tunables, EachHasANameOfItsOwnAndGroupsStandTogether) {
  std::set<std::string> names, groups;
  std::string group;
  for (const Tunable& tunable : tunables()) {
    EXPECT_TRUE(names.insert(tunable.name).second) << tunable.name;
    if (tunable.group != group) {
      EXPECT_TRUE(groups.insert(tunable.group).second) << tunable.group;
    }
    group = tunable.group;
  }
}

TEST(Tunables, EachReadsBackWhatItWroteAndChangesNothingElse) {
  for (const Tunable& written : tunables()) {
    EngraveRequest request;
    const double value = written.read(request) == written.least ? written.most : written.least;
    written.write(request, value);
    EXPECT_NEAR(written.read(request), value, 1e-5 * std::abs(value)) << written.name;
    for (const Tunable& other : tunables()) {
      if (&other == &written) continue;
      EXPECT_EQ(other.read(request), other.read({})) << written.name << " changed " << other.name;
    }
  }
}

TEST(Tunables, TheDefaultsAreWithinTheirRanges) {
  for (const Tunable& tunable : tunables()) {
    const double value = tunable.read({});
    EXPECT_GE(value, tunable.least) << tunable.name;
    EXPECT_LE(value, tunable.most) << tunable.name;
    if (tunable.choices.empty()) continue;
    EXPECT_EQ(static_cast<double>(tunable.choices.size() - 1), tunable.most) << tunable.name;
  }
}

TEST(RequestOverrides, WhatIsNotOverriddenFollowsThePage) {
  RequestOverrides overrides;
  EngraveRequest page;
  overrides.set(indexOf("contrast"), 0.42, page);
  page.contrast = 0.2;
  page.minWallMm = 1.5;
  page.text = "x";
  const EngraveRequest applied = overrides.appliedTo(page);
  EXPECT_EQ(applied.contrast, 0.42);
  EXPECT_EQ(applied.minWallMm, 1.5);
  EXPECT_EQ(applied.text, "x");
  EXPECT_EQ(overrides.count(), 1u);
  EXPECT_EQ(overrides.describe(), "contrast 0.42");
}

TEST(RequestOverrides, ThePagesOwnValueEndsAnOverride) {
  RequestOverrides overrides;
  const EngraveRequest page;
  const std::size_t albedo = indexOf("albedo");
  overrides.set(albedo, 0.5, page);
  EXPECT_TRUE(overrides.isSet(albedo));
  overrides.set(albedo, 0.7, page);  // a float in the request
  EXPECT_FALSE(overrides.isSet(albedo));
  EXPECT_EQ(overrides.describe(), "");
}

TEST(RequestOverrides, AreBroughtIntoTheirRanges) {
  RequestOverrides overrides;
  const EngraveRequest page;
  const std::size_t contrast = indexOf("contrast");
  overrides.set(contrast, 7, page);
  EXPECT_EQ(overrides.valueOf(contrast, page), 0.95);
  overrides.set(contrast, std::numeric_limits<double>::quiet_NaN(), page);
  EXPECT_EQ(overrides.valueOf(contrast, page), 0.95);
}

TEST(RequestOverrides, ALampWithoutStrengthIsNone) {
  RequestOverrides overrides;
  const EngraveRequest page;
  overrides.set(indexOf("lamp 1 azimuth"), 90, page);
  EXPECT_TRUE(overrides.appliedTo(page).lights.empty());
  overrides.set(indexOf("lamp 2 strength"), 2, page);
  overrides.set(indexOf("lamp 2 elevation"), 30, page);
  const EngraveRequest second = overrides.appliedTo(page);
  ASSERT_EQ(second.lights.size(), 1u);
  EXPECT_EQ(second.lights[0].strength, 2);
  EXPECT_EQ(second.lights[0].elevationDeg, 30);
  overrides.set(indexOf("lamp 1 strength"), 1, page);
  EXPECT_EQ(overrides.appliedTo(page).lights[0].azimuthDeg, 90);
  EXPECT_EQ(overrides.appliedTo(page).lights.size(), 2u);
}

TEST(RequestOverrides, AMethodReplacesTheDirectionOfASuggestedSpot) {
  RequestOverrides overrides;
  EngraveRequest page;
  page.placement.direction = Vec3(0, 0, 1);
  EXPECT_TRUE(overrides.appliedTo(page).placement.direction.has_value());
  overrides.set(indexOf("direction"), 2, page);
  EXPECT_FALSE(overrides.appliedTo(page).placement.direction.has_value());
  EXPECT_EQ(overrides.appliedTo(page).placement.directionMethod, DirectionMethod::Pca);
}

TEST(RequestOverrides, AreSaidInWordsAndCanAllBeTakenBack) {
  RequestOverrides overrides;
  const EngraveRequest page;
  overrides.set(indexOf("solver"), 1, page);
  overrides.set(indexOf("room for the quiet zone"), 0, page);
  overrides.set(indexOf("eye distance"), 300, page);
  overrides.set(indexOf("rotation"), 45, page);
  EXPECT_EQ(overrides.describe(),
            "room for the quiet zone off, rotation 45°, eye distance 300 mm, solver paper's steps");
  overrides.reset(indexOf("solver"));
  EXPECT_EQ(overrides.count(), 3u);
  overrides.resetAll();
  EXPECT_EQ(overrides.count(), 0u);
  EXPECT_EQ(overrides.appliedTo(page).placement.eyeDistanceMm, 250);
}

}  // namespace
}  // namespace qrelief
