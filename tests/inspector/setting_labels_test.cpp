// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/setting_labels.h"

#include <gtest/gtest.h>
#include <stdexcept>

#include "inspector/translation.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

const Tunable& tunable(std::string_view key) {
  for (const Tunable& each : tunables())
    if (each.key == key) return each;
  throw std::runtime_error("there is no " + std::string(key));
}

std::size_t indexOf(std::string_view key) { return static_cast<std::size_t>(&tunable(key) - tunables().data()); }

TEST(SettingLabels, AreTheKeysWithoutATranslation) {
  EXPECT_EQ(labelOf(tunable("minWallMm")), "minWallMm, mm");
  EXPECT_EQ(labelOf(tunable("contrast")), "contrast");
  EXPECT_EQ(labelOf(tunable("light.1.azimuthDeg")), "light.1.azimuthDeg, °");
  EXPECT_EQ(labelOf(tunable("size")), "size");
  EXPECT_EQ(labelOf(tunable("size.number")), "size.number, mm");
  EXPECT_EQ(choiceLabelsOf(tunable("solver")), (std::vector<std::string>{"fast", "paper-steps"}));
}

TEST(SettingLabels, DescribesOverridesInTheWordsOfThePage) {
  setTranslation({{"setting:minWallMm", "Restwand"},
                  {"choice:solver:paper-steps", "Schritte der Arbeit"},
                  {"setting:solver", "Verfahren"},
                  {"off", "aus"},
                  {"group:depth", "Tiefe"}});
  RequestOverrides overrides;
  const EngraveRequest page = defaultRequest();
  EXPECT_EQ(describe(overrides), "");
  overrides.set(indexOf("solver"), 1, page);
  overrides.set(indexOf("minWallMm"), 1.5, page);
  overrides.set(indexOf("quietZone"), 0, page);
  overrides.set(indexOf("rotateDeg"), 45, page);
  EXPECT_EQ(describe(overrides), "Verfahren Schritte der Arbeit, Restwand 1.5 mm, quietZone aus, rotateDeg 45°");
  EXPECT_EQ(groupLabelOf(*tunable("solver").setting), "Tiefe");
  setTranslation({});
}

}  // namespace
}  // namespace qrelief
