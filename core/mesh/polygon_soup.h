// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/colour.h"
#include "base/message.h"
#include "mesh/mesh.h"

namespace qrelief {

struct ThreeMfSource;  // io/three_mf/source.h

/// One of several objects in a file (3MF build items).
struct ModelPart {
  std::string name;               ///< as in the file, may be empty
  std::size_t firstTriangle = 0;  ///< its triangles end at the next part's first
};

/// One of several bodies that a file names (a mesh, component, volume or part of 3MF; a closed group of OBJ). Bodies
/// may touch and overlap.
struct Body {
  std::string name;            ///< as in the file, UTF-8; may be empty
  std::uint32_t part = 0;      ///< index of the object that it belongs to (PolygonSoup::parts)
  bool isShell = false;        ///< found as a closed shell, with its cavities, in a file that names no bodies
  std::uint32_t filament = 0;  ///< its number in the file's slicer, from 1; 0: the file says none
};

/// The unchecked content of a model file: positions in file units and triangles by index (all indices valid), neither
/// welded nor oriented.
struct PolygonSoup {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::string format;                           ///< "STL (binary)", "STL (ASCII)", "OBJ", "PLY", "OFF", "3MF"
  std::vector<Message> warnings;                ///< content that the parser ignored
  std::vector<ModelPart> parts;                 ///< ascending by first triangle; empty: the file holds one object only
  std::vector<Body> bodies;                     ///< empty: the file names no bodies
  std::vector<std::uint32_t> bodyOf;            ///< triangle → body; empty: the file names one body at most
  std::vector<std::optional<Colour>> colours;   ///< of the triangles; empty: the file says none
  std::optional<double> unitMm;                 ///< millimetres in a file unit, if the file states it (3MF)
  std::shared_ptr<const ThreeMfSource> source;  ///< of a 3MF file: to write its other contents again
};

}  // namespace qrelief
