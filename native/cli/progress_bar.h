// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/progress.h"
#include "base/result.h"

namespace qrelief {

/// Shows progress on stderr: on a terminal one line that is redrawn, otherwise one plain line per stage.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  void show(const Progress& progress);

 private:
  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  Message stage_;
};

/// Runs a job (CarveJob, SpotSearchJob) to its end.
template <class Job>
Status runWithProgress(Job& job, bool quiet) {
  ProgressBar bar(quiet);
  return advanceToEnd(job, [&](const Progress& progress) { bar.show(progress); });
}

}  // namespace qrelief
