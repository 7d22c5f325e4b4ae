// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "math/frame.h"
#include "render/surface_renderer.h"

namespace qrelief {

/// A promising place for a code.
struct OrientedPoint {
  Vec3 position;  ///< near the surface, model space
  Vec3 normal;    ///< mean normal of the surface around it, unit
};

/// Finds places for a first proposal, which the user then tries and moves. They are the visible points whose
/// surrounding square is flattest, most evenly oriented and best covered by the model; parts hidden behind contours
/// count as not covered. The spots are well apart, best first. The caller still has to check that a code fits.
///
/// Cost: one rendering of 160² texels and a few million operations.
/// @param view    the eye and the point it looks at
/// @param widthMm  edge of the visible square, on the plane of the view, > 0
/// @param sizeMm  edge of the rated square, > 0
/// @param most    limit on the number of spots
/// @returns an empty list if the eye sees no surface that faces it
Result<std::vector<OrientedPoint>> firstSpots(const SurfaceRenderer& surface, const ProjectionFrame& view,
                                              double widthMm, double sizeMm, std::size_t most);

}  // namespace qrelief
