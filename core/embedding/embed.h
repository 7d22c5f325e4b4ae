// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "base/result.h"
#include "carving/depth_field.h"
#include "embedding/surface_mode.h"
#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

struct EmbedResult {
  Mesh mesh;                                ///< kept facets first, in their old order; then the new ones
  std::size_t keptTriangles = 0;            ///< facets of the input that come out bit for bit
  std::vector<std::uint32_t> newTriangles;  ///< indices of the facets that carving made
  Mesh inlay;                               ///< fills the pockets (inlay.h); empty unless asked for
};

struct EmbedOptions {
  SurfaceMode surface = SurfaceMode::Preserved;
  bool inlay = false;  ///< make the body that fills the pockets, too
  /// Outlines are moved by at most this much so that they keep clear of the model's vertices and edges, mm, > 0; only
  /// where many edges meet in one point, by up to an eighth of a submodule.
  double snapMm = 0.01;
  /// Width of the material left between two pockets that would touch along a line only, mm, > 0; at most a quarter of
  /// a submodule is taken.
  double chamferMm = 0.04;
};

/// Carves a depth field into the surface [Papp 2022, §5]: a constrained Delaunay triangulation of facets and pocket
/// outlines in the QR plane, every vertex lifted back along its ray; floors are the removed pieces shifted along their
/// rays, walls run along rays. With a resampled surface the grid of submodule corners takes the place of the facets
/// within the symbol's square, so that only the square's border has to keep clear of the model; the rest is the same.
///
/// Along the rays the new surface is single-valued, so it crosses itself nowhere; and no triangle of it is so low that
/// rounding to 32-bit floats could change that. What lies behind the pockets is the depth field's affair.
///
/// Steps: find the facets concerned (footprint.h), the outlines (outline.h) and places for these clear of the model
/// (clearance.h); overlay both and triangulate (arrangement.h); lift (lift.h).
/// Cost: O(n log n) in facets and outlines concerned, 1 µs each or so, and a copy of the rest.
///
/// @param patch   triangles visible from the eye that cover all carved submodules; projections do not overlap
/// @param depths  field.size² depths; symbolMm > 0
/// @returns the carved mesh; NoSolution if the carved area leaves the patch, or if facets so fine lie under it that
///          32-bit floats cannot hold pieces of them; Internal if the arrangement failed
Result<EmbedResult> embedDepthField(const Mesh& mesh, const ProjectionFrame& frame,
                                    std::span<const std::uint32_t> patch, const DepthField& depths,
                                    const EmbedOptions& options = {});

}  // namespace qrelief
