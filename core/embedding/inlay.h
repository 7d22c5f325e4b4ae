// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "embedding/lift.h"

namespace qrelief {

/// The body that fills the pockets, for printing in a second colour: the surface over the pockets, their floors and
/// their walls, both turned round. It shares every vertex of the pockets with the carved mesh, so the two fit without
/// gap or overlap, and every edge and vertex is as regular as there (outline.h): on the surface a pocket's rim meets
/// itself nowhere, because diagonal neighbours are kept apart.
///
/// Cost: O(arrangement).
/// @returns one closed shell for each connected pocket, outward; empty if nothing is carved
Mesh inlayMesh(const Arrangement& arrangement, const LiftedSurface& surface);

}  // namespace qrelief
