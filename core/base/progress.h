// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"

namespace qrelief {

/// How far a job has come.
struct Progress {
  Message stage;        ///< what is done now, "finding-depth"
  double fraction = 0;  ///< of the whole job, 0 … 1, never falls
  bool done = false;
};

/// All the work of a job at once. @param job  has advance() and takeResult()
template <class Job>
auto runToEnd(Job& job) -> Result<decltype(job.takeResult())> {
  for (;;) {
    const Result<Progress> progress = job.advance();
    if (!progress) return tl::unexpected(progress.error());
    if (progress->done) return job.takeResult();
  }
}

}  // namespace qrelief
