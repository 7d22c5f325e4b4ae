// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "carving/embed.h"
#include "mesh/topology.h"

/// Required properties of a carved mesh, computed by brute force from the input alone.
namespace qrelief::oracle {

/// Returns the front-facing facets whose projection comes within `reachMm` of the centre and that are connected with
/// the facet under the centre. On a shape without folds in reach, this is the visible patch.
std::vector<std::uint32_t> frontPatch(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                      double reachMm);

/// Returns the front patch in 10 mm reach without one facet near the centre, so small that no outline comes near it.
/// @param mesh  with facets about 0.5 mm wide at the origin
std::vector<std::uint32_t> frontPatchWithHole(const Mesh& mesh, const ProjectionFrame& frame);

/// Calls frontPatch, then embedDepthField.
Result<EmbedResult> carve(const Mesh& mesh, const ProjectionFrame& frame, const DepthField& field,
                          const EmbedOptions& options = {});

/// Builds a depth field from a function of (row, column), rounded to the depth quantum.
DepthField fieldOf(int size, double symbolMm, const std::function<double(int, int)>& depthMm);

/// Merges vertices of equal position, as reading an STL does.
Mesh welded(const Mesh& mesh);

/// Describes why a mesh is no solid after a round trip through an STL file; empty if it is one.
std::string solidProblems(const EmbedResult& result);

/// Returns V - E + F of a closed mesh.
long eulerCharacteristic(const Mesh& mesh);

/// Returns the largest depth error, mm, over `samples` points per submodule that are at least `marginMm` from its rim.
/// The error is the difference between the ray's distance to the carved mesh and its distance to the original plus the
/// submodule's depth.
double largestDepthError(const Mesh& original, const Mesh& carved, const ProjectionFrame& frame,
                         const DepthField& field, double marginMm, int samples = 1);

/// Returns the volume between the surface and the floors, where the surface lies at distance(p) from the eye along the
/// ray through plane point p: the sum over submodules of ∫ cosθ·(d + d²/t + d³/(3·t²)) dA·(t/t₀)², t₀ the
/// plane's own distance.
double pocketVolume(const ProjectionFrame& frame, const DepthField& field, const std::function<double(Vec2)>& distance);

/// Returns the sum over all submodule edges of length times depth difference. On a surface near the plane it bounds how
/// much volume a shift of all outlines by 1 mm could change.
double wallArea(const DepthField& field);

}  // namespace qrelief::oracle
