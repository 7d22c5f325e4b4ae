// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "settings/engrave_request.h"
#include "verdict/tried_carving.h"
#include "verdict/verdict.h"

namespace qrelief {

/// The steps of an engraving:
///
/// 1. Carve as requested; if the code does not decode, or its print barely does, carve deeper (changeToTryNext()). Take
///    the first carving that decodes.
/// 2. If it fails, try what the user left open, cheapest first: a size beyond the usual limit, a link's scheme and host
///    in capitals and less error correction if the symbol then has fewer modules. Each attempt goes to its own best
///    spot if the centre is open, too, and goes deeper if its print barely decodes.
/// 3. If the mark is open (MarkRequest::isOpen) and no shadow code decodes and prints well, carve an inlay, then paint.
/// 4. Deliver the best, or else the carving as requested. If that fails and the user did not choose the mark, carve the
///    other marks only to offer them (TriedCarving::isOffer).
///
/// Of a text alone only a size beyond the usual limit and other marks are tried, and nothing is decoded or printed.
///
/// A first carving that passes ends the plan at once. A setting that the user chose is not changed, except by deeper
/// presets, by carving for the design alone, and for capitals, which open the same address. The host carries out each
/// step and reports the outcome. Command, batch and page drive the same plan, so they deliver the same carving.
class EngravePlan {
 public:
  enum class Step {
    Place,   ///< find the best spot for request(); then call placed() or notCarved()
    Carve,   ///< carve request() and decode pictures of it; then call carved() or notCarved()
    Print,   ///< simulate the print of carving attempt() and decode it; then call printed()
    Deliver  ///< carving attempt() is the result; it does not exist if no attempt could be carved
  };

  struct Options {
    bool looksAtPrint = true;              ///< also simulate prints, if the request names a process
    bool mayChange = true;                 ///< false: carve as requested only
    bool mayMove = false;                  ///< true: the centre is open, and the host finds spots
    bool offersMarks = false;              ///< also carve other marks to offer them
    std::vector<std::string> fixed = {};   ///< keys of settings that must not change
    std::vector<std::string> chosen = {};  ///< keys of settings that the user gave, in addition to those that differ
                                           ///< from their defaults
    std::vector<Mark> otherMarks = {Mark::Inlay, Mark::Paint};  ///< to try in this order
  };

  EngravePlan(EngraveRequest request, Options options);

  Step step() const { return step_; }
  /// Returns the number of the carving that the step concerns: 0 for the carving as requested.
  int attempt() const { return step_ == Step::Deliver ? kept_.number : current_.number; }
  /// Returns the number of the best carving so far, to keep for delivery.
  int kept() const { return kept_.number; }
  /// Returns the request of carving attempt().
  const EngraveRequest& request() const { return step_ == Step::Deliver ? kept_.request : current_.request; }
  /// Returns all changes of carving attempt() from the carving as requested.
  const std::vector<SettingChange>& changes() const { return tried_[static_cast<std::size_t>(attempt())].changes; }
  /// Returns true if a Print step probably follows the Carve step, so that the host may start it early.
  bool expectsPrint() const { return looksAtPrint_ && (current_.number == 0 || phase_ != Phase::Design); }
  /// Returns all attempts so far, by number.
  const std::vector<TriedCarving>& tried() const { return tried_; }

  /// Ends a Place step. @param placement  the request's, with the centre of the spot
  void placed(const PlacementRequest& placement);
  /// Ends a Carve step. @param verdict  with the decoded pictures, without the print
  void carved(const Verdict& verdict, const ReadingCount& reads, double symbolMm);
  /// Ends a Place or Carve step that failed. No change helps but for ErrorKind::NoSolution.
  void notCarved(const Error& error);
  /// Ends a Print step. @param verdict  with the print
  void printed(const Verdict& verdict, const PrintedEvidence& evidence);

 private:
  enum class Phase { Design, Print, Remedy, OtherMark, Offer };  // goal of the changes
  enum class Remedy { LargerLimit, Capitals, LessCorrection, None };
  struct Attempt {
    int number = 0;
    EngraveRequest request;
  };

  bool isFixed(const std::string& key) const;
  bool isOpen(const std::string& key) const;
  bool fails() const { return keptRank_.value_or(0) == 0; }
  TriedCarving& current() { return tried_[static_cast<std::size_t>(current_.number)]; }
  void deepen(const SettingChange& change);
  void carveAnew(Phase phase, std::vector<SettingChange> changes, bool moves = true);
  void settle();
  void keepCurrent(const Verdict& verdict);
  void settleAttempt(const Verdict& verdict, const PrintedEvidence* print = nullptr);
  std::vector<SettingChange> withGrowth(std::vector<SettingChange> changes) const;
  void capitalise(CodeRequest& code, std::vector<SettingChange>& changes) const;
  bool shrinkSymbol(ErrorCorrection correction, std::vector<SettingChange>& changes) const;
  bool tryRemedy();
  bool tryOtherMark();
  bool tryOffer();

  Options options_;
  EngraveRequest asked_;
  bool looksAtPrint_ = false;
  bool isMarkOpen_ = false;
  Remedy nextRemedy_ = Remedy::LargerLimit;
  std::vector<SettingChange> growth_;  // changes that were tried because they make modules larger
  std::size_t marksTried_ = 0;         // of the other marks
  std::optional<int> keptRank_;        // of the kept carving, see rankOf(); none: not carved
  Step step_ = Step::Carve;
  Phase phase_ = Phase::Design;
  Attempt kept_, current_;
  std::vector<TriedCarving> tried_;
};

}  // namespace qrelief
