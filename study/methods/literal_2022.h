// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "depth/paper_step_search.h"
#include "study/carved_code.h"
#include "study/hbao_light.h"
#include "study/spot.h"

namespace qrelief::study {

/// The depth search of Papp 2022, §7 by its words, where the program's own published search departs from them:
///   - AL: the four darkest of all eight neighbours, dark ones included (Surroundings::EightNeighbours);
///   - light: horizon-based ambient occlusion (hbao_light.h), without reflected light;
///   - O(x): steps as they are, not rounded up, so that they grow where luminance stays the same (decision 0054).
/// Each can be set apart from the others. Limits are those of the other methods: walls, and kPublishedMaxDepthModules.
struct LiteralOptions {
  Surroundings surroundings = Surroundings::EightNeighbours;
  double significantChange = 0.02;  ///< of luminance; the paper gives none
  ChangeSince changeSince = ChangeSince::LastIteration;
  bool roundSteps = false;
  std::optional<HbaoOptions> hbao = HbaoOptions();  ///< none: the program's exact light [HeightLight]
  int maxPasses = 300;
};

/// Carves the spot's symbol.
/// @param request  patterns (set), contrast, lamps, albedo and greatest depth; its solver and objective do not count
Result<CarvedCode> carveLiteral2022(const StudyPlacement& spot, const EngraveRequest& request,
                                    const LiteralOptions& options = {});

/// Returns the heights of the uncarved surface over symbol, quiet zone and margin, one patch per submodule.
HeightMap cellHeights(const StudyPlacement& spot);

}  // namespace qrelief::study
