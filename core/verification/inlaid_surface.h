// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

/// The outer surface of a model with a flush inlay.
struct InlaidSurface {
  Mesh mesh;
  bool hasBothBodies = false;  ///< true: the mesh has faces back to back
  Grid<std::uint8_t> inlaid;   ///< modules: 1 = has an inlay, or a pocket for one
};

/// Finds the outer surface of a model whose code is inlaid, from its mesh.
///
/// A file with both bodies has every face between them twice, back to back; these pairs are left out. Touching bodies
/// of the model have such pairs, too, but these reach deeper than an inlay, and stay. If the file has the model's body
/// alone, its pockets are closed: edges along a ray, as long as the pockets are deep, join a rim to a floor, and the
/// floor moves back along the rays to the rim.
///
/// Cost: O(n log n) in triangles.
/// @param mesh     welded first by equal position, also across bodies
/// @param modules  along the symbol's edge
/// @param depthMm  of the inlay along the rays, > 0
InlaidSurface inlaidSurface(const Mesh& mesh, const ProjectionFrame& frame, int modules, double symbolMm,
                            double depthMm);

}  // namespace qrelief
