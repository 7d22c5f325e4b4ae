// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "io/three_mf_source.h"
#include "io/write_model.h"

namespace qrelief {

/// A triangle's attributes in a file that is written again.
struct KeptAttributes {
  enum class What : std::uint8_t {
    Nothing,
    All,        ///< the triangle is the original one
    WholePaint  ///< a piece of it: of its paint only what covers the whole triangle
  };
  What what = What::Nothing;
  std::uint32_t triangle = 0;  ///< of the soup
};

/// The new mesh of a run (three_mf_source.h).
struct ChangedRun {
  std::size_t run = 0;
  Mesh mesh;                            ///< mm
  std::vector<KeptAttributes> kept;     ///< for each triangle
  std::vector<std::uint32_t> painted;   ///< triangles that get the second filament, ascending
  std::optional<ModelBody> inlay = {};  ///< a second body, in the second filament
};

/// Writes a file that was read, with new meshes for some of its runs. Everything else stays: the bytes of all other
/// parts, and the other objects, names, plates and volumes in the changed parts. Ranges of PrusaSlicer's volumes move
/// with the triangles. An inlay becomes a volume, or a component and a part, of the same object. The second filament is
/// 2, or 1 where the object itself has 2.
///
/// Corners are written with as many digits as the transform needs: reading gives the same 32-bit floats in mm.
/// Cost: linear in the file's unpacked size.
/// @param changes  ascending by run, with at most one inlay
/// @param slicer   the program that will open the file
/// @returns NoSolution with the reason why the file must be written anew: a mesh that several items share; a second
///          filament, but the model settings of PrusaSlicer, or of Bambu Studio and OrcaSlicer, do not list the object,
///          or the file is to be for another program; text that is not UTF-8; volumes of PrusaSlicer that do not
///          divide the mesh; other triangles when the file is read back
Result<std::vector<std::uint8_t>> rewrite3mf(const ThreeMfSource& source, std::span<const ChangedRun> changes,
                                             Slicer slicer);

}  // namespace qrelief
