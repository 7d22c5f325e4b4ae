// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/colour.h"
#include "mesh/mesh.h"
#include "verification/ink.h"
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

/// Returns the colours of the triangles: the ink's, the model's, or without these the body's of the ink.
/// @param ofModel  of the triangles of the model before carving; empty: it has none
std::vector<std::optional<Colour>> inkedColours(const InkedSurface& surface, const EngraveResult& result,
                                                std::span<const std::optional<Colour>> ofModel);

}  // namespace qrelief
