// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/engraving.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "base/clock.h"
#include "message_codes/stages.h"
#include "pipeline/best_spot.h"

namespace qrelief {
namespace {

/// Share of an attempt in what the attempts before it have left: nobody knows how many will follow, and most engravings
/// need one.
constexpr double kAttemptShare = 0.75;
/// Shares of an attempt that are done once its spot is found, and once it is carved. The print is mostly simulated
/// meanwhile.
constexpr double kPlacedShare = 0.45, kCarvedShare = 0.9;

}  // namespace

void Engraved::judgeAnew() {
  verdict = withRemediesLeft(judge(request, result, reading, printed ? &*printed : nullptr), tried);
}

Engraving::Engraving(Engraver& engraver, EngraveRequest request, EngravePlan::Options options)
    : engraver_(engraver),
      attemptShare_(options.mayChange ? kAttemptShare : 1),
      plan_(std::move(request), std::move(options)) {}

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
  if (spots_) return withinAttempt(spots_->progress(), 0, kPlacedShare);
  if (awaitsPrint()) return withinAttempt({message<"printing">(), 0, true}, kCarvedShare, 1);
  const Message looking = message<"looking-at-result">();
  if (awaitsReading_) return withinAttempt({looking, 0, true}, kCarvedShare, 1);
  if (!isWorking()) return {looking, 1, true};
  const bool wasPlaced = placed_ == plan_.attempt();
  const bool isCarving = work_ && worked_ == plan_.attempt();
  const Progress carving = isCarving ? work_->job->progress() : Progress{message<"finding-direction-and-size">()};
  return withinAttempt(carving, wasPlaced ? kPlacedShare : 0, kCarvedShare);
}

/// Returns the progress of a part of the last attempt as progress of the engraving.
/// @param from, to  the part's bounds, in shares of the attempt
Progress Engraving::withinAttempt(Progress part, double from, double to) const {
  const double left = std::pow(1 - attemptShare_, static_cast<double>(plan_.tried().size()) - 1);
  part.fraction = 1 - left + left * attemptShare_ * (from + part.fraction * (to - from));
  return part;
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
  placed_ = plan_.attempt();
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
