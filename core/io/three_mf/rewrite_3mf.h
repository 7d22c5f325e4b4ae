// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "io/three_mf/source.h"
#include "io/write_model.h"

namespace qrelief {

/// Attributes that a triangle keeps in a rewritten file.
struct KeptAttributes {
  enum class What : std::uint8_t {
    Nothing,
    All,        ///< the triangle is the original one
    WholePaint  ///< the triangle is a piece of the original one, and keeps only paint that covers the whole original
  };
  What what = What::Nothing;
  std::uint32_t triangle = 0;  ///< of the soup
};

/// The new mesh of a run (source.h).
struct ChangedRun {
  std::size_t run = 0;
  Mesh mesh;                            ///< mm
  std::vector<KeptAttributes> kept;     ///< for each triangle
  std::vector<std::uint32_t> painted;   ///< triangles that get the second filament, ascending
  std::optional<ModelBody> inlay = {};  ///< a second body, in the second filament
};

/// A material, for a file without a slicer's settings.
struct Material {
  std::string name;
  Colour colour{};
};

/// Rewrites a file that was read, with new meshes for some of its runs. Everything else stays: the bytes of all other
/// parts, and the other objects, names, plates and volumes in the changed parts. Ranges of PrusaSlicer's volumes move
/// with the triangles. An inlay becomes a volume, or a component and a part, of the same object. The second filament is
/// 2, or 1 if the object itself has 2. A file without any slicer's settings gets the settings that the inlay needs, and
/// two named materials. Changed objects lose their slices, and items
/// become of type "model".
///
/// If `up` is not +z, the item with the changed meshes is turned: its middle stays above the same place, at the same
/// height, unless another item is in the way; then it moves to the right until it is clear.
///
/// Corners are written with as many digits as the transform needs: reading gives the same 32-bit floats in mm.
/// Cost: linear in the file's unpacked size.
/// @param changes  ascending by run, with at most one inlay
/// @param slicer   the program that will open the file
/// @param materials  of both filaments
/// @param up         the printer's vertical in the model's space, any length > 0
/// @returns NoSolution with the reason why the file must be written anew: several items share a mesh; the text is not
///          UTF-8; volumes of PrusaSlicer do not divide the mesh; other triangles when the file is read back; or, with
///          a second filament, the model settings of PrusaSlicer, or of Bambu Studio and OrcaSlicer, do not list the
///          object, or the file is meant for another program, or it has colour groups but no such settings
Result<std::vector<std::uint8_t>> rewrite3mf(const ThreeMfSource& source, std::span<const ChangedRun> changes,
                                             Slicer slicer, const std::array<Material, 2>& materials,
                                             Vec3 up = {0, 0, 1});

}  // namespace qrelief
