// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/colour.h"
#include "io/read_model.h"
#include "io/three_mf/xml_reader.h"
#include "math/affine.h"

namespace qrelief {

/// Reads the value of a transform attribute. @returns BadInput, also for a transform that flattens
Result<Affine> transformFrom(std::string_view text);

/// An object with a transform: a component of another object, or an item of the build.
struct ThreeMfInstance {
  std::string path;  ///< the model part that holds the object; empty: the same part
  std::uint32_t object = 0;
  Affine transform;
  std::string partNumber;  ///< build items only
  bool isPrinted = true;   ///< false for build items that a slicer keeps without printing them
};

/// A 3MF object: a mesh or a list of components.
struct ThreeMfObject {
  std::string name, type = "model";
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;             ///< all indices valid
  std::vector<std::optional<Colour>> colours;  ///< of the triangles; empty: none has one
  std::vector<std::uint8_t> paint;             ///< filaments of the triangles, 0 for none; empty: none is painted
  std::vector<ThreeMfInstance> components;
  bool isPainted = false;   ///< some facets are painted (kFacetPaints)
  std::string curaMesh;     ///< the setting that makes it a helper mesh of Cura: "support_mesh"; else empty
  bool hasSlices = false;   ///< there is a stack of slices, too
  bool isInSlices = false;  ///< the shape is that stack; the mesh is a rough stand-in
  bool isInBeams = false;   ///< the shape is a lattice of beams between the vertices
};

/// A model part of a package.
struct ThreeMfModel {
  double unitMm = 1;
  std::map<std::uint32_t, ThreeMfObject> objects;
  bool hasBuild = false;  ///< true if there is a `<build>`; only the start part needs one
  std::vector<ThreeMfInstance> items;
};

/// Reads a model part [3MF core specification 1.3, production extension 1.1; slice extension 1.0.2 and beam lattice
/// extension 1.2 only to find meshes that are stand-ins; Cura's metadata]. Reads geometry, colours
/// (base materials and colour groups) and paint; skips textures and metadata, for example.
/// @param part    its name, for messages
/// @param limits  at most maxTriangles triangles, three times as many vertices, and 100 000 objects, components and
///                items
/// @returns BadInput naming part, line and object; also if the part requires an extension that changes the geometry
Result<ThreeMfModel> readThreeMfModel(ZipStream& stream, const std::string& part, const ReadLimits& limits);

}  // namespace qrelief
