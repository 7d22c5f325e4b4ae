// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/settings.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <set>

#include "messages/sentences.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const std::string kOwnMask = "00100/01110/11111/01110/00101";

/// Returns the error code of the default request with this value; empty if it is valid.
std::string codeOf(const Setting& setting, const SettingValue& value) {
  EngraveRequest request = defaultRequest();
  request.print.process.reset();  // the printer's own limits are not under test
  setting.write(request, value);
  const Status checked = checkSettings(request);
  return checked ? "" : checked.error().message.code;
}

TEST(SettingsTable, KeysAreUniqueAndGroupsContiguous) {
  std::set<std::string> keys, groups;
  std::string group;
  for (const Setting& setting : settings()) {
    EXPECT_TRUE(keys.insert(setting.key).second) << setting.key;
    EXPECT_EQ(findSetting(setting.key), &setting);
    if (setting.group != group) {
      EXPECT_TRUE(groups.insert(setting.group).second) << setting.group;
    }
    group = setting.group;
  }
  EXPECT_EQ(findSetting("colour"), nullptr);
}

TEST(SettingsTable, AKeyEndsWithItsUnit) {
  for (const Setting& setting : settings()) {
    if (setting.kind != Setting::Kind::Number) continue;  // a choice's key names no unit
    for (const UnitTraits& unit : units()) {
      if (unit.keySuffix.empty()) continue;
      EXPECT_EQ(setting.key.ends_with(unit.keySuffix), setting.unit == unit.unit) << setting.key;
    }
  }
}

TEST(SettingsTable, TheDefaultsAreAllowed) {
  EXPECT_TRUE(checkSettings(defaultRequest()));
  EXPECT_TRUE(checkSettings(EngraveRequest()));
}

TEST(SettingsTable, EachReadsBackWhatItWrote) {
  for (const Setting& setting : settings()) {
    std::vector<SettingValue> values;
    if (setting.kind == Setting::Kind::Text) values.emplace_back(std::string("grüezi"));
    if (setting.kind == Setting::Kind::Mask) values.emplace_back(kOwnMask);
    if (setting.kind == Setting::Kind::Switch) values.emplace_back(true), values.emplace_back(false);
    if (setting.takesNumber()) values.emplace_back(setting.min), values.emplace_back(setting.max);
    if (setting.takesVector()) values.emplace_back(Vec3(1, -2, 3));
    if (setting.kind == Setting::Kind::Lamps)
      values.emplace_back(std::vector<DirectionalLight>{{.azimuthDeg = 90, .elevationDeg = 30, .strength = 2}});
    for (const std::string& choice : setting.choices) values.emplace_back(choice);
    if (setting.mayBeEmpty) values.emplace_back();
    ASSERT_FALSE(values.empty()) << setting.key;
    for (const SettingValue& value : values) {
      EngraveRequest request = defaultRequest();
      setting.write(request, value);
      EXPECT_EQ(setting.read(request), value) << setting.key;
      EXPECT_TRUE(checkValue(setting, value)) << setting.key;
    }
  }
}

TEST(SettingsTable, EveryNumberIsCheckedAtBothEnds) {
  int checked = 0;
  for (const Setting& setting : settings()) {
    if (!setting.takesNumber()) continue;
    const double beyond = setting.isWhole ? 1 : 1e-3 * setting.max;
    EXPECT_EQ(codeOf(setting, setting.min), "") << setting.key;
    EXPECT_EQ(codeOf(setting, setting.max), "") << setting.key;
    EXPECT_EQ(codeOf(setting, setting.min - beyond), "setting-out-of-range") << setting.key;
    EXPECT_EQ(codeOf(setting, setting.max + beyond), "setting-out-of-range") << setting.key;
    if (!setting.isWhole) {
      EXPECT_EQ(codeOf(setting, kNan), "setting-out-of-range") << setting.key;
    }
    ++checked;
  }
  EXPECT_GT(checked, 12);
}

