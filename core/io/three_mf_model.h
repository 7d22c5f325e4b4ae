// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/read_model.h"
#include "io/xml_reader.h"

namespace qrelief {

/// Rows of a 3MF transform: a point p becomes p.x·x + p.y·y + p.z·z + origin.
struct Affine {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{0};

  Vec3 operator()(Vec3 p) const { return p.x * x + p.y * y + p.z * z + origin; }
  /// First `inner`, then this.
  Affine after(const Affine& inner) const;
  double determinant() const;
};

/// An object put somewhere: a component of another object, or an item of the build.
struct ThreeMfInstance {
  std::string path;  ///< of the model part that holds the object; empty: the same part
  std::uint32_t object = 0;
  Affine transform;
  std::string partNumber;  ///< of an item
};

/// One object: a mesh, or components.
struct ThreeMfObject {
  std::string name, type = "model";
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;  ///< all indices valid
  std::vector<ThreeMfInstance> components;
  bool isInSlices = false;  ///< a stack of slices has the shape; the mesh is a rough stand-in
};

/// One model part of a package.
struct ThreeMfModel {
  double unitMm = 1;
  std::map<std::uint32_t, ThreeMfObject> objects;
  bool hasBuild = false;  ///< whether there is a <build>; parts beside the start part need none
  std::vector<ThreeMfInstance> items;
};

/// Reads a model part [3MF core specification 1.3, production extension 1.1, slice extension 1.0.2 as far as it says
/// which meshes are stand-ins]. Skips everything but geometry, such as colours, textures and metadata.
/// @param part    its name, for messages
/// @param limits  at most maxTriangles triangles, three times as many vertices, and 100 000 objects, components and
///                items
/// @returns BadInput naming part, line and object; also if the part requires an extension that changes the geometry
Result<ThreeMfModel> readThreeMfModel(ZipStream& stream, const std::string& part, const ReadLimits& limits);

}  // namespace qrelief
