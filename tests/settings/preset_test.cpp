// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/preset.h"

#include <gtest/gtest.h>

#include "pipeline/engrave.h"

namespace qrelief {
namespace {

TEST(Preset, ConvertsNamesToPresetsAndBack) {
  for (const Preset preset : {Preset::Shallow, Preset::Balanced, Preset::Robust})
    EXPECT_EQ(presetByName(presetName(preset)), preset);
  EXPECT_EQ(presetByName("Balanced"), std::nullopt);
  EXPECT_EQ(presetByName(""), std::nullopt);
}

TEST(Preset, EachHasMoreContrastThanThePreviousOne) {
  double before = 0;
  for (const Preset preset : {Preset::Shallow, Preset::Balanced, Preset::Robust}) {
    EXPECT_GT(presetContrast(preset), before);
    EngraveRequest request;
    request.depth.preset = preset;
    EXPECT_EQ(request.depth.contrastAsked(), presetContrast(preset));
    before = presetContrast(preset);
  }
}

TEST(Preset, AnExplicitContrastOverridesIt) {
  EngraveRequest request;
  request.depth.preset = Preset::Robust;
  request.depth.contrast = 0.17;
  EXPECT_EQ(request.depth.contrastAsked(), 0.17);
}

TEST(Preset, EachHasADeeperOneExceptTheLast) {
  EXPECT_EQ(deeperPreset(Preset::Shallow), Preset::Balanced);
  EXPECT_EQ(deeperPreset(Preset::Balanced), Preset::Robust);
  EXPECT_EQ(deeperPreset(Preset::Robust), std::nullopt);
}

TEST(Preset, BalancedIsTheDefault) {
  EXPECT_EQ(EngraveRequest{}.depth.contrastAsked(), presetContrast(Preset::Balanced));
}

}  // namespace
}  // namespace qrelief
