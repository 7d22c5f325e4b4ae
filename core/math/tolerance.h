// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Every tolerance of the core, with its reason. Topology is never decided by one of these.

namespace qrelief {

/// Sine of the angle below which an up hint counts as parallel to the plane's normal (about 1°):
/// nearer than that its projection says nothing about what the user meant.
inline constexpr double kParallelSine = 0.0175;

/// A point this near to a facet counts as lying on it, mm: a picked centre has been snapped to the surface in
/// double or single precision and may lie this far to either side of it; no printer knows the difference.
inline constexpr double kOnSurfaceMm = 0.001;

/// Points nearer to the eye's own plane than this fraction of the eye distance are not projected: their images lie a
/// billion eye distances away, or anywhere.
inline constexpr double kNearPlaneFraction = 1e-9;

/// Projected points nearer to one another than this fraction of the eye's distance (from the plane, and from the origin
/// of the coordinates) cannot be told apart: a thousand times the rounding error of a projection. Rejects what is
/// certainly apart, and keeps sample points clear of contours.
inline constexpr double kProjectionNoise = 1e-12;

/// Cosine of the angle between a facet's normal and the ray that meets it, below which it counts as a side wall that
/// the eye happens to see: a pocket beside it, whose walls run along the rays, leaves a blade sharper than 11.5°, and a
/// code upon it is stretched more than fivefold.
inline constexpr double kGrazingCosine = 0.2;

/// Cosine of the angle between two facets' normals below which one is the other side of the material under the other:
/// they enclose less than 75° of it.
inline constexpr double kOppositeCosine = -0.26;

/// A point this near to a facet's image counts as covered by it, mm: a thousand times the rounding error of a
/// projection at 1 m, and far less than anything that is carved.
inline constexpr double kCoveredMm = 1e-9;

/// Depths are rounded to this grid, mm: a tenth of the finest layer, so that neighbours that differ
/// only by noise share one floor, and no wall is lower than 32-bit floats can hold at 1 m.
inline constexpr double kDepthQuantumMm = 0.01;

/// Sine of the turn below which a polygon's corner counts as straight when a face is cut into triangles: coordinates
/// written with seven digits say no more. It chooses between triangulations that are all closed.
inline constexpr double kStraightSine = 1e-6;

/// Height, as a part of the model's diagonal, below which a triangle that hangs on a complete surface by one edge
/// counts as the remains of one without area: files with six digits round that much.
inline constexpr double kFlapHeight = 1e-5;

/// Vertices on open edges nearer than this fraction of the model's diagonal become one if no tolerance is given: a
/// micron on a figure as large as a hand, finer than any printer and coarser than files with six digits ...
inline constexpr double kWeldFraction = 1e-5;

/// ... but never less than so many steps of 32-bit floats at the model's farthest coordinate.
inline constexpr double kWeldFloatSteps = 4;

/// Holes up to this fraction of the model's diagonal are filled if no size is given: scans miss the underside of what
/// they stand on, a fifth of it or so; vases and open boxes gape wider.
inline constexpr double kHoleFraction = 0.2;

/// How far a vertex may be moved to part triangles that cross, as a part of the mean length of its edges: it stays
/// nearer to its place than to its neighbours, so the facets around it keep their order ...
inline constexpr double kUntangleEdgeFraction = 0.5;

/// ... and as a part of the model's diagonal: 1 mm on a figure as large as a hand; more would change its shape.
inline constexpr double kUntangleDiagonalFraction = 0.01;

}  // namespace qrelief
