// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "carving/footprint.h"

namespace qrelief {

/// Returns the least height of a triangle at which 32-bit floats can hold a shifted copy of it, mm: four units in the
/// last place of the largest coordinate. Rounding moves a vertex by at most √3/2 of a unit, so a triangle this high
/// keeps its orientation whichever way its corners move.
double lowestHeight(std::span<const Vec3f> positions);

/// Returns the height of a triangle over its longest edge, mm; 0 if its corners coincide.
double triangleHeight(Vec3f a, Vec3f b, Vec3f c);

/// Replaces needles: facets only a few floats wide, as CAD programs write them along edges with T-junctions. They are
/// harmless in place, but an outline across a needle, or a copy of it, would collapse. Flips the needle's longest edge:
/// the two facets there are replaced by two others with the same rim, and the surface moves by no more than the
/// needle's height. Marks these facets in `footprint.reshaped`.
///
/// Needs: facets, vertices, points, corners. Cost: O(footprint) where there are no needles.
void flipNeedles(Footprint& footprint, const Mesh& mesh);

}  // namespace qrelief
