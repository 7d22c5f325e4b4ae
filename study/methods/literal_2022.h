// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "depth/paper_step_search.h"
#include "study/carved_code.h"
#include "study/hbao_light.h"
#include "study/spot.h"
#include "study/versions.h"

namespace qrelief::study {

/// The depth search of Papp 2022, §7 by its words, where the program's own published search departs from them:
///   - AL: the four darkest of all eight neighbours, dark ones included (Surroundings::EightNeighbours);
///   - O(x): steps as they are, not rounded up, so that they grow where luminance stays the same (decision 0054).
/// The paper computes ambient occlusion by an approximation, HBAO, and gives no radius. The default is the program's
/// exact light without a radius; HBAO (hbao_light.h) with one of a few modules ends at the depth limit (decision 0053).
/// Each option can be set by itself. Walls and kPublishedMaxDepthModules limit the depths, as for the other methods.
struct LiteralOptions {
  Surroundings surroundings = Surroundings::EightNeighbours;
  double significantChange = 0.02;  ///< of luminance; the paper gives none
  ChangeSince changeSince = ChangeSince::LastIteration;
  bool roundSteps = false;
  std::optional<HbaoOptions> hbao = {};  ///< none: the program's exact light [HeightLight]
  int maxPasses = 300;
};

/// Carves the spot's symbol.
/// @param request  patterns (set), contrast, lamps, albedo and greatest depth; its solver and objective do not count
Result<CarvedCode> carveLiteral2022(const StudyPlacement& spot, const EngraveRequest& request,
                                    const LiteralOptions& options = {});

/// Names of the two readings of the paper's search in the tables' column `search`: as the program has it (by_engine.h),
/// and by its words.
inline constexpr const char* kPublishedSearch = "papp-2022";
inline constexpr const char* kLiteralSearch = "papp-2022-literal";

/// Carves by one of these. @param search  its name
Result<CarvedCode> carveBySearch(const std::string& search, const StudyPlacement& spot, const EngraveRequest& request);

/// Returns the version of a row that depends on one of these and on other parts.
std::string versionOfSearch(const std::string& search, std::initializer_list<Part> others);

/// Returns the heights of the uncarved surface over symbol, quiet zone and margin, one patch per submodule.
HeightMap cellHeights(const StudyPlacement& spot);

}  // namespace qrelief::study
