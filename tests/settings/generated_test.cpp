// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that the committed generated files equal what the table of settings would generate now.
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "generate/options_page.h"
#include "generate/settings_module.h"
#include "messages/option_texts.h"
#include "support/paths.h"

namespace qrelief {
namespace {

std::string committed(const std::string& path) {
  std::ifstream stream(sourceFolder() / path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

constexpr const char* kHint =
    "build it anew: cmake --build --preset release --target qrelief_generate && "
    "build/release/bin/qrelief_generate";

TEST(Generated, ThePageOfOptionsIsCurrent) { EXPECT_EQ(committed("docs/options.md"), optionsPage()) << kHint; }

TEST(Generated, TheSettingsModuleOfThePageIsCurrent) {
  EXPECT_EQ(committed("web/generated/settings.js"), settingsModule()) << kHint;
}

TEST(OptionTexts, ContainFlagValuesRangeAndDefault) {
  const OptionTexts wall = optionTexts(*findSetting("minWallMm"));
  EXPECT_EQ(wall.flag, "--min-wall");
  EXPECT_EQ(wall.values, "MM");
  EXPECT_EQ(wall.range, "0 to 1000");
  EXPECT_EQ(wall.initial, "0.8");
  const OptionTexts size = optionTexts(*findSetting("size"));
  EXPECT_EQ(size.values, "MM|best|oriented|free");
  EXPECT_EQ(size.initial, "best");
  const OptionTexts margin = optionTexts(*findSetting("quietZone"));
  EXPECT_EQ(margin.flag, "--no-quiet-zone");
  EXPECT_EQ(margin.values, "");
  EXPECT_EQ(margin.initial, "off");
  EXPECT_EQ(optionTexts(*findSetting("keepPreset")).flag, "--keep-preset");
  const OptionTexts preset = optionTexts(*findSetting("preset"));
  EXPECT_NE(preset.help.find("sets --contrast to 0.2, 0.3 or 0.38"), std::string::npos) << preset.help;
  EXPECT_EQ(preset.initial, "balanced");
}

}  // namespace
}  // namespace qrelief
