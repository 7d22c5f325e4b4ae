// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/code_estimate.h"

namespace qrelief {

/// A centre, and the code there.
struct NearbyCentre {
  SurfacePoint centre;
  CodeEstimate estimate;
};

/// Moves a picked centre to the nearest point where the code lies flat enough to be read by a phone held without care
/// (kForgivingTiltDeg), is large enough to print, and fits. A code picked next to an edge would be folded round it.
///
/// **Method.** If the code is bad at the picked centre, one map shows the surface connected with it as its facet's
/// normal sees it. Sums over the map give the bend of the surface under any square of it (projection/flatness.h) at
/// once. The nearest square that is flat enough is tried for sizes from that of the code at the picked centre
/// downwards; an estimate there decides. The search reaches half the code's edge and 3 mm. Cost: estimateCode(); for a
/// bad centre one rendering more, closestPoint(), and up to 3 further estimates.
/// @param leastMm  edge of the smallest symbol that can be printed; 0: no limit
/// @param expectedMm  see estimateCode()
/// @returns the picked centre if no better one is in reach; the errors of estimateCode() at the picked centre
Result<NearbyCentre> nearbyCentre(const EstimatedSurface& surface, const SurfacePoint& picked, int modules,
                                  const PlacementRequest& request, double leastMm,
                                  std::optional<double> expectedMm = {});

/// Returns true if the code fits, can be printed and can be read by a phone held without care.
bool isSteady(const CodeEstimate& code, int modules, const PlacementRequest& request, double leastMm);

}  // namespace qrelief
