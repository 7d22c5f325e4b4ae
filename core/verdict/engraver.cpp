// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/engraver.h"

#include <algorithm>
#include <utility>

#include "base/clock.h"
#include "pipeline/requested_symbol.h"

namespace qrelief {
namespace {

/// Numbers of steps of a carving to do ahead: the surface, and the first passes of the search if there is one.
constexpr int kPreparedSteps = 5, kPreparedWithoutLight = 1;

}  // namespace

Engraver::Engraver(std::shared_ptr<const EngravableModel> model, std::size_t maxPlaces)
    : model_(std::move(model)), maxPlaces_(maxPlaces) {}

Result<std::shared_ptr<const LuminancePrograms>> Engraver::programs() {
  if (programs_) return programs_;
  auto compiled = LuminancePrograms::create();
  QRELIEF_TRY(compiled);
  programs_ = std::move(*compiled);
  return programs_;
}

/// Returns the place of a request; null: not known.
Engraver::Place* Engraver::placeOf(const EngraveRequest& request, int modules) {
  const PlacementRequest searched = searchedPlacement(request, modules);
  const auto place = std::find_if(places_.begin(), places_.end(),
                                  [&](const Place& one) { return one.modules == modules && one.request == searched; });
  return place == places_.end() ? nullptr : &*place;
}

void Engraver::remember(const EngraveRequest& request, FoundPlacement found) {
  const auto symbol = requestedSymbol(request.code);
  if (!symbol || placeOf(request, symbol->size)) return;
  places_.push_front({symbol->size, searchedPlacement(request, symbol->size), std::move(found), nullptr});
  if (places_.size() > maxPlaces_) places_.pop_back();
}

/// Creates the job of a carving.
/// @param sharesMeasurement  use the measurement of the last carving there, whose maps then change
Result<Engraver::Work> Engraver::create(const EngraveRequest& request, bool sharesMeasurement) {
  const auto symbol = requestedSymbol(request.code);
  QRELIEF_TRY(symbol);
  if (model_->usesShaders(device_)) QRELIEF_TRY(programs());
  const Place* const place = placeOf(request, symbol->size);
  auto job = CarveJob::create(model_, request,
                              {.placed = place ? &place->found : nullptr,
                               .programs = programs_,
                               .symbol = &*symbol,
                               .measured = place && sharesMeasurement ? place->measured : nullptr,
                               .device = device_});
  QRELIEF_TRY(job);
  return Work{request, symbol->size, std::move(*job), 0, place ? place->found.directionMs + place->found.sizeMs : 0};
}

/// Begins a carving, with the work done ahead if it is for the same request.
Result<Engraver::Work> Engraver::begin(const EngraveRequest& request) {
  std::list<Work> prepared = std::exchange(prepared_, {});
  for (Work& work : prepared)
    if (work.request == request) return std::move(work);
  return create(request, true);
}

/// Does one bounded piece of work.
Result<Progress> Engraver::advance(Work& work) {
  const auto start = Clock::now();
  const Result<Progress> progress = work.job->advance();
  ++work.steps;
  work.ms += millisecondsSince(start);
  return progress;
}

/// Remembers the place of a finished carving and what was measured there.
void Engraver::keepPlace(const Work& work) {
  if (auto found = work.job->foundPlace()) remember(work.request, std::move(*found));
  if (Place* const place = placeOf(work.request, work.modules)) place->measured = work.job->placementMeasurement();
}

bool Engraver::isPrepared(const Work& work, bool withSearch) {
  if (!work.request.needsLight()) return work.steps >= kPreparedWithoutLight;
  return withSearch ? work.job->hasSearched() : work.steps >= kPreparedSteps;
}

const CarveJob* Engraver::prepared(const EngraveRequest& request) const {
  for (const Work& work : prepared_)
    if (work.request == request) return work.job.get();
  return nullptr;
}

bool Engraver::prepare(const EngraveRequest& request, bool withSearch) {
  const auto symbol = requestedSymbol(request.code);
  const bool isPlaced = symbol && placeOf(request, symbol->size);
  if (!isPlaced) return true;
  const auto known =
      std::find_if(prepared_.begin(), prepared_.end(), [&](const Work& work) { return work.request == request; });
  if (known != prepared_.end()) {
    prepared_.splice(prepared_.begin(), prepared_, known);
    if (!isPrepared(*known, withSearch) && !advance(*known)) {
      prepared_.pop_front();
      return true;
    }
  } else {
    const auto start = Clock::now();
    auto work = create(request, false);  // the measurement may belong to a carving that is shown
    if (!work) return true;              // the engraving itself reports the error
    work->ms += millisecondsSince(start);
    prepared_.push_front(std::move(*work));
    if (prepared_.size() > kPreparedKept) prepared_.pop_back();
  }
  return isPrepared(prepared_.front(), withSearch);
}

}  // namespace qrelief
