// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "base/result.h"
#include "mesh/ray.h"
#include "projection/eye_reach.h"
#include "projection/placement_request.h"

namespace qrelief {

/// The model that is estimated on; kept by reference.
struct EstimatedSurface {
  const Mesh& mesh;
  const SurfaceLook& look;
  double diagonalMm;  ///< of its bounding box
};

/// About where a code would lie, and how large.
struct CodeEstimate {
  ProjectionFrame frame;  ///< turned as asked for
  std::shared_ptr<const EyeReach> reach;
  double symbolMm = 0;
  double guaranteedMm = 0;     ///< that fits at every rotation, as far as the request lets it grow
  double rotationDeg = 0;      ///< from where upHint points
  double missingFraction = 0;  ///< of the square that must fit, 0 … 1: overhangs, or is hidden
};

/// What PlacementSearch would find, quickly enough for a code that follows the pointer: the same direction method with
/// few and small maps, the size from one map (eye_reach.h) instead of the exact silhouette.
/// Cost: 3 to 6 small looks; 2 of a part of the model if the size is about the one expected.
/// @param centre   on the model
/// @param modules  of the symbol along its edge
/// @param request  its centre does not count
/// @param expectedMm  a size that will about be found, as where the pointer has just been: less is then looked at
Result<CodeEstimate> estimateCode(const EstimatedSurface& surface, const SurfacePoint& centre, int modules,
                                  const PlacementRequest& request, std::optional<double> expectedMm = {});

}  // namespace qrelief
