// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the depth search of EngraveJob (engrave.h).
#include "base/clock.h"
#include "message_codes/pipeline.h"
#include "pipeline/engrave_state.h"

namespace qrelief {

void EngraveJob::State::startRecord(std::span<const double> limitMm) {
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    result.search.carved.push_back(static_cast<std::uint32_t>(i));
    result.search.limitMm.push_back(static_cast<float>(limitMm[i]));
  }
}

Result<StageStep> EngraveJob::State::searchOnce() {
  const auto start = Clock::now();
  search->step(request.depth.recordSearch ? &result.search : nullptr);
  result.timingsMs.depthSearch += millisecondsSince(start);
  if (!search->finished()) return StageStep{search->doneFraction()};
  result.depths = search->depths();
  result.searchIterations += search->iterations();
  result.limitedSubmodules = search->limitedCount();
  result.unfinishedSubmodules = search->unfinishedCount();
  result.luminance = search->luminance();
  result.received = search->received();
  if (summarise(result.depths).maxMm == 0)
    return fail(ErrorKind::NoSolution,
                message<"nothing-can-be-carved">(with::lengthMm<"wall">(request.depth.minWallMm)));
  return kStageDone;
}

}  // namespace qrelief
