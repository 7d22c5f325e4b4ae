// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/engrave_plan.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace qrelief {

EngravePlan::EngravePlan(EngraveRequest request, Options options)
    : options_(std::move(options)),
      looksAtPrint_(options_.looksAtPrint && request.process),
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

/// Goes on with the kept carving: to its print, or to its delivery after the last print.
void EngravePlan::settle() {
  current_ = kept_;
  step_ = phase_ == Phase::Design && looksAtPrint_ ? Step::Print : Step::Deliver;
}

void EngravePlan::carved(const Verdict& verdict) {
  assert(step_ == Step::Carve);
  const bool reads = verdict.reads.passed();
  if (phase_ == Phase::Print) {
    if (reads)
      step_ = Step::Print;
    else
      settle();
    return;
  }
  if (reads) kept_ = current_;
  if (const auto next = reads ? std::nullopt : allowed(changeToTryNext(current_.request, verdict)))
    carveNext(*next);
  else
    settle();
}

void EngravePlan::notCarved() {
  assert(step_ == Step::Carve && current_.number > 0);
  settle();
}

void EngravePlan::printed(const Verdict& verdict, const PrintedEvidence& evidence) {
  assert(step_ == Step::Print);
  const bool isMended = phase_ == Phase::Print && evidence.reading.count.enough();
  if (isMended) kept_ = current_;
  phase_ = Phase::Print;
  const bool mayHelp = !isMended && verdict.reads.passed();  // deeper designs that do not decode were tried before
  if (const auto next = mayHelp ? allowed(changeToTryNext(current_.request, verdict, &evidence)) : std::nullopt)
    carveNext(*next);
  else
    settle();
}

}  // namespace qrelief
