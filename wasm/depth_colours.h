// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/engrave.h"
#include "wasm/display_mesh.h"

namespace qrelief {

/// How deep every vertex of a carved model lies, for the viewer.
struct DepthColours {
  std::vector<float> values;  ///< one per vertex of the display mesh, 0 … 1; 0: not carved
  double topMm = 0;           ///< the depth that is 1: the deepest, rounded up to a tenth
};

/// The floors of the pockets have the depth of their submodule, walls go from that of one side to that of the other.
/// @param display  made of the result's mesh
DepthColours depthColours(const EngraveResult& result, const DisplayMesh& display);

}  // namespace qrelief
