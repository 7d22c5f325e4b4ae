// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/write_model.h"

namespace qrelief {

/// A body and its numbers in a 3MF file.
struct NumberedBody {
  const ModelBody* body;
  std::string name;
  std::size_t id;
  std::size_t filament;       ///< from 1; its colour group has the same id
  std::size_t paintFilament;  ///< of the painted facets; 0 if there are none
};

struct NumberedObject {
  std::string name;
  std::size_t id;  ///< id of the mesh itself if the object has no components
  std::vector<NumberedBody> bodies;
  const ModelObject* object;
  bool hasComponents;
  bool isInOneMesh;  ///< true: all bodies share one mesh object; false: each body is a separate object
  std::string path;  ///< part file of the bodies, with a leading slash; empty: the root model
};

/// Places and numbers of everything in a 3MF file: one colour group for each filament from 1 on, then bodies and
/// objects, then the base materials. Ids are unique in the whole package, because slicers look some up without their
/// part.
struct Numbering {
  /// Of each filament. Where bodies have numbers of their own, filaments without a colour get one. Otherwise
  /// coloursOf(); empty if nothing has a colour.
  std::vector<Colour> colours;
  /// Names of the colours' materials: the first that a body or paint of the colour has, else "Filament 1" and so on.
  std::vector<std::string> materials;
  std::vector<NumberedObject> objects;
  std::size_t materialsId = 0;

  Numbering(std::span<const ModelObject> objectsToWrite, const WriteOptions& options);

  bool isColoured() const { return !colours.empty(); }
  bool hasPaint() const;
  bool hasPartFiles() const;

 private:
  std::size_t filamentOf(std::uint32_t number, const std::optional<Colour>& colour) const;

  bool hasNumbers_ = false;
};

}  // namespace qrelief
