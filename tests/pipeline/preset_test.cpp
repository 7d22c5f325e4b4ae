// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/preset.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(Preset, NamesLeadToThemAndBack) {
  for (const Preset preset : {Preset::Shallow, Preset::Balanced, Preset::Robust})
    EXPECT_EQ(presetByName(presetName(preset)), preset);
  EXPECT_EQ(presetByName("Balanced"), std::nullopt);
  EXPECT_EQ(presetByName(""), std::nullopt);
}

TEST(Preset, EachAsksForMoreContrastThanTheOneBefore) {
  double before = 0;
  for (const Preset preset : {Preset::Shallow, Preset::Balanced, Preset::Robust}) {
    EngraveRequest request;
    request.modulePattern = ModulePattern::None;
    applyPreset(request, preset);
    EXPECT_GT(request.contrast, before);
    EXPECT_EQ(request.modulePattern, ModulePattern::ThickPlus);
    before = request.contrast;
  }
}

TEST(Preset, EachButTheLastHasADeeperOne) {
  EXPECT_EQ(deeperPreset(Preset::Shallow), Preset::Balanced);
  EXPECT_EQ(deeperPreset(Preset::Balanced), Preset::Robust);
  EXPECT_EQ(deeperPreset(Preset::Robust), std::nullopt);
}

TEST(Preset, ARequestThatSaysNothingHasTheContrastAndThePatternsOfTheBalancedOne) {
  EngraveRequest balanced;
  applyPreset(balanced, Preset::Balanced);
  EXPECT_EQ(EngraveRequest{}.contrast, balanced.contrast);
  EXPECT_EQ(EngraveRequest{}.modulePattern, balanced.modulePattern);
  EXPECT_EQ(EngraveRequest{}.finderPattern, balanced.finderPattern);
}

}  // namespace
}  // namespace qrelief
