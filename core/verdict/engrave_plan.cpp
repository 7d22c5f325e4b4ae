// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/engrave_plan.h"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <utility>

#include "qr/link_advice.h"

namespace qrelief {
namespace {

constexpr int kBestRank = 2;
constexpr double kLargerLimit = 2;         // times the usual greatest size
constexpr double kAtLimitFraction = 0.99;  // of the greatest size

/// Returns 2 for a code that decodes and prints well as a solid, 1 if an aspect is barely good, and else 0.
int rankOf(const Verdict& verdict) {
  if (!verdict.failed().empty()) return 0;
  const Level worst = std::max({verdict.reads.level, verdict.prints.level, verdict.solid.level});
  return kBestRank - static_cast<int>(worst);
}

/// Adds a change, in place of an earlier one of the same setting.
void set(std::vector<SettingChange>& changes, const SettingChange& change) {
  std::erase_if(changes, [&](const SettingChange& other) { return other.setting == change.setting; });
  changes.push_back(change);
}

/// Returns true if `a` needs fewer modules than `b`.
bool isSmaller(const CodeRequest& a, const CodeRequest& b) {
  const auto symbolA = encodeSymbol(a.text, a.symbol), symbolB = encodeSymbol(b.text, b.symbol);
  return symbolA && symbolB && symbolA->size < symbolB->size;
}

}  // namespace

EngravePlan::EngravePlan(EngraveRequest request, Options options)
    : options_(std::move(options)),
      asked_(std::move(request)),
      looksAtPrint_(options_.looksAtPrint && asked_.print.process && !asked_.code.isText()),
      isMarkOpen_(asked_.marking.isOpen),
      step_(options_.mayMove ? Step::Place : Step::Carve),
      kept_{0, asked_},
      current_{0, asked_},
      tried_(1) {}

bool EngravePlan::isFixed(const std::string& key) const {
  return !options_.mayChange || std::find(options_.fixed.begin(), options_.fixed.end(), key) != options_.fixed.end();
}

/// Returns true if the user left the setting to the program.
bool EngravePlan::isOpen(const std::string& key) const {
  static const EngraveRequest kDefault = defaultRequest();
  const Setting& setting = *findSetting(key);
  const bool isChosen = std::find(options_.chosen.begin(), options_.chosen.end(), key) != options_.chosen.end();
  return !isFixed(key) && !isChosen && setting.read(asked_) == setting.read(kDefault);
}

/// Carves the current attempt again with a change, at the same spot.
void EngravePlan::deepen(const SettingChange& change) {
  TriedCarving next{current().changes};
  set(next.changes, change);
  next.centreMm = current().centreMm;
  current_.number = static_cast<int>(tried_.size());
  apply(change, current_.request);
  tried_.push_back(std::move(next));
  step_ = Step::Carve;
}

/// Carves the request with changes.
/// @param moves  true: at its own best spot, if the centre is open
void EngravePlan::carveAnew(Phase phase, std::vector<SettingChange> changes, bool moves) {
  const bool findsSpot = options_.mayMove && moves;
  EngraveRequest request = asked_;
  if (options_.mayMove && !findsSpot) {
    request.placement.centreMm = kept_.request.placement.centreMm;
    request.placement.direction = kept_.request.placement.direction;
  }
  for (const SettingChange& change : changes) apply(change, request);
  current_ = {static_cast<int>(tried_.size()), std::move(request)};
  tried_.push_back({std::move(changes)});
  current().isOffer = phase == Phase::Offer;
  if (!findsSpot) current().centreMm = tried_[static_cast<std::size_t>(kept_.number)].centreMm;
  phase_ = phase;
  step_ = findsSpot ? Step::Place : Step::Carve;
}

/// Goes on with the kept carving: to its print, to a remedy, to the next mark, or to its delivery.
void EngravePlan::settle() {
  if (phase_ == Phase::Design && looksAtPrint_ && keptRank_) {
    current_ = kept_;
    step_ = Step::Print;
    return;
  }
  if (tryRemedy() || tryOtherMark() || tryOffer()) return;
  current_ = kept_;
  step_ = Step::Deliver;
}

/// Returns the changes with those that made modules larger.
std::vector<SettingChange> EngravePlan::withGrowth(std::vector<SettingChange> changes) const {
  for (const SettingChange& change : growth_) set(changes, change);
  return changes;
}

/// Writes a link's scheme and host in capitals, if the symbol is then smaller and the text may change.
void EngravePlan::capitalise(CodeRequest& code, std::vector<SettingChange>& changes) const {
  if (isFixed("text")) return;
  for (const ShorterForm& form : shorterForms(code.text)) {
    CodeRequest other = code;
    other.text = form.text;
    if (form.kind != ShorterForm::Kind::Capitals || !isSmaller(other, code)) continue;
    code.text = form.text;
    set(changes, {"text", form.text});
    return;
  }
}

/// Adds the changes to this error correction and to capitals. @returns false if the symbol is then no smaller
bool EngravePlan::shrinkSymbol(ErrorCorrection correction, std::vector<SettingChange>& changes) const {
  if (asked_.code.isText()) return false;
  EngraveRequest request = asked_;
  for (const SettingChange& change : changes) apply(change, request);
  CodeRequest code = request.code;
  if (correction != code.symbol.errorCorrection) {
    code.symbol.errorCorrection = correction;
    code.symbol.raiseErrorCorrection = false;
    set(changes, {"ecc", std::string(errorCorrectionName(correction))});
  }
  capitalise(code, changes);
  return isSmaller(code, request.code);
}

/// Tries the next remedy for a carving that fails.
bool EngravePlan::tryRemedy() {
  if (!fails() || phase_ == Phase::OtherMark || phase_ == Phase::Offer) return false;
  const TriedCarving& kept = tried_[static_cast<std::size_t>(kept_.number)];
  const double mostMm = asked_.placement.maxSizeMm;
  const bool isAtLimit = std::any_of(
      tried_.begin(), tried_.end(), [&](const TriedCarving& one) { return one.symbolMm >= kAtLimitFraction * mostMm; });
  while (nextRemedy_ != Remedy::None) {
    const Remedy remedy = nextRemedy_;
    nextRemedy_ = static_cast<Remedy>(static_cast<int>(remedy) + 1);
    switch (remedy) {
      case Remedy::LargerLimit:
        if (isAtLimit && isOpen("maxSizeMm") && isOpen("size")) {
          set(growth_, {"maxSizeMm", fmt::format("{:g}", kLargerLimit * mostMm)});
          carveAnew(Phase::Remedy, withGrowth(kept.changes));
          return true;
        }
        break;
      case Remedy::Capitals:
        if (std::vector<SettingChange> changes = withGrowth(kept.changes);
            shrinkSymbol(asked_.code.symbol.errorCorrection, changes)) {
          set(growth_, changes.back());
          carveAnew(Phase::Remedy, std::move(changes));
          return true;
        }
        break;
      case Remedy::LessCorrection:
        if (std::vector<SettingChange> changes = withGrowth(kept.changes);
            isOpen("ecc") && shrinkSymbol(ErrorCorrection::L, changes)) {
          carveAnew(Phase::Remedy, std::move(changes));
          return true;
        }
        break;
      case Remedy::None:
        break;
    }
  }
  return false;
}

/// Carves the next of the other marks, if the mark is open and one is left.
bool EngravePlan::tryOtherMark() {
  if (!isMarkOpen_ || keptRank_ == kBestRank || isFixed("mark") || marksTried_ == options_.otherMarks.size())
    return false;
  const SettingChange mark{"mark", std::string(markName(options_.otherMarks[marksTried_++]))};
  carveAnew(Phase::OtherMark, withGrowth({mark}), fails());
  return true;
}

/// Carves the next of the other marks to offer it, until one passes.
bool EngravePlan::tryOffer() {
  if (!options_.offersMarks || !fails() || isMarkOpen_ || !asked_.needsLight() || !isOpen("mark")) return false;
  if (passedOffer(tried_) || marksTried_ == options_.otherMarks.size()) return false;
  carveAnew(Phase::Offer, {{"mark", std::string(markName(options_.otherMarks[marksTried_++]))}});
  return true;
}

void EngravePlan::keepCurrent(const Verdict& verdict) {
  kept_ = current_;
  keptRank_ = rankOf(verdict);
}

/// Keeps a finished attempt if it is better, and goes on.
/// @param print  null: not looked at
void EngravePlan::settleAttempt(const Verdict& verdict, const PrintedEvidence* print) {
  if (phase_ != Phase::Offer && rankOf(verdict) > keptRank_.value_or(-1)) keepCurrent(verdict);
  const bool mayDeepen = phase_ == Phase::Remedy && print;
  const auto next = mayDeepen ? changeToTryNext(current_.request, verdict, print) : std::nullopt;
  if (next && !isFixed(next->setting))
    deepen(*next);
  else
    settle();
}

void EngravePlan::placed(const PlacementRequest& placement) {
  assert(step_ == Step::Place);
  current_.request.placement = placement;
  current().centreMm = placement.centreMm;
  if (kept_.number == current_.number) kept_ = current_;
  step_ = Step::Carve;
}

void EngravePlan::carved(const Verdict& verdict, const ReadingCount& reads, double symbolMm) {
  assert(step_ == Step::Carve);
  const bool isRead = verdict.reads.passed();
  current().reads = reads;
  current().symbolMm = symbolMm;
  current().passed = verdict.passed();
  if (phase_ != Phase::Design) {
    if (isRead && looksAtPrint_)
      step_ = Step::Print;
    else if (phase_ == Phase::Print)
      settle();
    else
      settleAttempt(verdict);
    return;
  }
  if (isRead || current_.number == 0) keepCurrent(verdict);
  const auto next = isRead ? std::nullopt : changeToTryNext(current_.request, verdict);
  if (next && !isFixed(next->setting))
    deepen(*next);
  else
    settle();
}

void EngravePlan::notCarved(const Error& error) {
  assert(step_ == Step::Carve || step_ == Step::Place);
  current().failure = error.message;
  if (error.kind != ErrorKind::NoSolution && current_.number == 0) {
    step_ = Step::Deliver;
    return;
  }
  for (const char* needsWall : {"nothing-can-be-carved", "nothing-can-be-carved-over-shell", "no-spot-wall-too-thin"})
    if (error.message.code == needsWall) nextRemedy_ = Remedy::None;  // a larger code needs deeper pockets
  settle();
}

void EngravePlan::printed(const Verdict& verdict, const PrintedEvidence& evidence) {
  assert(step_ == Step::Print);
  current().printed = evidence.reading.count;
  current().passed = verdict.passed();
  if (phase_ != Phase::Design && phase_ != Phase::Print) {
    settleAttempt(verdict, &evidence);
    return;
  }
  const bool isMended = phase_ == Phase::Print && evidence.reading.count.enough();
  if (isMended || kept_.number == current_.number) keepCurrent(verdict);
  phase_ = Phase::Print;
  const bool mayHelp = !isMended && verdict.reads.passed();  // deeper designs that do not decode were tried before
  const auto next = mayHelp ? changeToTryNext(current_.request, verdict, &evidence) : std::nullopt;
  if (next && !isFixed(next->setting))
    deepen(*next);
  else
    settle();
}

}  // namespace qrelief
