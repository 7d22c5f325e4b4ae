// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "embedding/footprint.h"

namespace qrelief {

/// Lowest height that a triangle may have if 32-bit floats shall hold a shifted copy of it, mm: four units in the last
/// place of the largest coordinate. Rounding moves a vertex by at most √3/2 of a unit, so a triangle this high keeps
/// its orientation whichever way its corners go.
double lowestHeight(std::span<const Vec3f> positions);

/// Height of a triangle over its longest edge, mm; 0 if its corners coincide.
double triangleHeight(Vec3f a, Vec3f b, Vec3f c);

/// Replaces facets that are needles, a few floats wide, as CAD programs write them along edges with T-junctions. They
/// are harmless where they are, but an outline across one, or a copy of one, would collapse. The needle's longest edge
/// is flipped: its two facets become others with the same rim, and the surface moves by no more than the needle's
/// height. Facets that take part are marked in `footprint.reshaped`.
///
/// Needs: facets, vertices, points, corners. Cost: O(footprint) where there are no needles.
void flipNeedles(Footprint& footprint, const Mesh& mesh);

}  // namespace qrelief
