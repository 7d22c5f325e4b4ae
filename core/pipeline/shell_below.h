// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "pipeline/placement.h"

namespace qrelief {

/// Finds a shell of the model that begins within the material under a code, or touches its far side. Slicers take
/// overlapping shells for one solid, but a code is carved into one of them: its pockets leave a wall before the far
/// side, and the other shell fills what they open of it.
///
/// Follows rays from the eye through 5 × 5 places of the symbol. Within one shell a ray leaves the material before it
/// enters any. Cost: O(T) for each ray.
/// @param reachMm  along the rays, from the surface, > 0
/// @returns the least distance from the surface, mm along the rays; none: no such shell is within reach
std::optional<double> shellBelowMm(const Mesh& mesh, const Placement& placement, double reachMm);

/// Returns true if another body has its surface in the same place under most of a code, such as a copy that was not
/// moved. It would fill the pockets. Follows the same rays. Cost: O(T), and O(facets
/// seen about the code) for each ray.
bool hasTwinSurface(const Mesh& mesh, const Placement& placement);

}  // namespace qrelief
