// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "render/geometry_pass.h"

namespace qrelief {

/// A place where a code would probably do well.
struct FirstSpot {
  Vec3 position;  ///< near the surface, model space
  Vec3 normal;    ///< mean of the surface around it, unit
};

/// Places among what an eye sees for a first proposal, to be tried and moved by the user: the visible points around
/// which a square of the given size is flattest, most evenly directed and best covered by the model (what hides behind
/// contours counts as not covered); well apart, best first. That a code fits there has still to be checked.
///
/// Cost: one rendering of 160² texels and a few million operations.
/// @param view    where is looked from, and at what
/// @param widthMm  edge of the square that is looked at, on the plane of the view, > 0
/// @param sizeMm  edge of the square, > 0
/// @param most    number of spots
/// @returns none if the eye sees nothing that faces it
Result<std::vector<FirstSpot>> firstSpots(const GeometryPass& pass, const GpuMesh& mesh, const ProjectionFrame& view,
                                          double widthMm, double sizeMm, std::size_t most);

}  // namespace qrelief
