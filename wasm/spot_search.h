// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/result.h"
#include "render/geometry_pass.h"
#include "wasm/orbit_camera.h"

namespace qrelief {

/// A place where a code would probably do well, among what the camera sees: a first proposal, to be tried and moved by
/// the user. It is the visible point around which a square of the given size is flattest, most evenly directed and best
/// covered by the model; what hides behind contours counts as not covered.
///
/// Cost: one rendering of 160² texels and a few million operations.
/// @param sizeMm  edge of the square, > 0
/// @returns a point near the surface; none if the camera sees nothing that faces it
Result<std::optional<Vec3>> proposeSpot(const GeometryPass& pass, const GpuMesh& mesh, const CameraView& camera,
                                        double sizeMm);

}  // namespace qrelief
