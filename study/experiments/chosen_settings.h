// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "study/experiment.h"

namespace qrelief::study {

/// Module widths that the default settings are chosen for, mm.
inline constexpr std::array kDefaultModuleWidthsMm = {0.6, 0.8, 1.0, 1.2, 1.4, 1.6};

/// Two halves of StudyContext::models(): one to choose the defaults by, one to test them on.
inline constexpr std::array kModelsToChooseBy = {"plate", "saddle", "star", "bunny"};
inline constexpr std::array kModelsToTestBy = {"pyramid", "cylinder", "vase", "bumpy-sphere"};

/// A pose between BuildPose::CodeUp and BuildPose::CodeUpright: the code's normal 45° above the level.
inline constexpr const char* kSlantedPose = "slanted";

/// A point of the space in which the default settings are searched: the settings that `auto` decides.
struct ChosenSettings {
  ModulePattern modules = ModulePattern::None;
  FinderPattern finders = FinderPattern::None;
  double contrast = 0.3;
  double maxDepthModules = 4;  ///< greatest depth, in modules
  bool breakUpDarkAreas = false;
  ErrorCorrection level = ErrorCorrection::M;  ///< for version 3

  /// Returns the values of the key columns of chosenSettingsExperiment().
  /// @param pose  the name of a BuildPose, or kSlantedPose
  Row key(const std::string& model, double moduleMm, const std::string& pose) const;
};

/// Returns a table of codes carved for their print with chosen settings, still without cases.
Experiment chosenSettingsExperiment(const std::string& name);

}  // namespace qrelief::study
