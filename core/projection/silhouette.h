// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "projection/occlusion.h"

namespace qrelief {

/// What grows about the centre until it meets the silhouette, if nothing of it is to be lost.
enum class GrowingRegion : std::uint8_t {
  Disc,   ///< codes of any rotation
  Square  ///< a code along the frame's axes
};

/// The facets that can take the code, and their outline.
struct VisiblePatch {
  std::vector<std::uint32_t> triangles;  ///< ascending; the inner points of their images do not overlap
  /// Outer contour and inner occlusion contours, unordered, as far as they come within `radiusMm` of the centre: any
  /// convex region about the centre within that radius that they do not enter is covered by `triangles` and seen.
  std::vector<Segment2> silhouette;
  double radiusMm = 0;  ///< only what lies within it of the centre on the QR plane has been looked at
  /// Whether a facet that was met is seen in part only; else the patch is the same for every GrowingRegion.
  bool partlyHidden = false;
};

/// The silhouette that bounds every code about the centre [Papp 2022, §4], and the patch within it: the facets that the
/// frame's eye sees, connected (across edges) with the seed.
///
/// **Method.** What is hidden changes only across the image of a *contour edge*: one between a facet that faces the eye
/// and one that does not [Appel 1967, quantitative invisibility]. The flood starts at the seed and goes over edges to
/// facets that face the eye. For each it finds the *occluders*: contour edges that pass over the closed facet nearer to
/// the eye. A facet without occluders is seen as a whole as soon as one point of it is. A facet with occluders stays in
/// the patch, but is left only through points that can be reached within it without meeting an occluder; such facets
/// wait, and are entered in the order of the distance at which they can be. Of two facets whose images overlap (one of
/// them then has occluders) the one met farther from the centre is dropped. Distance is half the edge of the aligned
/// square through a point, or the radius of the disc. The silhouette is
///   (A) every edge of the patch beyond which there is no facet of the patch, and
///   (B) every occluder of a facet of the patch.
///
/// **Why it is true.** Let D be an open convex region about the centre C that no silhouette segment enters. Claim: each
/// point of D is the image of one point of the patch, and this is what the eye sees there. Take p in D and let x(t)
/// move from C to p. Its point on the surface, q(t), starts on the seed, which is seen at C. As long as q(t) lies in
/// the patch it can be carried on: within a facet that faces the eye the projection is one to one; over an edge or a
/// vertex it would leave the patch only by (A), in D. Could q(t) become hidden on the way? The first time it does,
/// another sheet slides in front of it; a sheet that the eye sees ends only at a contour edge, so x(t) lies on the
/// image of one that is nearer than q(t), which is (B), or that meets q(t) itself, and then not all facets around q(t)
/// face the eye and x(t) lies on (A). Hence q(t) stays seen, and since the eye sees one point at a time, the answer is
/// unique. This holds whatever facets the flood picks; which ones it picks decides only how large the code may be. And
/// the order makes it exact for a disc, or a square, D: all facets with points of D enter at a point of D before any
/// other facet with occluders does (induction along the straight path), so nothing of D is lost.
///
/// Preconditions: the surface does not cross itself (else see crossings.h); frame.centre lies on the seed (to
/// kOnSurfaceMm). Cost: O(T + F + E) for T triangles, F within the radius, and E contour edges in uniform bins.
/// @param seed      triangle under the centre
/// @param radiusMm  > 0, may be infinite; facets wholly farther than this from the centre on the QR plane are left out;
///                  the edge towards them is no silhouette
/// @param region    for which the silhouette leaves as much room as there is; for others it may leave less
/// @returns NoSolution if the seed faces away from the eye, lies beside or behind it, or something hides the centre
///          (says what, where, and how near the eye would have to come)
Result<VisiblePatch> findSilhouette(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                    std::uint32_t seed, double radiusMm, GrowingRegion region = GrowingRegion::Disc);

}  // namespace qrelief
