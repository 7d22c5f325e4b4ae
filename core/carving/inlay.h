// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "carving/lift.h"

namespace qrelief {

/// Makes the body that fills the pockets, for printing in a second colour. It consists of the surface over the pockets
/// and of their floors and walls, reversed. It shares every vertex of the pockets with the carved mesh, so the two fit
/// without gap or overlap, and its edges and vertices are just as regular (outline.h): a pocket's rim never meets
/// itself on the surface, because diagonal neighbours are kept apart.
///
/// Cost: O(arrangement).
/// @returns one closed, outward-facing shell for each connected pocket; empty if nothing is carved
Mesh inlayMesh(const Arrangement& arrangement, const LiftedSurface& surface);

}  // namespace qrelief
