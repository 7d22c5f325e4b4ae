// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "mesh/mesh.h"

namespace qrelief {

struct ThreeMfSource;  // io/three_mf_source.h

/// One of several objects in a file (3MF build items).
struct ModelPart {
  std::string name;               ///< as in the file, may be empty
  std::size_t firstTriangle = 0;  ///< its triangles end at the next part's first
};

/// The unchecked content of a model file: positions in file units and triangles by index (all indices valid), neither
/// welded nor oriented.
struct PolygonSoup {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::string format;                           ///< "STL (binary)", "STL (ASCII)", "OBJ", "PLY", "OFF", "3MF"
  std::vector<Message> warnings;                ///< content that the parser ignored
  std::vector<ModelPart> parts;                 ///< ascending by first triangle; empty: the file holds one object only
  std::optional<double> unitMm;                 ///< millimetres in a file unit, if the file states it (3MF)
  std::shared_ptr<const ThreeMfSource> source;  ///< of a 3MF file: to write its other contents again
};

}  // namespace qrelief
