// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "base/result.h"
#include "mesh/ray.h"
#include "projection/placement_request.h"
#include "projection/visibility_map.h"

namespace qrelief {

/// The model under the code; kept by reference.
struct EstimatedSurface {
  const Mesh& mesh;
  const SurfaceRenderer& renderer;
  double diagonalMm;  ///< diagonal of the bounding box
};

/// An approximate placement of a code.
struct CodeEstimate {
  ProjectionFrame frame;  ///< turned by the requested rotation
  std::shared_ptr<const VisibilityMap> reach;
  double symbolMm = 0;
  double guaranteedMm = 0;     ///< size that fits at every rotation, at most the requested size or limit
  double rotationDeg = 0;      ///< from the direction of upHint
  double bendMm = 0;           ///< bend of the surface under the symbol, see projection/flatness.h
  double missingFraction = 0;  ///< fraction of the required square that overhangs or is hidden, 0 … 1
};

/// Estimates the answer of PlacementSearch, fast enough for a code that follows the pointer. It uses the same direction
/// method with few and small maps, and takes the size from one map (visibility_map.h) instead of the exact silhouette.
/// Cost: 3 to 6 small renderings; 2 renderings of a part of the model if the size is close to the expected one.
/// @param centre   on the model
/// @param modules  along the symbol's edge
/// @param request  its centre is ignored
/// @param expectedMm  approximate size, as found where the pointer was just before; it saves renderings
Result<CodeEstimate> estimateCode(const EstimatedSurface& surface, const SurfacePoint& centre, int modules,
                                  const PlacementRequest& request, std::optional<double> expectedMm = {});

}  // namespace qrelief
