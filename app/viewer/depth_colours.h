// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "depth/depth_field.h"
#include "viewer/display_mesh.h"

namespace qrelief {

struct EngraveResult;

/// Returns the depth of the last colour: 95 % of the pockets are no deeper. Rounded up to a tenth of a millimetre.
/// Single pockets can be several times as deep; a scale up to their depth would show all the others in one colour.
double depthColoursTopMm(const EngraveResult& result);

/// Returns the depth of every vertex of the display mesh, 0 … 1, for the viewer; 0: not carved. The floor of a pocket
/// has the depth of its submodule; a wall goes from the depth on one side to the depth on the other.
/// @param display  made from the result's mesh
std::vector<float> depthColours(const EngraveResult& result, const DisplayMesh& display);

}  // namespace qrelief
