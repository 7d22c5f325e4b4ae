// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "mesh/clean.h"
#include "mesh/defects.h"
#include "mesh/fill_holes.h"
#include "mesh/orient.h"
#include "mesh/t_junctions.h"
#include "mesh/untangle.h"
#include "mesh/weld_near.h"

namespace qrelief {

/// Which repairs may be made. What a repair that is switched off would have mended is reported, and blocks if the model
/// is no solid without it.
struct RepairOptions {
  std::optional<double> weldToleranceMm = {};  ///< of open edges' vertices, ≥ 0; absent: kWeldFraction of the diagonal
  std::optional<double> maxHoleMm = {};  ///< diameter of the largest hole to be filled; absent: kHoleFraction of it
  bool weldNear = true;
  bool splitTJunctions = true;
  bool fillHoles = true;
  bool dropStray = true;  ///< triangles without area, or that are there twice
  bool orient = true;     ///< turn triangles and shells round
  bool untangle = true;   ///< move vertices to part crossing triangles

  static RepairOptions none() {
    RepairOptions options;
    options.weldNear = options.splitTJunctions = options.fillHoles = false;
    options.dropStray = options.orient = options.untangle = false;
    return options;
  }
};

/// A mesh after all repairs, what each did, and what is left.
struct Repaired {
  Mesh mesh;
  std::vector<std::uint32_t> origin;  ///< for each triangle, the one given that it comes from or lies beside
  Adjacency adjacency;
  double toleranceMm = 0, maxHoleMm = 0;  ///< the values that were used
  Cleaning cleaning;
  NearWelding welding;
  TJunctionSplit split;
  bool seamsCutShort = false;  ///< open edges lie in such heaps that not all of them were compared
  HoleFilling filling;
  Consistency consistency;
  Outwardness outwardness;
  Untangling untangling;
  Defects defects;  ///< what could not be mended

  bool closed() const { return defects.openEdges == 0 && defects.nonManifoldEdges == 0 && !consistency.oneSided; }
};

/// Drops stray triangles, welds and splits at open edges, turns neighbours to agree, fills holes, turns shells outwards
/// and parts crossing triangles, in this order; each where it is needed only. A step that would give an edge a third
/// triangle is not made.
///
/// Cost: O(T log T); on a sound mesh most of it the search for crossing triangles.
/// @param mesh            welded by equal position
/// @param partOfTriangle  vertices of different parts are not welded, unless they are equal; empty: one part
/// @returns an error only if the exact predicates fail
Result<Repaired> repairMesh(Mesh mesh, std::span<const std::uint32_t> partOfTriangle, const RepairOptions& options);

}  // namespace qrelief
