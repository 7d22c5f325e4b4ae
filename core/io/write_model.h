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

/// What is printed in one material.
struct ModelBody {
  std::string name;              ///< UTF-8; may be empty
  Mesh mesh;                     ///< mm, at least one triangle
  std::optional<Colour> colour;  ///< none where others have one: the first colour that occurs
};

/// What stands on the plate as one thing: a body; or several that keep their places to each other and are printed
/// together, such as a carved model and the inlay that fills its pockets.
struct ModelObject {
  std::string name;  ///< UTF-8; may be empty
  std::vector<ModelBody> bodies;
  std::string description = {};  ///< UTF-8; 3MF has it as the item's metadata, other formats have no place for it
  Vec3 offsetMm{0};              ///< from where its bodies' coordinates are to where it stands; 3MF only, else 0
};

struct WriteOptions {
  std::string title = "QRelief";  ///< of the whole file, UTF-8
  bool ascii = false;             ///< STL as text; no other format has a choice
};

/// Writes objects as a file; reading it gives the same 32-bit positions and the same triangles in the same order.
///
/// STL, OBJ and PLY hold one surface: the objects' triangles one after the other. 3MF keeps objects and bodies apart,
/// see write_3mf.h.
/// Cost: linear.
/// @returns BadUsage for a format that cannot be written, text where there is no choice, or several bodies in an object
///          where the format has no place for them
Result<std::vector<std::uint8_t>> writeModel(std::span<const ModelObject> objects, ModelFormat format,
                                             const WriteOptions& options = {});

/// The same with one object of one body.
Result<std::vector<std::uint8_t>> writeModel(const Mesh& mesh, ModelFormat format, const WriteOptions& options = {});

/// Takes a mesh apart by the part each triangle belongs to; every part's vertices and triangles keep their order.
/// @param partOf  a part of each triangle; empty: all belong to part 0
/// @param names   of the parts
/// @returns an object of one body for each part that has a triangle; positions that parts share are in both
std::vector<ModelObject> objectsOf(const Mesh& mesh, std::span<const std::uint32_t> partOf,
                                   std::span<const std::string> names);

}  // namespace qrelief
