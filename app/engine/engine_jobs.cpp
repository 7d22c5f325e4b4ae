// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the jobs: engravings, searches for spots and for the place of a hovered code, and view trials.
#include <algorithm>
#include <cassert>

#include "base/parse_json.h"
#include "engine/answers.h"
#include "engine/engine.h"
#include "message_codes/engine.h"
#include "projection/flatness.h"

namespace qrelief {
namespace {

Json jsonOf(const SpotOffers& offers) {
  Json spots = Json::array();
  for (const Spot& spot : offers.spots()) {
    spots.push_back({{"centre", qrelief::jsonOf(spot.centreMm)},
                     {"aimToleranceDeg", spot.aimToleranceDeg},
                     {"sizeMm", offers.offeredMm(spot)},
                     {"concerns", qrelief::jsonOf(std::span(spot.concerns))}});
  }
  return spots;
}

Json jsonOf(const std::vector<SettingChange>& changes) {
  Json json = Json::array();
  for (const SettingChange& change : changes) json.push_back({{"setting", change.setting}, {"value", change.value}});
  return json;
}

const Json kNothingToPrepare = {{"ok", true}, {"done", true}, {"depths", nullptr}};

/// Returns the depths that a search has found, over its carved submodules.
Json depthsOf(const SearchRecord& search) {
  const std::vector<float>& depths = search.passes.back().depthMm;
  double sum = 0;
  for (const float depth : depths) sum += depth;
  return {{"meanMm", sum / static_cast<double>(depths.size())},
          {"maxMm", *std::max_element(depths.begin(), depths.end())}};
}

}  // namespace

std::string Engine::startEngrave(const std::string& options,
                                 const std::function<EngraveRequest(EngraveRequest)>& overridden) {
  const Result<Json> parsed = parseJson(options);
  if (!parsed) return answer(parsed.error());
  scene_.show(Scene::Surface::Sizes, false);
  hideCarved();
  if (!model_) return answer(kNoModel);
  if (!wanted_.centreMm()) return answer(ErrorKind::BadUsage, message<"no-centre">());
  EngraveRequest request = wanted_.request(scene_.camera().modelUp());
  if (overridden) request = overridden(std::move(request));
  const FoundPlacement* const placed = overridden ? nullptr : preview_.found(request, wanted_.symbol());
  carvings_.start(ground(), std::move(request),
                  {.looksAtPrint = parsed->value("print", true),
                   .mayChange = !overridden,
                   .offersMarks = parsed->value("offers", false),
                   .fixed = parsed->value("fixed", std::vector<std::string>())},
                  placed);
  updateView();
  return advanceEngrave();
}

std::string Engine::startSpotSearch() {
  offers_.forget();
  showSizes(false);
  if (!model_) return answer(kNoModel);
  if (!wanted_.symbol()) return answer(wanted_.symbol().error());
  const Status started = offers_.start(task());
  return started ? done() : answer(started.error());
}

std::string Engine::advancePreparation(const std::string& options) {
  const Result<Json> parsed = parseJson(options);
  if (!parsed) return answer(parsed.error());
  const bool withSearch = parsed->value("search", false), ofHovered = parsed->value("hovered", false);
  if (!model_ || !wanted_.symbol() || carvings_.isRunning() || offers_.isRunning()) return textOf(kNothingToPrepare);
  const EngraveRequest* const hovered = ofHovered ? preview_.hoveredRequest(task()) : nullptr;
  if (ofHovered ? !hovered : !wanted_.centreMm()) return textOf(kNothingToPrepare);
  const EngraveRequest request = ofHovered ? *hovered : wanted_.request(scene_.camera().modelUp());
  const FoundPlacement* const placed = ofHovered ? preview_.hoveredPlace() : preview_.found(request, wanted_.symbol());
  const bool isDone = carvings_.prepare(ground(), request, placed, withSearch);
  const CarveJob* const job = withSearch ? carvings_.prepared(request) : nullptr;
  const SearchRecord* const search = job ? job->inspectorMaps().search : nullptr;
  const bool isNews = search && (search->passes.size() == 1 || (isDone && job->hasSearched()));
  if (!isNews) return textOf({{"ok", true}, {"done", isDone}, {"depths", nullptr}});
  if (ofHovered) {
    preview_.showHovered(*search, *wanted_.symbol());
    scene_.setGhost(preview_.hovered());
  } else {
    preview_.show(*search, *wanted_.symbol());
    updateView();
  }
  return textOf({{"ok", true}, {"done", isDone}, {"depths", depthsOf(*search)}});
}

std::string Engine::advanceEngrave() {
  if (!carvings_.engraving()) return answer(ErrorKind::BadUsage, message<"not-engraving">());
  const int started = carvings_.started(), shown = carvings_.number();
  const auto step = carvings_.advance();
  if (!step) return answer(step.error());
  if (carvings_.started() != started) hideCarved();
  if (const EngraveResult* const result = carvings_.result(); result && carvings_.number() != shown) {
    preview_.take(result->placement, exactCode(*model_, result->symbol, result->request, result->placement));
    updateView();
  }
  const Engraving& engraving = *carvings_.engraving();
  const bool isEarly = carvings_.isRunning() && carvings_.printable();
  return answer(engraving.progress(), {{"needs", *step == Engraving::Step::Decode  ? Json("texts")
                                                 : *step == Engraving::Step::Print ? Json("print")
                                                                                   : Json()},
                                       {"printable", isEarly},
                                       {"carving", carvings_.number()},
                                       {"best", carvings_.best()},
                                       {"changes", jsonOf(engraving.plan().changes())}});
}

std::string Engine::advanceSpotSearch() {
  if (!offers_.isRunning()) return answer(ErrorKind::BadUsage, message<"not-finding-spots">());
  const Result<Progress> progress = offers_.advance();
  if (!progress) return answer(progress.error());
  if (!progress->done) return answer(*progress);
  const std::optional<double> fixed = offers_.fixedMm();
  return answer(*progress,
                {{"spots", jsonOf(offers_)}, {"topMm", offers_.topMm()}, {"fixedMm", fixed ? Json(*fixed) : Json()}});
}

std::string Engine::advanceSettling() {
  if (!preview_.isSettling()) return answer(kNoCode);
  const Result<bool> settled = preview_.settle(task());
  if (!settled) return answer(settled.error());
  if (!*settled) return textOf({{"ok", true}, {"done", false}});
  scene_.setGhost(preview_.hovered());
  return describeCode(*preview_.hovered());
}

std::string Engine::advanceViewTrials(const std::string& outcome) {
  const Result<Json> parsed = parseJson(outcome);
  if (!parsed) return answer(parsed.error());
  ViewTrials* trials = carvings_.result() ? carvings_.viewTrials() : nullptr;
  if (!trials || trials->done()) return answer(kNoResult);
  trials->note(parsed->at("read"));
  const ViewTrialSummary summary = trials->summary();
  Json tilts = Json::array();
  for (const ViewTrialSummary::Tilt& tilt : summary.tilts)
    tilts.push_back({{"tiltDeg", tilt.tiltDeg}, {"reads", tilt.reads}, {"all", tilt.all}});
  const std::optional<double> pixels = summary.pixelsPerModule;
  const double moduleMm = carvings_.result()->placement.moduleMm;
  const Json views = {{"tilts", tilts},
                      {"safeTiltDeg", summary.safeTiltDeg},
                      {"forgiving", summary.safeTiltDeg >= kForgivingTiltDeg},
                      {"pixelsPerModule", pixels ? Json(*pixels) : Json()},
                      {"distanceMm", pixels ? Json(videoDistanceMm(moduleMm, *pixels)) : Json()}};
  return textOf(
      {{"ok", true}, {"done", trials->done()}, {"tried", trials->tried()}, {"all", trials->all()}, {"views", views}});
}

std::string Engine::startJob(const std::string& job, const std::string& options,
                             const std::function<EngraveRequest(EngraveRequest)>& overridden) {
  if (job == "spots") return startSpotSearch();
  if (job == "settling") return takesCode() && preview_.startSettling(task()) ? done() : answer(kNoCode);
  if (job == "view-trials") {
    if (!carvings_.result()) return answer(kNoResult);
    return textOf({{"ok", true}, {"tried", 0}, {"all", carvings_.startViewTrials().all()}});
  }
  assert(job == "engrave");
  return startEngrave(options, overridden);
}

std::string Engine::advanceJob(const std::string& job, const std::string& answers) {
  if (job == "spots") return advanceSpotSearch();
  if (job == "settling") return advanceSettling();
  if (job == "preparation") return advancePreparation(answers);
  if (job == "view-trials") return advanceViewTrials(answers);
  assert(job == "engrave");
  return advanceEngrave();
}

void Engine::cancelJob(const std::string& job) {
  if (job == "engrave")
    carvings_.cancel();
  else if (job == "spots" && offers_.isRunning())
    offers_.forget();
}

}  // namespace qrelief
