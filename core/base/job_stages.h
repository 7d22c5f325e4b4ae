// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "base/message.h"
#include "base/progress.h"
#include "base/result.h"

namespace qrelief {

/// Outcome of one step of a stage.
struct StageStep {
  double doneFraction = 0;  ///< of the stage, 0 … 1; may fall
  bool isLast = false;
};
inline constexpr StageStep kStageDone{1, true};

/// Returns the error of a step after the last one.
tl::unexpected<Error> advancedAfterDone();

/// The stages of a job in their order, and its progress through them: the weights of the finished stages and the done
/// fraction of the current one, never less than before, 1 only at the end.
/// @tparam State  the job's state; a stage is one of its members
template <class State>
class JobStages {
 public:
  struct Stage {
    Message name;
    double weight = 1;  ///< the stage's time in relation to the others', > 0
    Result<StageStep> (State::*step)() = nullptr;
    bool isNeeded = true;  ///< false: the job goes without this stage
  };

  /// @param stages  at least one of them needed
  JobStages(std::initializer_list<Stage> stages) {
    for (const Stage& stage : stages) add(stage);
  }

  /// Appends a stage. A step of an earlier stage may call it.
  void add(const Stage& stage) {
    if (stage.isNeeded) stages_.push_back(stage);
  }

  bool done() const { return current_ == stages_.size(); }

  /// Returns the stage of the next step, or of a finished job the last stage.
  Progress progress() const { return {stages_[std::min(current_, stages_.size() - 1)].name, fraction_, done()}; }

  /// Does the next step. Do not call it again after an error or `done`.
  Result<Progress> advance(State& state) {
    if (done()) return advancedAfterDone();
    const Result<StageStep> step = (state.*stages_[current_].step)();
    QRELIEF_TRY(step);
    if (step->isLast) ++current_;
    fraction_ = done() ? 1 : std::max(fraction_, fractionAfter(*step));
    return progress();
  }

 private:
  static constexpr double kMaxOfRunning = 0.99;  // an unfinished stage cannot complete the job

  double fractionAfter(const StageStep& step) const {
    double before = 0, all = 0;
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      if (i < current_) before += stages_[i].weight;
      all += stages_[i].weight;
    }
    const double running = step.isLast ? 0 : std::clamp(step.doneFraction, 0.0, kMaxOfRunning);
    return (before + running * stages_[current_].weight) / all;
  }

  std::vector<Stage> stages_;
  std::size_t current_ = 0;
  double fraction_ = 0;
};

}  // namespace qrelief
