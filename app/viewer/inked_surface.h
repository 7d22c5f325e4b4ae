// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "verification/ink.h"
#include "viewer/display_mesh.h"
#include "viewer/viewer.h"

namespace qrelief {

struct EngraveResult;

/// Returns the colours that show two materials. The default ink's white looks as bright as a model without ink.
SurfaceColours coloursOf(const Ink& ink);

/// Outside of a code in colour.
struct InkedSurface {
  Mesh mesh;                ///< begins with the kept triangles of the result
  std::vector<bool> isInk;  ///< per triangle
};

/// Returns the outside of a carved model with its painted facets or its inlay. Leaves out the facets in which an inlay
/// and the model touch.
///
/// Cost: O(n log n) for n new triangles.
InkedSurface inkedSurface(const EngraveResult& result);

/// Returns a value for every vertex, 1 for ink and 0 for the body. Vertices that triangles of both share exist twice
/// afterwards.
/// @param isInk  per triangle of the display mesh
std::vector<float> splitAtInk(DisplayMesh& display, const std::vector<bool>& isInk);

}  // namespace qrelief
