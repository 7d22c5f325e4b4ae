// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "viewer/display_mesh.h"

namespace qrelief {

/// A display mesh in which each triangle's vertices are all 0 or all 1.
struct TwoValues {
  DisplayMesh display;
  std::vector<float> values;  ///< 0 or 1, one per vertex
};

/// Tells the parts of a mesh with values of at least a threshold (1) from the others (0). Cuts the triangles that the
/// threshold crosses, where the interpolated values equal it.
///
/// Cost: O(V + T).
/// @param values  one per vertex
TwoValues twoValues(DisplayMesh display, std::span<const float> values, float threshold);

}  // namespace qrelief
