// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/carved_code.h"
#include "study/spot.h"
#include "study/versions.h"

namespace qrelief::study {

/// One way to carve a code, as the tables name it.
struct Method {
  std::string name;
  /// What the method calls contrast, or depth in mm (even-depth), from shallow to deep; the published one, or our
  /// default, is `usual`.
  std::vector<double> levels;
  double usual = 0;
  DirectionMethod direction = DirectionMethod::DepthBalanced;
  std::function<Result<CarvedCode>(const Spot&, double level)> carve;
  Part search = kSearch;  ///< that finds the depths
};

/// Those that are compared, the oldest first, ours last.
const std::vector<Method>& methods();

/// Version of a row that has its method in its second column, for Experiment::version.
std::string versionOfMethod(const std::vector<std::string>& key);

/// @returns null if there is none of that name
const Method* findMethod(const std::string& name);

/// The spot's symbol at another level of error correction, in the same version and mask rule.
Result<Symbol> symbolAtLevel(const Spot& spot, ErrorCorrection level);

}  // namespace qrelief::study
