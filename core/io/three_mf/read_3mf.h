// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"

namespace qrelief {

/// Reads 3MF, core specification and production extension: every item of the build, with its components assembled and
/// its transforms applied. The triangles of a mirrored instance are reversed, to face outwards. Each item becomes a
/// part of the soup, which takes over the file's unit. Skips items and components that are not models (supports and the
/// like), are set not to print or are helper meshes of Cura; skips colours, textures and metadata. Objects of the types
/// "surface" and "other" are models if their meshes are closed. Skips modifiers, negative volumes, support blockers and
/// enforcers, which PrusaSlicer, OrcaSlicer and Bambu Studio keep among the models (volumes.h). Ignores
/// PrusaSlicer's volumes of a mesh if their ranges overlap, are reversed or lie outside of it: the whole mesh is then a
/// model, like triangles in no volume. The soup refers to a copy of the file, so that all of this can be written again
/// (rewrite_3mf.h).
///
/// Hostile files fail quickly and in bounded memory. Limits on unpacked size, compression ratio, number of objects,
/// nesting depth of components and number of instances apply before anything is built. No path leaves the archive, and
/// only requested parts are unpacked.
/// @returns BadInput naming the part, the line and the object; also if a mesh is only the stand-in of slices or beams
Result<PolygonSoup> read3mf(std::span<const std::uint8_t> bytes, const ReadLimits& limits);

}  // namespace qrelief
