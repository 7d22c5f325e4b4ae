// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/spot_offers.h"

#include <algorithm>
#include <cmath>

#include "engine/placement_preview.h"
#include "projection/spot_candidates.h"
#include "viewer/heat_mesh.h"

namespace qrelief {
namespace {

constexpr double kLeastTopMm = 1;  // of the legend of the sizes, where no code fits anywhere

}  // namespace

Status SpotOffers::start(const PlacementTask& task) {
  forget();
  request_ = spotSearchFor(task.wanted.settings(), *task.wanted.symbol());
  request_.placement.upHint = task.wanted.upHint(task.sceneUp);
  model_ = task.model.engravable;
  request_.known = mappedModel_.lock() == model_ ? map_ : nullptr;
  auto job = SpotSearchJob::create(model_, request_);
  QRELIEF_TRY(job);
  job_ = std::move(*job);
  return {};
}

Result<Progress> SpotOffers::advance() {
  const Result<Progress> progress = job_->advance();
  if (!progress) forget();
  if (progress && progress->done) finish();
  return progress;
}

void SpotOffers::finish() {
  SpotSearchResult result = job_->takeResult();
  job_.reset();
  spots_ = std::move(result.spots);
  map_ = std::move(result.map);
  mappedModel_ = model_;
  // The map has squares with the quiet zone, the legend the symbol in them.
  const double outer = request_.outerFactor();
  const double largest = static_cast<double>(*std::max_element(map_->sizeMm.begin(), map_->sizeMm.end()));
  topMm_ = std::max(kLeastTopMm, largest / outer);
  // The map is coarse: a search may find a larger code than it has.
  for (const Spot& spot : spots_) topMm_ = std::max(topMm_, offeredMm(spot));
}

std::optional<double> SpotOffers::fixedMm() const {
  const PlacementRequest& asked = request_.placement;
  return asked.sizeMode == SizeMode::Fixed ? std::optional(asked.sizeMm) : std::nullopt;
}

const std::shared_ptr<const GpuMesh>& SpotOffers::sizesDisplay() {
  if (sizesDisplay_ || job_ || !model_ || !model_->gpu) return sizesDisplay_;
  const double outer = request_.outerFactor();
  if (const auto fixed = fixedMm()) {
    sizesDisplay_ = std::make_shared<const GpuMesh>(fitMesh(model_->prepared.mesh, *map_, *fixed * outer));
    return sizesDisplay_;
  }
  SizeMap counted = *map_;
  counted.sizeMm = countedSizes(counted, topMm_ * outer);
  sizesDisplay_ = std::make_shared<const GpuMesh>(
      heatMesh(model_->prepared.mesh, counted, request_.leastPrintableMm * outer, topMm_ * outer));
  return sizesDisplay_;
}

double SpotOffers::offeredMm(const Spot& spot) const { return fixedMm() ? spot.largestMm : spot.symbolMm; }

void SpotOffers::forget() {
  job_.reset();
  model_.reset();
  spots_.clear();
  sizesDisplay_.reset();
}

}  // namespace qrelief
