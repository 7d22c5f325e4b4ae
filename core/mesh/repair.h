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

/// Permitted repairs. A defect whose repair is switched off is reported; it blocks engraving if the model is not a
/// solid without the repair.
struct RepairOptions {
  std::optional<double> weldToleranceMm =
      {};  ///< for open edges, ≥ 0; absent: kWeldFraction of the diagonal, at most kMaxRepairMoveMm
  std::optional<double> maxHoleMm = {};  ///< largest diameter to fill; absent: kHoleFraction of the diagonal
  bool weldNear = true;
  bool splitTJunctions = true;
  bool fillHoles = true;
  bool dropStray = true;  ///< drop triangles without area and duplicates
  bool orient = true;     ///< reverse triangles and shells that face the wrong way
  bool untangle = true;   ///< move vertices to separate crossing triangles

  static RepairOptions none() {
    RepairOptions options;
    options.weldNear = options.splitTJunctions = options.fillHoles = false;
    options.dropStray = options.orient = options.untangle = false;
    return options;
  }
};

/// Pairs of triangles of different shells that cross or touch, as findCrossings() lists them up to its limit.
struct Overlaps {
  std::size_t pairs = 0;
  bool atLeast = false;     ///< the list stopped at its limit
  bool tooCrowded = false;  ///< too many pairs to examine, so nothing was counted
  Vec3 at{0};               ///< where the first pair meets

  bool any() const { return pairs > 0 || tooCrowded; }
};

/// A mesh after all repairs, the report of each repair, and the remaining defects.
struct Repaired {
  Mesh mesh;
  std::vector<std::uint32_t> origin;  ///< for each triangle, the original one that it comes from or adjoins
  Adjacency adjacency;
  double toleranceMm = 0, maxHoleMm = 0;  ///< the values used
  Cleaning cleaning;
  NearWelding welding;
  TJunctionSplit split;
  bool seamsCutShort = false;  ///< too many open edges near each other: not all were compared
  HoleFilling filling;
  Consistency consistency;
  Outwardness outwardness;
  Untangling untangling;
  Overlaps overlaps;
  /// Pairs of findCrossings(), ascending; absent: open, too crowded, or at least kMaxCrossingsListed.
  std::optional<std::vector<TrianglePair>> crossings;
  Defects defects;  ///< defects that remain

  bool closed() const { return defects.openEdges == 0 && defects.nonManifoldEdges == 0 && !consistency.oneSided; }
};

/// Drops stray triangles, welds and splits at open edges, makes neighbours face the same side, fills holes, turns
/// shells outwards and separates crossing triangles, in this order and only where needed. Skips any step that would
/// give an edge a third triangle.
///
/// Cost: O(T log T); for a sound mesh mostly the search for crossing triangles.
/// Each body is repaired by itself: bodies and their shells may touch and overlap.
/// @param mesh            welded by equal position within each body; its `bodyOf` is not used
/// @param bodyOfTriangle  empty: one body
/// @returns an error only if the exact predicates fail
Result<Repaired> repairMesh(Mesh mesh, std::span<const std::uint32_t> bodyOfTriangle, const RepairOptions& options);

}  // namespace qrelief
