// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "pipeline/placement.h"
#include "pipeline/spot_search.h"

namespace qrelief {

/// Returns the size requested, or the limit of a size to be found, mm.
double wantedMm(const SpotSearchRequest& request);

/// Test of one candidate as in engraving: direction, exact silhouette, slope and wall. If the code does not fit from
/// the direction that the request's method finds, it tries the direction of the map.
///
/// Trials of one model may run at the same time if the model's renderer is its `raster`.
class SpotTrial {
 public:
  /// @param model, request, map  kept by reference
  /// @param findsLargest         true: for the largest code, whatever size is requested
  SpotTrial(const EngravableModel& model, const SpotSearchRequest& request, const SizeMap& map,
            const SpotCandidate& candidate, bool findsLargest);

  /// Does one rendering or one silhouette; not to be called again after an error.
  /// @returns true when done; any error but NoSolution, which means that the spot does not take the code
  Result<bool> step();

  // Results, valid once it is done.
  const std::optional<Spot>& spot() const { return spot_; }  ///< none: the candidate does not take the code
  std::size_t tries() const { return tries_; }               ///< number of directions tried
  /// Returns the thickness of a wall too thin for the pockets, from the direction of the request's method.
  std::optional<double> thinWallMm() const { return thinWallMm_; }
  /// Returns true if crossing triangles kept the code away, or one of the wanted size.
  bool meetsCrossings() const { return meetsCrossings_; }

 private:
  void beginTry();
  bool endTry();
  Result<bool> judge(const Placement& placement);

  const EngravableModel* model_;
  const SpotSearchRequest* request_;
  const SizeMap* map_;
  SpotCandidate candidate_;
  bool findsLargest_;
  bool withDirection_ = false;  // true during the second try
  std::size_t tries_ = 0;
  std::optional<PlacementSearch> search_;
  Vec3 centreFileUnits_{0};
  std::optional<Vec3> direction_;  // none: found by the request's method
  std::optional<Spot> spot_;
  std::optional<double> thinWallMm_;
  bool meetsCrossings_ = false;
};

}  // namespace qrelief
