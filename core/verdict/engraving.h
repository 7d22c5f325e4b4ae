// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "pipeline/spot_search.h"
#include "verdict/engrave_plan.h"
#include "verdict/engraver.h"

namespace qrelief {

/// A carving with the results of its checks. To save it, use encodeCarved() (delivery/carved_file.h).
struct Engraved {
  EngraveRequest request;  ///< as carved, which may be deeper than requested
  EngraveResult result;
  ReadingEvidence reading = {};
  std::optional<PrintedEvidence> printed = {};  ///< none: the print was not simulated
  Verdict verdict = {};                         ///< with the remedies that are left
  std::vector<TriedCarving> tried = {};         ///< all attempts; the first is the carving as requested
  int attempt = 0;                              ///< the one that this carving is
  double spotMs = 0;                            ///< time to find spots
  double workMs = 0;                            ///< time to place, carve and check this carving

  /// Judges the carving after its evidence has changed.
  void judgeAnew();
};

/// Engraves one code as EngravePlan says, a bounded piece of work at a time; to cancel, stop calling advance(). The
/// host decodes pictures and simulates prints, which it may do in parallel:
///
///     Engraving engraving(engraver, request, options);
///     for (;;) {
///       auto step = engraving.advance();
///       if (!step) …error…
///       if (*step == Engraving::Step::Decode) engraving.decoded(…of engraving.pictures()…);
///       if (*step == Engraving::Step::Print) engraving.printed(…of engraving.current()…);
///       if (*step == Engraving::Step::Done) return engraving.best();
///     }
class Engraving {
 public:
  enum class Step : std::uint8_t {
    Work,    ///< call advance() again
    Decode,  ///< decode pictures() and call decoded(), then advance()
    Print,   ///< simulate and decode the print of current() and call printed(), then advance()
    Done     ///< best() is the result
  };

  /// @param engraver  kept by reference
  Engraving(Engraver& engraver, EngraveRequest request, EngravePlan::Options options);

  /// Does the next piece of work.
  /// @returns the error of the carving as requested if nothing could be carved, with the offer that would do as its
  ///          hint. Do not call it again after an error or Done.
  Result<Step> advance();
  /// Returns the progress of the engraving with all its attempts; its fraction never decreases. `done`: nothing is left
  /// to do before the host answers.
  Progress progress() const;

  /// Returns true while advance() has work to do: the host has nothing to answer, and the end is not reached.
  bool isWorking() const;
  /// Returns true while isWorking(), once the work has begun.
  bool isUnderWay() const { return isWorking() && (spots_ || worked_ == plan_.attempt()); }
  bool awaitsReading() const { return awaitsReading_; }
  bool awaitsPrint() const { return plan_.step() == EngravePlan::Step::Print; }
  const EngravePlan& plan() const { return plan_; }
  /// Returns the request of the last attempt.
  const EngraveRequest& request() const { return plan_.request(); }
  /// Returns the job of the last attempt that began, and that attempt's number; null before, and -1.
  const CarveJob* job() const { return work_ ? work_->job.get() : nullptr; }
  int attemptOfJob() const { return worked_; }
  /// Returns the carving under way once its file is written; else null. Its print may be simulated already.
  const EngraveResult* printable() const;

  /// Returns the last finished carving: at Decode and Print the one to decode or print. Null: none yet.
  const std::shared_ptr<Engraved>& current() const { return current_; }
  /// Returns the best carving so far, which may be delivered before the end. Null: none yet.
  const std::shared_ptr<Engraved>& best() const { return best_; }

  /// Returns the pictures of current() to decode, see frontalPictures().
  std::vector<GreyImage> pictures() const;
  /// Answers Decode. @param ms  time it took
  void decoded(const ReadingEvidence& reading, double ms = 0);
  /// Answers Print. @param ms  time it took
  void printed(const PrintedEvidence& print, double ms = 0);

 private:
  void searchSpot();
  void carve();
  void fail(const Error& error);
  void keep();
  Result<Step> next() const;
  Progress withinAttempt(Progress part, double from, double to) const;

  Engraver& engraver_;
  double attemptShare_;
  EngravePlan plan_;
  std::optional<Error> failure_;  // of the carving as requested
  std::unique_ptr<SpotSearchJob> spots_;
  double spotMs_ = 0;
  std::optional<Engraver::Work> work_;
  int worked_ = -1;             // the attempt of work_
  int placed_ = -1;             // the last attempt whose spot was found
  bool awaitsReading_ = false;  // current_ is to be decoded
  std::shared_ptr<Engraved> current_, best_;
};

}  // namespace qrelief
