// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/engrave_plan.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace qrelief {
namespace {

constexpr int kBestRank = 2;

/// Returns 2 for a code that decodes and prints well as a solid, 1 if an aspect is barely good, and else 0.
int rankOf(const Verdict& verdict) {
  if (!verdict.failed().empty()) return 0;
  const Level worst = std::max({verdict.reads.level, verdict.prints.level, verdict.solid.level});
  return kBestRank - static_cast<int>(worst);
}

}  // namespace

EngravePlan::EngravePlan(EngraveRequest request, Options options)
    : options_(std::move(options)),
      looksAtPrint_(options_.looksAtPrint && request.print.process),
      isMarkOpen_(request.marking.isOpen),
      kept_{0, request},
      current_{0, std::move(request)} {}

/// Returns the change if the options allow it.
std::optional<SettingChange> EngravePlan::allowed(std::optional<SettingChange> change) const {
  const auto isFixed = [&] {
    return std::find(options_.fixed.begin(), options_.fixed.end(), change->setting) != options_.fixed.end();
  };
  return change && options_.mayChange && !isFixed() ? change : std::nullopt;
}

void EngravePlan::carveNext(const SettingChange& change) {
  change_ = change;
  current_.number = attempts_++;
  apply(change, current_.request);
  step_ = Step::Carve;
}

/// Goes on with the kept carving: to its print, to the next mark in colour, or to its delivery.
void EngravePlan::settle() {
  if (phase_ == Phase::Design && looksAtPrint_ && keptRank_) {
    current_ = kept_;
    step_ = Step::Print;
    return;
  }
  if (keptRank_ != kBestRank && tryOtherMark()) return;
  current_ = kept_;
  step_ = Step::Deliver;
}

/// Carves the next of the other marks, if the mark is open and one is left.
bool EngravePlan::tryOtherMark() {
  if (!isMarkOpen_ || marksTried_ == options_.otherMarks.size()) return false;
  const auto change = allowed(SettingChange{"mark", std::string(markName(options_.otherMarks[marksTried_++]))});
  if (!change) return false;
  phase_ = Phase::OtherMark;
  carveNext(*change);
  return true;
}

void EngravePlan::keepCurrent(const Verdict& verdict) {
  kept_ = current_;
  keptRank_ = rankOf(verdict);
}

/// Keeps a finished carving in colour if it is better, and goes on.
void EngravePlan::settleColour(const Verdict& verdict) {
  if (rankOf(verdict) > keptRank_.value_or(-1)) keepCurrent(verdict);
  settle();
}

void EngravePlan::carved(const Verdict& verdict) {
  assert(step_ == Step::Carve);
  const bool reads = verdict.reads.passed();
  if (phase_ != Phase::Design) {
    if (reads && looksAtPrint_)
      step_ = Step::Print;
    else if (phase_ == Phase::OtherMark)
      settleColour(verdict);
    else
      settle();
    return;
  }
  if (reads || current_.number == 0) keepCurrent(verdict);
  if (const auto next = reads ? std::nullopt : allowed(changeToTryNext(current_.request, verdict)))
    carveNext(*next);
  else
    settle();
}

void EngravePlan::notCarved() {
  assert(step_ == Step::Carve && mayFail());
  settle();
}

void EngravePlan::printed(const Verdict& verdict, const PrintedEvidence& evidence) {
  assert(step_ == Step::Print);
  if (phase_ == Phase::OtherMark) {
    settleColour(verdict);
    return;
  }
  const bool isMended = phase_ == Phase::Print && evidence.reading.count.enough();
  if (isMended || kept_.number == current_.number) keepCurrent(verdict);
  phase_ = Phase::Print;
  const bool mayHelp = !isMended && verdict.reads.passed();  // deeper designs that do not decode were tried before
  if (const auto next = mayHelp ? allowed(changeToTryNext(current_.request, verdict, &evidence)) : std::nullopt)
    carveNext(*next);
  else
    settle();
}

}  // namespace qrelief
