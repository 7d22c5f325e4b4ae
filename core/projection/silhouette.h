// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "mesh/triangle_clusters.h"
#include "projection/occlusion.h"

namespace qrelief {

/// Region that grows about the centre until it meets the silhouette. The search is exact for this region.
enum class GrowingRegion : std::uint8_t {
  Disc,   ///< for codes at any rotation
  Square  ///< for a code along the frame's axes
};

/// The facets on which the code can lie, and their outline.
struct VisiblePatch {
  std::vector<std::uint32_t> triangles;  ///< ascending; the interiors of their images do not overlap
  /// Outer contour and inner occlusion contours, unordered, as far as they come within `radiusMm` of the centre. A
  /// convex region about the centre within that radius that no segment enters is covered by `triangles` and fully
  /// visible.
  std::vector<Segment2> silhouette;
  double radiusMm = 0;  ///< radius of the searched part of the QR plane about the centre
  /// True if a facet met by the search is only partly visible; otherwise the patch is the same for every GrowingRegion.
  bool partlyHidden = false;
  std::size_t looks = 0;  ///< contour edges looked at near facets, each once for every cell of the bins
};

/// Finds the silhouette that bounds every code about the centre [Papp 2022, §4], and the patch within it: the facets
/// that the frame's eye sees and that are connected with the seed across edges.
///
/// **Method.** Visibility changes only across the image of a *contour edge*: an edge between a facet that faces the eye
/// and one that does not [Appel 1967, quantitative invisibility]. The flood starts at the seed and passes over edges to
/// facets that face the eye. For each facet it finds the *occluders*: contour edges that pass over the closed facet
/// nearer to the eye. A facet without occluders is fully visible as soon as one point of it is. A facet with occluders
/// stays in the patch, but the flood leaves it only through points that it can reach within the facet without meeting
/// an occluder. Such facets wait, and are entered in order of the distance at which they can be entered. If the images
/// of two facets overlap (one of them then has occluders), the facet met farther from the centre is dropped. Distance
/// is the radius of the disc, or half the edge of the aligned square, through a point. The silhouette is
///   (A) every edge of the patch with no facet of the patch beyond it, and
///   (B) every occluder of a facet of the patch.
///
/// **Proof.** Let D be an open convex region about the centre C that no silhouette segment enters. Claim: each point of
/// D is the image of exactly one point of the patch, and the eye sees that point there. Take p in D and let x(t) move
/// from C to p. Its point on the surface, q(t), starts on the seed, which is visible at C. As long as q(t) lies in the
/// patch it can be continued: within a facet that faces the eye the projection is one to one, and over an edge or a
/// vertex q(t) would leave the patch only by (A), in D. Could q(t) become hidden on the way? The first time it does,
/// another sheet slides in front of it. A visible sheet ends only at a contour edge, so x(t) lies on the image of a
/// contour edge. Either this edge is nearer than q(t), which is (B), or it meets q(t) itself; then not all facets
/// around q(t) face the eye, and x(t) lies on (A). Hence q(t) stays visible, and since the eye sees one point at a
/// time, it is unique. This holds whichever facets the flood picks; its choice decides only how large the code may be.
/// The order makes the result exact for a disc, or a square, D: all facets with points of D are entered at a point of D
/// before any other facet with occluders is (induction along the straight path), so nothing of D is lost.
///
/// Preconditions: the surface does not cross itself (else see crossings.h); frame.centre lies on the seed (to
/// kOnSurfaceMm). Cost: O(F + E) for F facets in the clusters about the code, and E contour edges of them in uniform
/// bins, besides an array of a few bytes for each triangle and vertex. A search that has looked at 50 contour edges for
/// each triangle, and at a million, enters no more facets that may have occluders: the patch stays right but may be
/// smaller.
///
/// Finds the silhouettes of several regions, or seeds, about one centre. It projects the facets about the centre once.
class SilhouetteFinder {
 public:
  /// @param mesh, adjacency  kept by reference
  /// @param radiusMm  > 0, may be infinite; facets wholly farther than this from the centre on the QR plane are left
  ///                  out, and the edge towards them is not part of the silhouette
  /// @param clusters  of the mesh, if it is closed, to look only at facets about the code; null: looks at all
  SilhouetteFinder(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame, double radiusMm,
                   const ClusteredTriangles* clusters = nullptr);
  ~SilhouetteFinder();

  double radiusMm() const;
  /// @param seed    triangle under the centre
  /// @param region  the silhouette leaves this region as much room as possible; it may leave others less
  /// @returns NoSolution if the seed faces away from the eye, lies level with it or behind it, or something hides the
  ///          centre (the message names the obstacle, its place, and how near the eye would have to come)
  Result<VisiblePatch> find(std::uint32_t seed, GrowingRegion region);

 private:
  std::unique_ptr<struct SilhouetteSurroundings> around_;
};

/// Finds one silhouette, see SilhouetteFinder.
inline Result<VisiblePatch> findSilhouette(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                           std::uint32_t seed, double radiusMm,
                                           GrowingRegion region = GrowingRegion::Disc,
                                           const ClusteredTriangles* clusters = nullptr) {
  return SilhouetteFinder(mesh, adjacency, frame, radiusMm, clusters).find(seed, region);
}

}  // namespace qrelief
