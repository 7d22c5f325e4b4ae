// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

/// Modules around the symbol whose light counts, too: a shadow in the quiet zone hides the symbol's border.
inline constexpr int kLitRingModules = 2;

/// How unevenly the sky lights the surface on which a code is to stand, before anything is carved: how much less light
/// its modules receive than the brightest module up to four away. The 98th percentile, 0 … 1.
///
/// Readers compare a module with its neighbourhood. Folds and ridges of the model cast shadows of their own, which no
/// depth of the pockets makes up for.
///
/// Cost: O(triangles); 10 ms for 70,000 triangles.
/// @param ring  modules around the symbol that count, ≥ 0
double unevenLight(const Mesh& mesh, const ProjectionFrame& frame, double symbolMm, int modules,
                   int ring = kLitRingModules);

/// Beyond this light is uneven: 6 of 14 such spots read and printed well, 66 of 67 others (docs/decisions/0041).
inline constexpr double kMostUnevenLight = 0.055;

}  // namespace qrelief
