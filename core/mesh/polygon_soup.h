// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// What a model file says, before anything is trusted: positions in file units, triangles by index
/// (all indices valid), neither welded nor oriented.
struct PolygonSoup {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::string format;                 ///< "STL (binary)", "STL (ASCII)", "OBJ", "PLY", "OFF"
  std::vector<std::string> warnings;  ///< what the reader passed over, in words
};

}  // namespace qrelief
