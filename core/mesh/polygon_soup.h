// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "mesh/mesh.h"

namespace qrelief {

/// One object of a file that holds several (3MF build items).
struct ModelPart {
  std::string name;               ///< as the file has it, may be empty
  std::size_t firstTriangle = 0;  ///< its triangles go on to the next part's first
};

/// What a model file says, before anything is trusted: positions in file units, triangles by index
/// (all indices valid), neither welded nor oriented.
struct PolygonSoup {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::string format;             ///< "STL (binary)", "STL (ASCII)", "OBJ", "PLY", "OFF"
  std::vector<Message> warnings;  ///< what the reader passed over
  std::vector<ModelPart> parts;   ///< ascending by first triangle; empty: the file knows one object only
  std::optional<double> unitMm;   ///< millimetres in a file unit, where the file says so (3MF)
};

}  // namespace qrelief
