// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "base/result.h"
#include "carving/mark.h"
#include "carving/outlined_pockets.h"
#include "depth/depth_field.h"
#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

/// Where a facet of a carved mesh comes from.
struct FacetOrigin {
  static constexpr std::uint32_t kNoFacet = 0xffffffffu;
  enum class Kind : std::uint8_t {
    Kept,   ///< a facet of the model, unchanged bit for bit
    Piece,  ///< a piece of a facet that an outline or the square of a resampled surface cuts
    Floor,  ///< of a pocket
    Wall    ///< of a pocket
  };
  Kind kind = Kind::Kept;
  bool isOfLabel = false;          ///< a floor or wall of the label or the frame, or of a text alone
  std::uint32_t facet = kNoFacet;  ///< of the model; over a floor; none for walls and the grid of a resampled surface
};

struct EmbedResult {
  Mesh mesh;                                ///< kept facets first, in their old order; then the new ones
  std::vector<FacetOrigin> origins;         ///< of the triangles of `mesh`
  std::size_t keptTriangles = 0;            ///< facets of the input that are unchanged bit for bit
  std::vector<std::uint32_t> newTriangles;  ///< indices of facets created by carving
  Mesh inlay;                               ///< fills the pockets (inlay.h); empty unless requested
  std::vector<std::uint32_t> painted;       ///< for EmbedOptions::paint: facets of `mesh` to be painted, ascending
};

struct EmbedOptions {
  SurfaceMode surface = SurfaceMode::Preserved;
  bool inlay = false;  ///< also make the body that fills the pockets
  /// Carve nothing: cut the facets along the outlines, and list those that would be lowered. Every vertex stays and new
  /// ones lie on the facets, up to the rounding of 32-bit floats, so the solid keeps its shape. Needs a preserved
  /// surface.
  bool paint = false;
  OutlinedPockets label = {};  ///< pockets outside the symbol's square, or anywhere if no submodule is carved
  /// Largest move of an outline to keep it clear of the model's vertices and edges, mm, > 0. Only where many edges meet
  /// in one point may it be up to an eighth of a submodule.
  double snapMm = 0.01;
  /// Width of the material left between two pockets that would otherwise touch along a line, mm, > 0; limited to a
  /// quarter of a submodule.
  double chamferMm = 0.04;
};

/// Carves a depth field into the surface [Papp 2022, §5]: a constrained Delaunay triangulation of facets and pocket
/// outlines in the QR plane, with every vertex lifted back along its ray. Floors are the removed pieces, shifted along
/// their rays; walls run along rays. With a resampled surface the grid of submodule corners replaces the facets within
/// the symbol's square, so only the square's border has to keep clear of the model; the rest is the same.
///
/// The new surface is single-valued along the rays, so it never crosses itself. Its triangles are high enough that
/// rounding to 32-bit floats cannot change that. The depth field is responsible for the wall behind the pockets.
///
/// Steps: find the affected facets (footprint.h) and the outlines (outline.h); move the outlines clear of the model
/// (clearance.h); overlay both and triangulate (arrangement.h); lift (lift.h).
///
/// Cost: O(n log n) in affected facets and outlines, about 1 µs each, and a copy of the rest.
///
/// @param patch   triangles visible from the eye that cover all carved submodules and the label; their projections do
///                not overlap
/// @param depths  size² depths; symbolMm > 0
/// @returns the carved mesh; NoSolution if the carved area leaves the patch, or if its facets are so fine that 32-bit
///          floats cannot hold pieces of them; Internal if the arrangement fails
Result<EmbedResult> embedDepthField(const Mesh& mesh, const ProjectionFrame& frame,
                                    std::span<const std::uint32_t> patch, const DepthField& depths,
                                    const EmbedOptions& options = {});

/// Returns the reason why 32-bit floats cannot hold a carving: it is too far from the origin, or `facets`.
/// @param at      a point of the carving
/// @param facets  the reason if coordinates are fine enough there
Message whyTooFine(Vec3 at, Message facets);

}  // namespace qrelief
