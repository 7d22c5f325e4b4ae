// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/engrave.h"
#include "viewer/display_mesh.h"

namespace qrelief {

/// Depth of the last colour: 95 % of the pockets are no deeper. Rounded up to a tenth of a millimetre. Single pockets
/// can be several times as deep, and a scale up to them would show all others in one colour.
double depthColoursTopMm(const DepthField& depths);

/// How deep every vertex of the display mesh lies, 0 … 1, for the viewer; 0: not carved. The floors of the pockets have
/// the depth of their submodule, walls go from that of one side to that of the other.
/// @param display  made of the result's mesh
std::vector<float> depthColours(const EngraveResult& result, const DisplayMesh& display);

}  // namespace qrelief
