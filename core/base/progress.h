// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"

namespace qrelief {

/// Progress of a job.
struct Progress {
  Message stage;        ///< stage of the next step, such as "finding-depth"
  double fraction = 0;  ///< of the whole job, 0 … 1, never decreases
  bool done = false;
};

/// Advances a job to its end.
/// @param job   has progress() and advance()
/// @param tell  is called with the progress before the first step and after each
template <class Job, class Tell>
Status advanceToEnd(Job& job, const Tell& tell) {
  tell(job.progress());
  for (;;) {
    const Result<Progress> progress = job.advance();
    QRELIEF_TRY(progress);
    tell(*progress);
    if (progress->done) return {};
  }
}

/// Runs a job to its end.
/// @param job  has progress(), advance() and takeResult()
template <class Job>
auto runToEnd(Job& job) -> Result<decltype(job.takeResult())> {
  QRELIEF_TRY(advanceToEnd(job, [](const Progress&) {}));
  return job.takeResult();
}

}  // namespace qrelief
