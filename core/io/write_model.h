// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/colour.h"
#include "base/result.h"
#include "io/sniff_format.h"
#include "mesh/mesh.h"

namespace qrelief {

/// Facets of a body in the colour of another filament.
struct FacetPaint {
  Colour colour;
  std::vector<std::uint32_t> triangles;  ///< indices into the body's triangles, ascending, each once
  std::string material = {};             ///< name of the colour's material, UTF-8; only in 3MF for any slicer
  std::uint32_t filament = 0;            ///< as in ModelBody
};

/// The part of an object that is printed in one material, except for its painted facets.
struct ModelBody {
  std::string name;                      ///< UTF-8; may be empty
  Mesh mesh;                             ///< mm, at least one triangle
  std::optional<Colour> colour;          ///< if only other bodies have a colour, this one gets the first of theirs
  std::optional<FacetPaint> paint = {};  ///< needs a colour of the body, too; only 3MF and OBJ can hold it
  std::string material = {};             ///< name of the colour's material, UTF-8; only in 3MF for any slicer
  std::uint32_t filament = 0;  ///< its number, from 1; 0: by the colour, or 1 if others have numbers; 3MF only
};

/// One thing on the build plate: a body, or several that keep their relative positions and are printed together, such
/// as a carved model and the inlay that fills its pockets.
struct ModelObject {
  std::string name;  ///< UTF-8; may be empty
  std::vector<ModelBody> bodies;
  std::string description = {};  ///< UTF-8; written only to 3MF, as metadata of the item
  Vec3 offsetMm{0};              ///< moves the bodies to their place on the plate, once turned; 3MF only, else 0
  Vec3 up{0, 0, 1};              ///< the printer's vertical in the bodies' space, any length > 0; 3MF only, else +z
};

/// The program that will open a 3MF file. Each looks for filaments in other places (write_3mf.h).
enum class Slicer { Any, PrusaSlicer, OrcaSlicer, BambuStudio };

struct WriteOptions {
  std::string title = "QRelief";  ///< title of the whole file, UTF-8
  bool ascii = false;             ///< writes STL as text; other formats have no choice
  Slicer slicer = Slicer::Any;    ///< 3MF only
  bool palette = false;           ///< lists the filaments' colours in the name of Bambu Studio (write_3mf.h)
  std::string materialFile = {};  ///< OBJ only: the file with the colours (write_obj.h); empty: none
};

/// Writes objects as a file. Reading it gives the same 32-bit positions and the same triangles in the same order.
///
/// STL and PLY hold one surface: the objects' triangles one after the other. OBJ has an object for each body, and 3MF
/// keeps objects and bodies apart (write_3mf.h). write_files.h writes several files.
/// Cost: linear.
/// @returns BadUsage for a format that cannot be written, for options that the format does not have (`ascii`,
///          `palette`), or for several bodies in an object or painted facets if the format cannot hold them
Result<std::vector<std::uint8_t>> writeModel(std::span<const ModelObject> objects, ModelFormat format,
                                             const WriteOptions& options = {});

/// Writes one object of one body.
Result<std::vector<std::uint8_t>> writeModel(const Mesh& mesh, ModelFormat format, const WriteOptions& options = {});

/// Returns the objects' colours, each once, in order of appearance: those of bodies and of painted facets.
std::vector<Colour> coloursOf(std::span<const ModelObject> objects);

/// Returns the triangles of a part, ascending. @param partOf  the part of each triangle
std::vector<std::uint32_t> trianglesOf(std::span<const std::uint32_t> partOf, std::uint32_t part);

/// Returns the positions of `subset` in the list `triangles`; triangles that are not in the list are left out.
/// @param triangles, subset  ascending
std::vector<std::uint32_t> placesIn(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> subset);

/// Returns some triangles as a mesh, with the positions that they use, in their order.
/// @param triangles  ascending
Mesh submesh(const Mesh& mesh, std::span<const std::uint32_t> triangles);

/// Splits a mesh by part; every part's vertices and triangles keep their order.
/// @param partOf  the part of each triangle; empty: all belong to part 0
/// @param names   the name of each part
/// @returns an object of one body for each part that has a triangle; positions on two parts go into both
std::vector<ModelObject> objectsOf(const Mesh& mesh, std::span<const std::uint32_t> partOf,
                                   std::span<const std::string> names);

/// Names of Slicer's values, in order. Scripts rely on them.
inline constexpr std::array<std::string_view, 4> kSlicerNames = {"any", "prusa", "orca", "bambu"};

/// Returns none for an unknown name.
constexpr std::optional<Slicer> slicerByName(std::string_view name) {
  for (std::size_t i = 0; i < kSlicerNames.size(); ++i)
    if (kSlicerNames[i] == name) return static_cast<Slicer>(i);
  return {};
}

/// Makes a name safe for a line of text: control characters become blanks. Trailing backslashes are removed, because in
/// OBJ they would join the next line.
inline std::string oneLine(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if ((c >= 0 && c < ' ') || c == 127) c = ' ';
  while (!line.empty() && (line.back() == '\\' || line.back() == ' ')) line.pop_back();
  return line;
}

}  // namespace qrelief
