// SPDX-License-Identifier: GPL-3.0-or-later
// Where the engine puts the code, and the spots that it offers.
#include <algorithm>
#include <cmath>

#include "engine/answers.h"
#include "engine/engine.h"
#include "projection/bend.h"
#include "viewer/heat_mesh.h"

namespace qrelief {
namespace {

constexpr double kLegendStepMm = 5;  // the legend of the sizes ends at a multiple of it

}  // namespace

Status Engine::placeSymbol() {
  if (!model_) return tl::unexpected(kNoModel);
  if (!centre_)
    return fail(ErrorKind::BadUsage, "no place has been chosen", "click on the model where the code should go");
  const EngravableModel& model = *model_->engravable;
  if (const Status engravable = model.prepared.engravable(); !engravable) return engravable;
  if (!symbol_) return tl::unexpected(symbol_.error());
  const EngraveRequest request = completeRequest();
  if (const Status found = findPlacement(request); !found) {
    const auto surface = closestPoint(model.prepared.mesh, *centre_);
    if (auto about = surface ? estimatedCode(*surface) : tl::unexpected(found.error())) code_ = std::move(*about);
    return found;
  }
  auto code = exactCode(*symbol_, request, found_->search.placement());
  if (!code) return tl::unexpected(code.error());
  placement_ = found_->search.placement();
  code_ = std::move(*code);
  return {};
}

Status Engine::findPlacement(const EngraveRequest& request) {
  if (foundPlacement(request)) return {};
  found_.reset();
  prepared_.reset();
  const PlacementRequest wanted = searchedPlacement(request, symbol_->size);
  const EngravableModel& model = *model_->engravable;
  PlacementSearch search(model.prepared, model.gpu, *pass_, symbol_->size, wanted);
  for (bool done = false; !done;) {
    const Result<bool> found = search.step();
    if (!found) return tl::unexpected(found.error());
    done = *found;
  }
  found_ = {wanted, symbol_->size, std::move(search)};
  return {};
}

const PlacementSearch* Engine::foundPlacement(const EngraveRequest& request) const {
  const bool isThat = found_ && symbol_ && found_->modules == symbol_->size &&
                      found_->request == searchedPlacement(request, symbol_->size);
  return isThat ? &found_->search : nullptr;
}

std::string Engine::placement() {
  forgetPlacement();
  const Status placed = placeSymbol();
  updateView();
  return placed ? describePlacement() : answer(placed.error());
}

std::string Engine::describePlacement() const {
  return textOf({{"ok", true},
                 {"placement",
                  {{"centre", jsonOf(placement_->frame.centre)},
                   {"normal", jsonOf(placement_->frame.normal)},
                   {"up", jsonOf(placement_->frame.up)},
                   {"symbolMm", placement_->symbolMm},
                   {"moduleMm", placement_->moduleMm},
                   {"guaranteedMm", placement_->guaranteedMm},
                   {"aimToleranceDeg", aimToleranceDeg(placement_->bendMm, placement_->moduleMm)},
                   {"rotationDeg", placement_->rotationDeg},
                   {"version", symbol_->version},
                   {"modules", symbol_->size}}}});
}

std::string Engine::startPlacing() {
  forgetSpots();
  updateView();
  if (!model_) return answer(kNoModel);
  if (!symbol_) return answer(symbol_.error());
  placingRequest_ = {};
  placingRequest_.placement = searchedPlacement(request_, symbol_->size);
  placingRequest_.placement.upHint = camera_.skyward();
  placingRequest_.modules = symbol_->size;
  placingRequest_.minWallMm = request_.minWallMm;
  auto job = PlaceJob::create(model_->engravable, placingRequest_);
  if (!job) return answer(job.error());
  placing_ = std::move(*job);
  return done();
}

std::string Engine::advancePlacing() {
  if (!placing_) return answer(ErrorKind::BadUsage, "no search for spots is running", "");
  const Result<Progress> progress = placing_->advance();
  if (!progress) {
    forgetSpots();
    return answer(progress.error());
  }
  if (progress->done) finishPlacing();
  return answer(*progress);
}

void Engine::finishPlacing() {
  const PlaceResult found = placing_->takeResult();
  placing_.reset();
  spots_ = found.spots;
  // The map knows squares with the quiet zone, the legend the symbol in them.
  const double outer = placingRequest_.outerFactor();
  const double largest = static_cast<double>(*std::max_element(found.map.sizeMm.begin(), found.map.sizeMm.end()));
  topMm_ = std::max(kLegendStepMm, std::ceil(largest / outer / kLegendStepMm) * kLegendStepMm);
  sizesDisplay_ =
      std::make_shared<const GpuMesh>(heatMesh(model_->engravable->prepared.mesh, found.map, topMm_ * outer));
  showSizes(true);
}

void Engine::cancelPlacing() {
  if (placing_) forgetSpots();
}

std::string Engine::spots() const {
  Json spots = Json::array();
  for (const OfferedSpot& spot : spots_)
    spots.push_back(
        {{"centre", jsonOf(spot.centreMm)},
         {"aimToleranceDeg", spot.aimToleranceDeg},
         {"sizeMm", placingRequest_.placement.sizeMode == SizeMode::Free ? spot.symbolMm : spot.largestMm}});
  return textOf({{"ok", true}, {"spots", spots}, {"topMm", topMm_}});
}

std::string Engine::chooseSpot(std::size_t index) {
  if (index >= spots_.size()) return answer(ErrorKind::BadUsage, "there is no such spot", "");
  const OfferedSpot& spot = spots_[index];
  const std::string chosen = setCentre(spot.centreMm.x, spot.centreMm.y, spot.centreMm.z);
  if (spot.needsDirection) spotDirection_ = spot.direction;
  return chosen;
}

void Engine::showSizes(bool shown) {
  showSizes_ = shown && sizesDisplay_;
  if (showSizes_) showCarved_ = false;
  updateView();
}

void Engine::forgetSpots() {
  placing_.reset();
  spots_.clear();
  sizesDisplay_.reset();
  showSizes_ = false;
}

}  // namespace qrelief
