// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/request_overrides.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <set>
#include <string_view>

#include "settings/engrave_request.h"

namespace qrelief {
namespace {

std::size_t indexOf(std::string_view name) {
  for (std::size_t i = 0; i < tunables().size(); ++i)
    if (tunables()[i].key == name) return i;
  ADD_FAILURE() << "there is no " << name;
  return 0;
}

TEST(Tunables, HaveUniqueNamesAndContiguousGroups) {
  std::set<std::string> names, groups;
  std::string group;
  for (const Tunable& tunable : tunables()) {
    EXPECT_TRUE(names.insert(tunable.key).second) << tunable.key;
    if (tunable.setting->group != group) {
      EXPECT_TRUE(groups.insert(tunable.setting->group).second) << tunable.setting->group;
    }
    group = tunable.setting->group;
  }
}

/// Returns a request in which every setting with choices or a number uses its number.
EngraveRequest withNumbers() {
  EngraveRequest request = defaultRequest();
  findSetting("size")->write(request, 35.0);
  findSetting("mask")->write(request, 3.0);
  findSetting("contrast")->write(request, 0.25);  // otherwise it follows the preset
  return request;
}

TEST(Tunables, EachReadsBackWhatItWroteAndChangesOnlyItsSetting) {
  const EngraveRequest before = withNumbers();
  for (const Tunable& written : tunables()) {
    EngraveRequest request = before;
    const double value = written.read(request) == written.min ? written.max : written.min;
    const Setting* setting = findSetting(written.key);
    if (setting && setting->takesVector() && value == written.max) continue;  // a vector is not one of the choices
    written.write(request, value);
    EXPECT_NEAR(written.read(request), value, 1e-5 * std::abs(value)) << written.key;
    for (const Tunable& other : tunables()) {
      if (written.setting == other.setting) continue;
      EXPECT_EQ(other.read(request), other.read(before)) << written.key << " changed " << other.key;
    }
  }
}

TEST(Tunables, ANumberAppliesOnlyIfItIsTheChoice) {
  const Tunable& choice = tunables()[indexOf("size")];
  const Tunable& number = tunables()[indexOf("size.number")];
  EngraveRequest request = defaultRequest();
  number.write(request, 12);
  EXPECT_EQ(request.placement.sizeMode, SizeMode::Best);
  choice.write(request, choice.max);
  EXPECT_EQ(request.placement.sizeMode, SizeMode::Fixed);
  EXPECT_EQ(request.placement.sizeMm, 35);
  number.write(request, 12);
  EXPECT_EQ(request.placement.sizeMm, 12);
  choice.write(request, choice.max);
  EXPECT_EQ(request.placement.sizeMm, 12);
}

TEST(Tunables, TheDefaultsAreWithinTheirRanges) {
  for (const Tunable& tunable : tunables()) {
    const double value = tunable.read({});
    EXPECT_GE(value, tunable.min) << tunable.key;
    EXPECT_LE(value, tunable.max) << tunable.key;
    if (tunable.choices.empty()) continue;
    EXPECT_EQ(static_cast<double>(tunable.choices.size() - 1), tunable.max) << tunable.key;
  }
}

TEST(RequestOverrides, SettingsWithoutOverrideFollowThePage) {
  RequestOverrides overrides;
  EngraveRequest page;
  overrides.set(indexOf("contrast"), 0.42, page);
  page.depth.contrast = 0.2;
  page.depth.minWallMm = 1.5;
  page.code.text = "x";
  const EngraveRequest applied = overrides.appliedTo(page);
  EXPECT_EQ(applied.depth.contrast, 0.42);
  EXPECT_EQ(applied.depth.minWallMm, 1.5);
  EXPECT_EQ(applied.code.text, "x");
  EXPECT_EQ(overrides.count(), 1u);
}

TEST(RequestOverrides, ThePagesOwnValueEndsAnOverride) {
  RequestOverrides overrides;
  const EngraveRequest page;
  const std::size_t albedo = indexOf("albedo");
  overrides.set(albedo, 0.5, page);
  EXPECT_TRUE(overrides.isSet(albedo));
  overrides.set(albedo, 0.7, page);  // a float in the request
  EXPECT_FALSE(overrides.isSet(albedo));
}

TEST(RequestOverrides, AreClampedToTheirRanges) {
  RequestOverrides overrides;
  const EngraveRequest page;
  const std::size_t contrast = indexOf("contrast");
  overrides.set(contrast, 7, page);
  EXPECT_EQ(overrides.valueOf(contrast, page), 0.99);
  overrides.set(contrast, std::numeric_limits<double>::quiet_NaN(), page);
  EXPECT_EQ(overrides.valueOf(contrast, page), 0.99);
}

TEST(RequestOverrides, ALampWithoutStrengthIsOmitted) {
  RequestOverrides overrides;
  const EngraveRequest page;
  overrides.set(indexOf("light.1.azimuthDeg"), 90, page);
  EXPECT_TRUE(overrides.appliedTo(page).depth.lights.empty());
  overrides.set(indexOf("light.2.strength"), 2, page);
  overrides.set(indexOf("light.2.elevationDeg"), 30, page);
  const EngraveRequest second = overrides.appliedTo(page);
  ASSERT_EQ(second.depth.lights.size(), 1u);
  EXPECT_EQ(second.depth.lights[0].strength, 2);
  EXPECT_EQ(second.depth.lights[0].elevationDeg, 30);
  overrides.set(indexOf("light.1.strength"), 1, page);
  EXPECT_EQ(overrides.appliedTo(page).depth.lights[0].azimuthDeg, 90);
  EXPECT_EQ(overrides.appliedTo(page).depth.lights.size(), 2u);
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

TEST(RequestOverrides, CanAllBeReset) {
  RequestOverrides overrides;
  const EngraveRequest page;
  overrides.set(indexOf("solver"), 1, page);
  overrides.set(indexOf("quietZone"), 0, page);
  overrides.set(indexOf("eyeDistanceMm"), 300, page);
  overrides.set(indexOf("rotateDeg"), 45, page);
  EXPECT_EQ(overrides.count(), 4u);
  overrides.reset(indexOf("solver"));
  EXPECT_EQ(overrides.count(), 3u);
  EXPECT_EQ(overrides.appliedTo(page).placement.eyeDistanceMm, 300);
  overrides.resetAll();
  EXPECT_EQ(overrides.count(), 0u);
  EXPECT_EQ(overrides.appliedTo(page).placement.eyeDistanceMm, 250);
}

}  // namespace
}  // namespace qrelief
