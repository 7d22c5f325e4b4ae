// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "io/three_mf/rewrite_3mf.h"
#include "math/affine.h"
#include "mesh/polygon_soup.h"

namespace qrelief {

/// Pose of one item of a rewritten file (rewrite_3mf.h), mm. All other items stay as they are.
struct ItemPose {
  std::size_t item = 0;
  Affine pose;

  Affine of(const ThreeMfRun& run) const { return run.item == item ? pose : Affine(); }
};

/// Returns the pose of the item with the changed meshes: turned by the least angle, its middle above the same place, at
/// the same height. If it then covers the place of another item, it moves to the right until it is clear.
/// @param before  the file as read
/// @param up      the printer's vertical in the model's space, any length > 0
ItemPose turnedItem(const ThreeMfSource& source, std::span<const ChangedRun> changes, const PolygonSoup& before,
                    Vec3 up);

/// Returns true if a rewritten file has the new meshes in their pose and all other meshes as before. Cost: linear.
/// @param read, before  the rewritten file and the original, as read
bool holdsChanges(const PolygonSoup& read, const PolygonSoup& before, const ThreeMfSource& source,
                  std::span<const ChangedRun> changes, const ItemPose& turned);

}  // namespace qrelief
