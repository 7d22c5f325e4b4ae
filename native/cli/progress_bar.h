// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/progress.h"
#include "base/result.h"

namespace qrelief {

/// Shows the progress of a command on stderr: on a terminal one line that is redrawn, otherwise one plain line per
/// stage. The command's jobs are parts of one whole, so that the percentage never goes back.
class ProgressBar {
 public:
  /// @param share  of the whole that the first part takes, 0 < share ≤ 1
  explicit ProgressBar(bool quiet, double share = 1);
  ~ProgressBar();

  /// Begins the next part. @param share  of what the parts before it have left, 0 < share ≤ 1
  void next(double share);
  /// Shows the progress of the current part.
  void show(const Progress& progress);
  /// Shows the end of the whole, also if parts were left out.
  void finish();
  /// Removes the line, so that the command can print.
  void hide();

 private:
  bool quiet_;
  bool terminal_;
  double from_ = 0, to_;  // bounds of the current part
  double shown_ = 0;      // fraction of the whole
  bool drawn_ = false;
  Message stage_;
};

/// Runs a job (CarveJob, SpotSearchJob) to its end.
template <class Job>
Status runWithProgress(Job& job, ProgressBar& bar) {
  const Status done = advanceToEnd(job, [&](const Progress& progress) { bar.show(progress); });
  bar.hide();
  return done;
}

}  // namespace qrelief
