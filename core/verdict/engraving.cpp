// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/engraving.h"

#include <cassert>
#include <utility>

#include "base/clock.h"
#include "message_codes/stages.h"
#include "pipeline/best_spot.h"

namespace qrelief {

void Engraved::judgeAnew() {
  verdict = withRemediesLeft(judge(request, result, reading, printed ? &*printed : nullptr), tried);
}

Engraving::Engraving(Engraver& engraver, EngraveRequest request, EngravePlan::Options options)
    : engraver_(engraver), plan_(std::move(request), std::move(options)) {}

Result<Engraving::Step> Engraving::advance() {
  if (isWorking()) {
    if (plan_.step() == EngravePlan::Step::Place)
      searchSpot();
    else
      carve();
  }
  return next();
}

Result<Engraving::Step> Engraving::next() const {
  if (awaitsReading_) return Step::Decode;
  if (awaitsPrint()) return Step::Print;
  if (isWorking()) return Step::Work;
  if (!best_) return tl::unexpected(withOffer(*failure_, plan_.tried()));
  return Step::Done;
}

Progress Engraving::progress() const {
  if (spots_) return spots_->progress();
  if (awaitsPrint()) return {message<"printing">(), 1, true};
  if (!isWorking()) return {message<"looking-at-result">(), 1, true};
  if (work_ && worked_ == plan_.attempt()) return work_->job->progress();
  return {message<"finding-direction-and-size">(), 0};
}

bool Engraving::isWorking() const {
  return !awaitsReading_ && (plan_.step() == EngravePlan::Step::Place || plan_.step() == EngravePlan::Step::Carve);
}

const EngraveResult* Engraving::printable() const {
  const bool isCarving = isWorking() && work_ && worked_ == plan_.attempt();
  return isCarving ? work_->job->writtenResult() : nullptr;
}

/// Notes that an attempt failed.
void Engraving::fail(const Error& error) {
  if (plan_.attempt() == 0) failure_ = error;
  plan_.notCarved(error);
  keep();
}

/// Does one step of the search for the attempt's spot.
void Engraving::searchSpot() {
  const auto start = Clock::now();
  if (!spots_) {
    auto search = searchBestSpot(engraver_.sharedModel(), plan_.request(), engraver_.model().prepared.scaleToMm);
    if (!search) return fail(search.error());
    spots_ = std::move(*search);
  }
  const Result<Progress> progress = spots_->advance();
  spotMs_ += millisecondsSince(start);
  if (progress && !progress->done) return;
  const std::unique_ptr<SpotSearchJob> search = std::exchange(spots_, nullptr);
  if (!progress) return fail(progress.error());
  const Spot spot = search->takeResult().spots.front();
  plan_.placed(placedAt(spot, plan_.request().placement));
  engraver_.remember(plan_.request(), {*spot.placement, 0, 0});  // its time counts as the search's
}

/// Does one step of the attempt's carving.
void Engraving::carve() {
  if (worked_ != plan_.attempt()) {
    work_.reset();
    auto begun = engraver_.begin(plan_.request());
    if (!begun) return fail(begun.error());
    work_ = std::move(*begun);
    worked_ = plan_.attempt();
    return;
  }
  const Result<Progress> progress = Engraver::advance(*work_);
  if (!progress) return fail(progress.error());
  if (!progress->done) return;
  engraver_.keepPlace(*work_);
  current_ = std::make_shared<Engraved>(Engraved{plan_.request(), work_->job->takeResult()});
  current_->attempt = plan_.attempt();
  current_->workMs = work_->ms;
  current_->judgeAnew();
  awaitsReading_ = true;
  if (current_->result.readerView.luminance.empty()) decoded({});  // a text alone
}

std::vector<GreyImage> Engraving::pictures() const {
  const ReaderView& seen = current_->result.readerView;
  return frontalPictures(seen.luminance, seen.pixelsPerModule);
}

/// Keeps what the plan keeps, and brings it up to date with the plan.
void Engraving::keep() {
  if (current_ && plan_.kept() == current_->attempt) best_ = current_;
  if (awaitsPrint() && plan_.attempt() == plan_.kept()) current_ = best_;
  for (const auto& engraved : {current_, best_}) {
    if (!engraved) continue;
    engraved->tried = plan_.tried();
    engraved->spotMs = spotMs_;
    engraved->judgeAnew();
  }
}

void Engraving::decoded(const ReadingEvidence& reading, double ms) {
  assert(awaitsReading_);
  awaitsReading_ = false;
  Engraved& engraved = *current_;
  engraved.reading = reading;
  engraved.result.timingsMs.verify += ms;
  plan_.carved(judge(engraved.request, engraved.result, reading), reading.count, engraved.result.placement.symbolMm);
  keep();
}

void Engraving::printed(const PrintedEvidence& print, double ms) {
  assert(awaitsPrint());
  Engraved& engraved = *current_;
  engraved.printed = print;
  engraved.result.timingsMs.print = ms;
  plan_.printed(judge(engraved.request, engraved.result, engraved.reading, &print), print);
  keep();
}

}  // namespace qrelief
