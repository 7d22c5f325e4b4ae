// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/experiments/experiments.h"

#include <fmt/format.h>

namespace qrelief::study {

std::vector<Experiment> allExperiments() {
  return {leastModule(),   guaranteedSize(),  randomSizes(), patternDepths(), methodComparison(),
          paperModule(),   contrastSweep(),   frontier(),    equalDepth(),    symbolFlips(),
          lampDepths(),    lampStrengths(),   lightAngles(), robustness(),    defaultSpace(),
          defaultChoice(), defaultSettings(), hbaoLight(),   literalParts()};
}

std::function<std::string(const Row&)> dependingOn(std::initializer_list<Part> parts) {
  return [version = versionOf(parts)](const Row&) { return version; };
}

std::string shown(double value, int decimals) { return fmt::format("{:.{}f}", value, decimals); }

Row readingColumns() { return {"depth_mm", "removed_mm", "designed", "printed"}; }

Row readingRow(const Judged& judged) {
  return {shown(judged.depth.meanMm, 3), shown(judged.removedMm, 3), std::to_string(judged.designed.reads),
          std::to_string(judged.printed.reads)};
}

}  // namespace qrelief::study
