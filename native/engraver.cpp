// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/engraver.h"

#include <map>

#include "base/clock.h"
#include "message_codes/stages.h"
#include "native/read_carving.h"
#include "pipeline/best_spot.h"
#include "pipeline/requested_symbol.h"
#include "pipeline/verify.h"

namespace qrelief {
namespace {

constexpr std::size_t kPlaces = 8;  // rows of a batch may differ in settings that their place depends on

}  // namespace

Result<Engraver> Engraver::create(std::shared_ptr<const EngravableModel> model) {
  Engraver engraver;
  if (model->usesShaders(Device::Faster)) {
    auto programs = LuminancePrograms::create();
    QRELIEF_TRY(programs);
    engraver.programs_ = std::move(*programs);
  }
  engraver.model_ = std::move(model);
  return engraver;
}

Result<Engraver::Place*> Engraver::placeOf(const EngraveRequest& request, int modules) const {
  const PlacementRequest placement = searchedPlacement(request, modules);
  for (Place& place : places_)
    if (place.modules == modules && place.request == placement) return &place;
  PlacementSearch search(model_->prepared, *model_->renderer, modules, placement);
  for (;;) {
    const Result<bool> done = search.step();
    QRELIEF_TRY(done);
    if (*done) break;
  }
  places_.push_front({modules, placement, std::move(search), nullptr});
  if (places_.size() > kPlaces) places_.pop_back();
  return &places_.front();
}

Result<Engraver::Carving> Engraver::carve(const EngraveRequest& request, const Tell& tell, bool looksAtPrint) const {
  const auto symbol = requestedSymbol(request.code);
  QRELIEF_TRY(symbol);
  tell({message<"finding-direction-and-size">(), 0});
  QRELIEF_TRY(checkEngraving(*model_, request, *symbol));
  const auto place = placeOf(request, symbol->size);
  QRELIEF_TRY(place);
  Place& known = **place;
  auto job = EngraveJob::create(
      model_, request, {.placed = &known.found, .programs = programs_, .symbol = &*symbol, .measured = known.measured});
  QRELIEF_TRY(job);
  Carving carving;
  const Status ended = advanceToEnd(**job, [&](const Progress& progress) {
    tell(progress);
    const EngraveResult* const written = (*job)->writtenResult();
    if (looksAtPrint && written && !carving.print.valid())
      carving.print = std::async(std::launch::async, printed, verifyRequestOf(request, *written), written->mesh);
  });
  QRELIEF_TRY(ended);
  EngraveResult result = (*job)->takeResult();
  known.measured = (*job)->placementMeasurement();
  const auto start = Clock::now();
  const ReadingEvidence evidence = readCarving(request, result);
  result.timingsMs.verify += millisecondsSince(start);
  Verdict verdict = judge(request, result, evidence);
  carving.engraved = Engraved{request, std::move(result), evidence, {}, std::move(verdict)};
  return carving;
}

/// Simulates and decodes the print of a carving. Needs no GL context, so it can run in parallel.
Result<Engraver::Print> Engraver::printed(const VerifyRequest& request, const Mesh& carved) {
  const auto start = Clock::now();
  auto evidence = readPrinted(request, carved, [](const Progress&) {});
  QRELIEF_TRY(evidence);
  return Print{std::move(*evidence), millisecondsSince(start)};
}

/// Adds the print of a carving, which may be running already.
Status Engraver::addPrint(Carving& carving, const Tell& tell) const {
  Engraved& engraved = carving.engraved;
  tell({message<"printing">(), 1});
  auto print = carving.print.valid()
                   ? carving.print.get()
                   : printed(verifyRequestOf(engraved.request, engraved.result), engraved.result.mesh);
  QRELIEF_TRY(print);
  engraved.printed = std::move(print->evidence);
  engraved.result.timingsMs.print = print->ms;
  engraved.verdict = judge(engraved.request, engraved.result, engraved.reading, &engraved.printed.value());
  return {};
}

Result<PlacementRequest> Engraver::spotFor(const EngraveRequest& request, const Tell& tell) const {
  const auto spot = bestSpot(model_, request, {.scaleToMm = model_->prepared.scaleToMm, .tell = tell});
  QRELIEF_TRY(spot);
  return placedAt(*spot, request.placement);
}

Result<Engraved> Engraver::follow(EngravePlan plan, const Tell& tell) const {
  std::map<int, Carving> carvings;  // by attempt: the kept one and the current one
  std::optional<Error> failure;     // of the carving as requested
  double spotMs = 0;
  const auto fail = [&](const Error& error) {
    if (plan.attempt() == 0) failure = error;
    plan.notCarved(error);
  };
  while (plan.step() != EngravePlan::Step::Deliver) {
    const int attempt = plan.attempt();
    if (plan.step() == EngravePlan::Step::Print) {
      Carving& carving = carvings.at(attempt);
      QRELIEF_TRY(addPrint(carving, tell));
      plan.printed(carving.engraved.verdict, *carving.engraved.printed);
    } else if (plan.step() == EngravePlan::Step::Place) {
      const auto start = Clock::now();
      const auto placement = spotFor(plan.request(), tell);
      spotMs += millisecondsSince(start);
      if (placement)
        plan.placed(*placement);
      else
        fail(placement.error());
    } else if (auto carved = carve(plan.request(), tell, plan.expectsPrint())) {
      const Engraved& engraved = carvings.emplace(attempt, std::move(*carved)).first->second.engraved;
      plan.carved(engraved.verdict, engraved.reading.count, engraved.result.placement.symbolMm);
    } else {
      fail(carved.error());
    }
    std::erase_if(carvings, [&](const auto& one) { return one.first != plan.kept() && one.first != plan.attempt(); });
  }
  const auto delivered = carvings.find(plan.attempt());
  if (delivered == carvings.end()) return tl::unexpected(withOffer(std::move(*failure), plan.tried()));
  Engraved engraved = std::move(delivered->second.engraved);
  engraved.tried = plan.tried();
  engraved.attempt = plan.attempt();
  engraved.spotMs = spotMs;
  engraved.verdict = withRemediesLeft(std::move(engraved.verdict), engraved.tried);
  return engraved;
}

Result<Engraved> Engraver::engraveOnce(const EngraveRequest& request, const Tell& tell) const {
  return follow({request, {.mayChange = false}}, tell);
}

Result<Engraved> Engraver::engrave(const EngraveRequest& request, const Tell& tell,
                                   const EngravePlan::Options& options) const {
  return follow({request, options}, tell);
}

}  // namespace qrelief