TEST(SettingsTable, EveryNumberOfALampIsCheckedAtBothEnds) {
  const Setting& light = *findSetting("light");
  for (const LampPart& part : lampParts()) {
    for (const double value : {part.min, part.max, part.min - 0.01, part.max + 0.01, kNan}) {
      DirectionalLight lamp;
      lamp.*part.value = value;
      const bool isWithin = value >= part.min && value <= part.max;
      EXPECT_EQ(codeOf(light, std::vector{lamp}), isWithin ? "" : "setting-out-of-range") << part.key << ' ' << value;
    }
  }
  EXPECT_EQ(codeOf(light, std::vector<DirectionalLight>(kMaxLights)), "");
  EXPECT_EQ(codeOf(light, std::vector<DirectionalLight>(kMaxLights + 1)), "setting-too-many");
}

TEST(SettingsTable, RefusesAZeroVector) {
  for (const char* key : {"direction", "up"}) {
    EXPECT_EQ(codeOf(*findSetting(key), Vec3(0)), "setting-no-length");
    EXPECT_EQ(codeOf(*findSetting(key), Vec3(0, kNan, 1)), "setting-no-length");
  }
}

TEST(SettingsTable, RefusesAFractionForAnInteger) {
  EXPECT_EQ(checkValue(*findSetting("version"), 2.5).error().message.code, "setting-not-whole");
  EXPECT_EQ(checkValue(*findSetting("mask"), 2.5).error().message.code, "setting-not-whole");
}

TEST(SettingsTable, RefusesValuesOfAnotherKind) {
  EXPECT_EQ(checkValue(*findSetting("contrast"), std::string("high")).error().message.code, "setting-no-number");
  EXPECT_EQ(checkValue(*findSetting("layerMm"), {}).error().message.code, "setting-no-number");
  EXPECT_EQ(checkValue(*findSetting("pattern"), std::string("dots")).error().message.code, "setting-no-choice");
  EXPECT_EQ(checkValue(*findSetting("patternMask"), std::string("dots")).error().message.code, "setting-no-mask");
  EXPECT_EQ(checkValue(*findSetting("size"), std::string("fixed")).error().message.code, "setting-no-choice-or-number");
  EXPECT_EQ(checkValue(*findSetting("quietZone"), 1.0).error().message.code, "setting-no-switch");
}

TEST(SettingsTable, NamesASettingOutOfRangeAndTheRange) {
  EngraveRequest request = defaultRequest();
  request.depth.minWallMm = -1;
  const Status checked = checkSettings(request);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().kind, ErrorKind::BadUsage);
  EXPECT_EQ(sentence(checked.error().message), "--min-wall is -1 mm");
  EXPECT_THAT(hint(checked.error().message), HasSubstr("from 0 mm to 1000 mm"));
}

TEST(SettingsTable, RaisesAnExplicitErrorCorrectionOnlyOnRequest) {
  EngraveRequest request = defaultRequest();
  EXPECT_TRUE(request.code.symbol.raiseErrorCorrection);
  findSetting("ecc")->write(request, std::string("Q"));
  EXPECT_EQ(request.code.symbol.errorCorrection, ErrorCorrection::Q);
  EXPECT_FALSE(request.code.symbol.raiseErrorCorrection);
  findSetting("ecc")->write(request, std::string("auto"));
  EXPECT_EQ(request.code.symbol, defaultRequest().code.symbol);
}

TEST(SettingsTable, OneLightHasADefaultLampUnlessOneIsGiven) {
  EngraveRequest request = defaultRequest();
  EXPECT_TRUE(request.lamps().empty());
  request.depth.objective = DepthObjective::OneLight;
  EXPECT_EQ(request.lamps(), std::vector{kOneLight});
  EXPECT_FALSE(request.isForPrint());
  const DirectionalLight own{.azimuthDeg = 10, .elevationDeg = 20, .strength = 5};
  request.depth.lights = {own};
  EXPECT_EQ(request.lamps(), std::vector{own});
  EXPECT_TRUE(checkSettings(request));
  request.depth.lights.push_back(kOneLight);
  const Status checked = checkSettings(request);
  ASSERT_FALSE(checked);
  EXPECT_EQ(sentence(checked.error().message), "--objective is one-light, but 2 lamps are given");
  EXPECT_THAT(hint(checked.error().message), HasSubstr("--light once"));
}

