// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh.h"

namespace qrelief {

/// Returns true if the model stands on a flat base at its lowest y, and has none at its lowest z, where a model for
/// printing has it: then y probably points up in its file. A base is flat if a fifth of the box's side is in one plane.
/// Cost: linear.
bool standsOnY(const Mesh& mesh);

}  // namespace qrelief
