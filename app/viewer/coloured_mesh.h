// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/colour.h"
#include "render/gpu_mesh.h"
#include "viewer/display_mesh.h"

namespace qrelief {

/// Colour of facets that the file gives none. As light as a model without colours.
inline constexpr Colour kPlainColour{237, 235, 231};

/// Returns the colours of the vertices. Where few colours meet, as on painted models, a vertex exists once for each of
/// them afterwards, so that borders are sharp. Of many colours, as in scans, vertices get the mean.
///
/// Cost: O(n log n).
/// @param colours  of the triangles, none: kPlainColour; empty: the mesh has none, and nothing is returned
std::vector<Colour> splitAtColours(DisplayMesh& display, std::span<const std::optional<Colour>> colours);

/// Uploads a mesh with the colours of its triangles.
/// @param colours  of the triangles; empty: the mesh has none
GpuMesh colouredMesh(DisplayMesh display, std::span<const std::optional<Colour>> colours);

}  // namespace qrelief
