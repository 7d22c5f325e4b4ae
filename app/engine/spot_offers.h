// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/placement_preview.h"
#include "pipeline/spot_search.h"

namespace qrelief {

/// The best spots on a model for the wanted code, and a colour map of the largest sizes, or of where a fixed size
/// fits.
class SpotOffers {
 public:
  /// Starts a search. Ends an earlier one.
  Status start(const PlacementTask& task);
  bool isRunning() const { return job_ != nullptr; }
  /// Does one bounded piece of work of the running search. An error ends the search, too.
  Result<Progress> advance();

  /// Returns the spots, best first; empty before a search is done.
  std::span<const Spot> spots() const { return spots_; }
  /// Returns the size of the symbol that is offered at a spot.
  double offeredMm(const Spot& spot) const;
  /// Returns the request of the search.
  const SpotSearchRequest& request() const { return request_; }
  /// Returns the symbol size that has the last colour: the largest one.
  double topMm() const { return topMm_; }
  /// Returns the size that was searched for; none: the largest one.
  std::optional<double> fixedMm() const;
  /// Returns the colour map, of the largest sizes or in two colours where the fixed size fits, which the first call
  /// makes; null before a search is done, and without a GL context.
  const std::shared_ptr<const GpuMesh>& sizesDisplay();

  void forget();

 private:
  void finish();

  SpotSearchRequest request_;
  std::shared_ptr<const EngravableModel> model_;
  std::unique_ptr<SpotSearchJob> job_;
  std::vector<Spot> spots_;
  double topMm_ = 0;
  std::shared_ptr<const SizeMap> map_;                // of the last search that was done, ...
  std::weak_ptr<const EngravableModel> mappedModel_;  // ... and its model
  std::shared_ptr<const GpuMesh> sizesDisplay_;
};

}  // namespace qrelief
