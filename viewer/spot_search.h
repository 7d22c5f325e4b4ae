// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/result.h"
#include "render/geometry_pass.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// A place where a code would probably do well.
struct Spot {
  Vec3 position;  ///< near the surface, model space
  Vec3 normal;    ///< mean of the surface around it, unit
};

/// Places among what the camera sees for a first proposal, to be tried and moved by the user: the visible points around
/// which a square of the given size is flattest, most evenly directed and best covered by the model (what hides behind
/// contours counts as not covered); well apart, best first. That a code fits there has still to be checked.
///
/// Cost: one rendering of 160² texels and a few million operations.
/// @param sizeMm  edge of the square, > 0
/// @param most    number of spots
/// @returns none if the camera sees nothing that faces it
Result<std::vector<Spot>> proposeSpots(const GeometryPass& pass, const GpuMesh& mesh, const CameraView& camera,
                                       double sizeMm, std::size_t most);

}  // namespace qrelief
