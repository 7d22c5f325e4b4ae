// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/removed_settings.h"

#include <gmock/gmock.h>

#include "messages/sentences.h"
#include "settings/engrave_request.h"
#include "settings/setting_json.h"

namespace qrelief {
namespace {

using testing::HasSubstr;

TEST(RemovedSettings, AreNoSettingsAndNoChoicesAnyMore) {
  for (const RemovedSetting& removed : removedSettings()) {
    const Setting* setting = findSetting(removed.key);
    if (removed.choice.empty()) {
      EXPECT_EQ(setting, nullptr) << removed.key;
      EXPECT_EQ(findRemovedSetting(removed.key), &removed);
    } else {
      ASSERT_NE(setting, nullptr) << removed.key;
      EXPECT_FALSE(checkValue(*setting, removed.choice)) << removed.choice;
      EXPECT_EQ(findRemovedSetting(removed.key), nullptr);
      EXPECT_EQ(findRemovedChoice(removed.key, removed.choice), &removed);
    }
  }
  EXPECT_EQ(findRemovedSetting("minWallMm"), nullptr);
  EXPECT_EQ(findRemovedSetting("colour"), nullptr);
  EXPECT_EQ(findRemovedChoice("objective", "contrast"), nullptr);
}

TEST(RemovedSettings, AWarningNamesTheSettingTheVersionAndWhatToUse) {
  const Message floor = removedWarning(*findRemovedSetting("floor"), "--floor");
  EXPECT_EQ(sentence(floor), "The setting --floor is ignored: version 0.2.0 has removed it");
  EXPECT_EQ(hint(floor), "All floors are flat, because such codes decode best");
  EXPECT_THAT(hint(removedWarning(*findRemovedSetting("raiseEcc"), "raiseEcc")), HasSubstr("Choose --ecc auto"));
}

TEST(RemovedSettings, InJsonChangeNothing) {
  const auto request = requestFromJson(R"({"text": "x", "ecc": "auto", "raiseEcc": false, "breakUp": true,
      "floor": "wavy", "objective": "reading", "dataContrast": 0.2, "finderContrast": 0.3, "blurModules": 0.5,
      "tolerance": 0.01, "maxPasses": 20})");
  ASSERT_TRUE(request.has_value()) << request.error().message;
  EngraveRequest expected = defaultRequest();
  expected.code.text = "x";
  EXPECT_EQ(*request, expected);
}

}  // namespace
}  // namespace qrelief
