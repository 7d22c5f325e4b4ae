// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "io/sniff_format.h"
#include "mesh/mesh.h"

namespace qrelief {

/// Red, green, blue; sRGB.
using Colour = std::array<std::uint8_t, 3>;

/// The part of an object that is printed in one material.
struct ModelBody {
  std::string name;              ///< UTF-8; may be empty
  Mesh mesh;                     ///< mm, at least one triangle
  std::optional<Colour> colour;  ///< if only other bodies have a colour, this one gets the first of theirs
};

/// One thing on the build plate: a body, or several that keep their relative positions and are printed together, such
/// as a carved model and the inlay that fills its pockets.
struct ModelObject {
  std::string name;  ///< UTF-8; may be empty
  std::vector<ModelBody> bodies;
  std::string description = {};  ///< UTF-8; written only to 3MF, as metadata of the item
  Vec3 offsetMm{0};              ///< moves the bodies to their place on the plate; 3MF only, else 0
};

struct WriteOptions {
  std::string title = "QRelief";  ///< title of the whole file, UTF-8
  bool ascii = false;             ///< writes STL as text; other formats have no choice
};

/// Writes objects as a file. Reading it gives the same 32-bit positions and the same triangles in the same order.
///
/// STL, OBJ and PLY hold one surface: the objects' triangles one after the other. 3MF keeps objects and bodies apart,
/// see write_3mf.h.
/// Cost: linear.
/// @returns BadUsage for a format that cannot be written, for text in a format without that choice, or for several
///          bodies in an object if the format cannot hold them
Result<std::vector<std::uint8_t>> writeModel(std::span<const ModelObject> objects, ModelFormat format,
                                             const WriteOptions& options = {});

/// Writes one object of one body.
Result<std::vector<std::uint8_t>> writeModel(const Mesh& mesh, ModelFormat format, const WriteOptions& options = {});

/// Splits a mesh by part; every part's vertices and triangles keep their order.
/// @param partOf  the part of each triangle; empty: all belong to part 0
/// @param names   the name of each part
/// @returns an object of one body for each part that has a triangle; positions on two parts go into both
std::vector<ModelObject> objectsOf(const Mesh& mesh, std::span<const std::uint32_t> partOf,
                                   std::span<const std::string> names);

}  // namespace qrelief
