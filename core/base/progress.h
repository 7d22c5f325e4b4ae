// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"

namespace qrelief {

/// Progress of a job.
struct Progress {
  Message stage;        ///< present stage, such as "finding-depth"
  double fraction = 0;  ///< of the whole job, 0 … 1, never falls
  bool done = false;
};

/// Runs a job to its end.
/// @param job  has advance() and takeResult()
template <class Job>
auto runToEnd(Job& job) -> Result<decltype(job.takeResult())> {
  for (;;) {
    const Result<Progress> progress = job.advance();
    if (!progress) return tl::unexpected(progress.error());
    if (progress->done) return job.takeResult();
  }
}

}  // namespace qrelief