TEST(SettingsTable, UsesThePresetsContrastByDefault) {
  EngraveRequest request = defaultRequest();
  const Setting& contrast = *findSetting("contrast");
  EXPECT_EQ(contrast.read(request), SettingValue());
  EXPECT_EQ(contrast.otherwise(request), 0.3);
  findSetting("preset")->write(request, std::string("robust"));
  EXPECT_EQ(contrast.read(request), SettingValue());
  EXPECT_EQ(contrast.otherwise(request), 0.38);
}

TEST(SettingsTable, TheAlbedoFollowsTheMarkUnlessItIsGiven) {
  EngraveRequest request = defaultRequest();
  const Setting& albedo = *findSetting("albedo");
  for (const auto& [mark, otherwise] : {std::pair(Mark::Shadow, 0.7), {Mark::Inlay, 0.85}, {Mark::Paint, 0.85}}) {
    request.marking.mark = mark;
    EXPECT_EQ(albedo.read(request), SettingValue());
    EXPECT_EQ(albedo.otherwise(request), otherwise) << markName(mark);
    EXPECT_EQ(request.marking.ink(), (Ink{0.05, otherwise}));
  }
  albedo.write(request, 0.6);
  for (const Mark mark : {Mark::Shadow, Mark::Inlay, Mark::Paint}) {
    request.marking.mark = mark;
    EXPECT_EQ(request.marking.surfaceAlbedo(), 0.6) << markName(mark);
  }
}

TEST(SettingsTable, AProcessSetsNozzleAndLayerUnlessTheyAreGiven) {
  EngraveRequest request = defaultRequest();
  findSetting("process")->write(request, std::string("fdm-0.25/0.1"));
  EXPECT_EQ(request.print.printer.nozzleMm, 0.25);
  EXPECT_EQ(request.print.printer.layerMm, 0.1);
  findSetting("layerMm")->write(request, 0.15);
  EXPECT_EQ(findSetting("process")->read(request), SettingValue(std::string("fdm-0.25/0.1")));
  EXPECT_EQ(request.print.printer.layerMm, 0.15);
  findSetting("process")->write(request, std::string("none"));
  EXPECT_FALSE(request.print.process);
  EXPECT_EQ(request.print.printer.nozzleMm, 0.25);
}

TEST(SettingsTable, APatternReplacesAPatternOfOnesOwnUnlessThatIsGiven) {
  EngraveRequest request = defaultRequest();
  findSetting("pattern")->write(request, std::string("square"));
  findSetting("patternMask")->write(request, kOwnMask);
  EXPECT_EQ(request.code.modules(), moduleMaskFromText(kOwnMask));
  EXPECT_EQ(findSetting("pattern")->read(request), SettingValue(std::string("square")));
  apply({"pattern", "diamond"}, request);
  EXPECT_EQ(request.code.modules(), ModuleMask(ModulePattern::Diamond));
  EXPECT_EQ(findSetting("patternMask")->read(request), SettingValue());
}

TEST(SettingsTable, RefusesAnImpossiblePrinter) {
  EngraveRequest request = defaultRequest();
  EXPECT_TRUE(checkSettings(request));
  request.print.printer.layerMm = 0.5;
  ASSERT_FALSE(checkSettings(request));
  EXPECT_EQ(checkSettings(request).error().message.code, "layer-above-nozzle");
  request.print.process.reset();
  EXPECT_TRUE(checkSettings(request));
}

}  // namespace
}  // namespace qrelief
