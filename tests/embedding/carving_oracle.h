// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "embedding/embed.h"
#include "mesh/topology.h"

/// What a carved mesh must be, told from the input alone and by brute force.
namespace qrelief::oracle {

/// Facets seen from their front whose projection comes within `reachMm` of the centre, connected with the one under
/// the centre: on a shape without folds in reach, the visible patch.
std::vector<std::uint32_t> frontPatch(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                      double reachMm);

/// frontPatch and embedDepthField.
Result<EmbedResult> carve(const Mesh& mesh, const ProjectionFrame& frame, const DepthField& field,
                          const EmbedOptions& options = {});

/// A field from a function of (row, column), rounded to the quantum.
DepthField fieldOf(int size, double symbolMm, const std::function<double(int, int)>& depthMm);

/// Vertices of equal position become one, as when an STL is read.
Mesh welded(const Mesh& mesh);

/// In words what is no solid about a mesh after a round trip through an STL file; empty if it is one.
std::string solidProblems(const EmbedResult& result);

/// V - E + F of a closed mesh.
long eulerCharacteristic(const Mesh& mesh);

/// Largest difference, over `samples` points per submodule at least `marginMm` from its rim, between the distance at
/// which the ray meets the carved mesh and the one at which it meets the original plus the submodule's depth, mm.
double largestDepthError(const Mesh& original, const Mesh& carved, const ProjectionFrame& frame,
                         const DepthField& field, double marginMm, int samples = 1);

/// Volume between the surface and the floors if the surface lies at distance(p) from the eye along the ray through
/// plane point p: the sum over submodules of ∫ cosθ·(d + d²/t + d³/(3·t²)) dA·(t/t₀)², t₀ the plane's own distance.
double pocketVolume(const ProjectionFrame& frame, const DepthField& field, const std::function<double(Vec2)>& distance);

/// Sum of length times difference of depth over all submodule edges: how much volume a shift of all outlines by 1 mm
/// could change, on a surface near the plane.
double wallArea(const DepthField& field);

}  // namespace qrelief::oracle
