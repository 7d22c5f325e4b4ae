// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/placed_code.h"
#include "pipeline/spot_search.h"

namespace qrelief {

/// The best spots of a model for the wanted code, and the largest sizes as colours on it.
class SpotOffers {
 public:
  /// Looks for them; ends an earlier search.
  Status start(const PlacementTask& task);
  bool isRunning() const { return job_ != nullptr; }
  /// One bounded piece of work, while a search is running; ends it after an error, too.
  Result<Progress> advance();

  /// Best first; empty before a search is done.
  std::span<const OfferedSpot> spots() const { return spots_; }
  /// Of the symbol that is offered at a spot.
  double offeredMm(const OfferedSpot& spot) const;
  /// What was searched with.
  const PlacementRequest& request() const { return request_.placement; }
  /// Symbol size that has the last colour.
  double topMm() const { return topMm_; }
  /// Null before a search is done.
  const std::shared_ptr<const GpuMesh>& sizesDisplay() const { return sizesDisplay_; }

  void forget();

 private:
  void finish();

  SpotSearchRequest request_;
  std::shared_ptr<const EngravableModel> model_;
  std::unique_ptr<SpotSearchJob> job_;
  std::vector<OfferedSpot> spots_;
  double topMm_ = 0;
  std::shared_ptr<const GpuMesh> sizesDisplay_;
};

}  // namespace qrelief
