// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verdict/verdict.h"

namespace qrelief {

/// The steps of an engraving: carve as requested; if the code does not decode, or its print barely does, carve with the
/// changes of changeToTryNext(); deliver the first carving that decodes, or else the carving as requested. If the mark
/// is open (MarkRequest::isOpen) and no shadow code decodes and prints well, carve an inlay, then paint; deliver the
/// best. The host carries out each step and reports the outcome. Command, batch and page drive the same plan, so they
/// deliver the same carving.
class EngravePlan {
 public:
  enum class Step {
    Carve,   ///< carve request() and decode pictures of it; then call carved() or notCarved()
    Print,   ///< simulate the print of carving attempt() and decode it; then call printed()
    Deliver  ///< carving attempt() is the result
  };

  struct Options {
    bool looksAtPrint = true;             ///< also simulate prints, if the request names a process
    bool mayChange = true;                ///< false: carve as requested only
    std::vector<std::string> fixed = {};  ///< keys of settings that must not change
    std::vector<Mark> otherMarks = {Mark::Inlay, Mark::Paint};  ///< to try for an open mark, in this order
  };

  EngravePlan(EngraveRequest request, Options options);

  Step step() const { return step_; }
  /// Returns the number of the carving that the step concerns: 0 for the carving as requested.
  int attempt() const { return step_ == Step::Deliver ? kept_.number : current_.number; }
  /// Returns the number of the best carving so far, to keep for delivery.
  int kept() const { return kept_.number; }
  /// Returns the request of carving attempt().
  const EngraveRequest& request() const { return step_ == Step::Deliver ? kept_.request : current_.request; }
  /// Returns the change of a Carve step from the carving before it; none for the carving as requested.
  const std::optional<SettingChange>& change() const { return change_; }
  /// Returns true if a Print step probably follows the Carve step, so that the host may start it early.
  bool expectsPrint() const { return looksAtPrint_ && (current_.number == 0 || phase_ != Phase::Design); }

  /// Ends a Carve step. @param verdict  with the decoded pictures, without the print
  void carved(const Verdict& verdict);
  /// Returns true if the plan goes on after a Carve step that fails: always for a changed request, and for the carving
  /// as requested if its mark is open. Should all marks fail, the plan delivers attempt 0, which then does not exist.
  bool mayFail() const { return current_.number > 0 || isMarkOpen_; }
  /// Ends a Carve step that failed. Only if mayFail().
  void notCarved();
  /// Ends a Print step. @param verdict  with the print
  void printed(const Verdict& verdict, const PrintedEvidence& evidence);

 private:
  enum class Phase { Design, Print, OtherMark };  // goal of the changes
  struct Attempt {
    int number = 0;
    EngraveRequest request;
  };

  std::optional<SettingChange> allowed(std::optional<SettingChange> change) const;
  void carveNext(const SettingChange& change);
  void settle();
  void keepCurrent(const Verdict& verdict);
  void settleColour(const Verdict& verdict);
  bool tryOtherMark();

  Options options_;
  bool looksAtPrint_ = false;
  bool isMarkOpen_ = false;
  std::size_t marksTried_ = 0;   // of the other marks
  std::optional<int> keptRank_;  // of the kept carving, see rankOf(); none: not carved
  Step step_ = Step::Carve;
  Phase phase_ = Phase::Design;
  Attempt kept_, current_;
  int attempts_ = 1;
  std::optional<SettingChange> change_;
};

}  // namespace qrelief
