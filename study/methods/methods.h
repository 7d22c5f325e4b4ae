// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/carved_code.h"
#include "study/spot.h"
#include "study/versions.h"

namespace qrelief::study {

/// A way to carve a code, as named in the tables.
struct Method {
  std::string name;
  /// Levels of the method's contrast, or of depth in mm (even-depth), from shallow to deep. `usual` is the level
  /// of the authors' program (Peng 2019 and 2020) or of our default; the other sources publish none.
  std::vector<double> levels;
  double usual = 0;
  DirectionMethod direction = DirectionMethod::DepthBalanced;
  std::function<Result<CarvedCode>(const StudyPlacement&, double level)> carve;
  Part search = kSearch;  ///< part of the program that finds the depths
};

/// Returns the methods to compare, the oldest first, ours last.
const std::vector<Method>& methods();

/// Returns the version of a row that has its method in its second column, for Experiment::version.
std::string versionOfMethod(const std::vector<std::string>& key);

/// @returns null if no method has the name
const Method* findMethod(const std::string& name);

/// Returns the spot's symbol at another level of error correction, with the same version and mask rule.
Result<Symbol> symbolAtLevel(const StudyPlacement& spot, ErrorCorrection level);

}  // namespace qrelief::study
