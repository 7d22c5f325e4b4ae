// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Every tolerance of the core, with its reason. None of them decides topology.

namespace qrelief {

/// Sine of the angle below which an up hint counts as parallel to the plane's normal (about 1°): the projection of a
/// hint more nearly parallel says nothing about what the user meant.
inline constexpr double kParallelSine = 0.0175;

/// Distance within which a point counts as lying on a facet, mm. A picked centre has been snapped to the surface in
/// double or single precision and may lie this far to either side. No printer can resolve the difference.
inline constexpr double kOnSurfaceMm = 0.001;

/// Distance from the eye's own plane, as a fraction of the eye distance, within which points are not projected: their
/// images lie a billion eye distances away, or anywhere.
inline constexpr double kNearPlaneFraction = 1e-9;

/// Distance, as a fraction of the eye's distance from the plane and from the origin of the coordinates, within which
/// two projected points cannot be told apart: a thousand times the rounding error of a projection. Used to reject
/// points that are certainly apart, and to keep sample points clear of contours.
inline constexpr double kProjectionNoise = 1e-12;

/// Cosine of the angle between a facet's normal and the ray that meets it. Below it the facet counts as a side wall
/// that the eye happens to see: a pocket next to it, whose walls run along the rays, would leave a blade sharper than
/// 11.5°, and a code on it would be stretched more than fivefold.
inline constexpr double kGrazingCosine = 0.2;

/// Cosine of the angle between two facets' normals. Below it the facets are opposite sides of the same material: they
/// enclose less than 75° of it.
inline constexpr double kOppositeCosine = -0.26;

/// Distance within which a point counts as covered by a facet's image, mm: a thousand times the rounding error of a
/// projection at 1 m, and far smaller than any carved feature.
inline constexpr double kCoveredMm = 1e-9;

/// Step to which depths are rounded, mm: a tenth of the finest layer. Neighbours that differ only by noise then share
/// one floor, and every wall is high enough for 32-bit floats at 1 m.
inline constexpr double kDepthQuantumMm = 0.01;

/// Sine of the turn below which a polygon's corner counts as straight when a face is cut into triangles: coordinates
/// with seven digits are no more precise. It only chooses between triangulations that are all closed.
inline constexpr double kStraightSine = 1e-6;

/// Height, as a fraction of the model's diagonal, below which a triangle attached to a complete surface by one edge
/// counts as a rounded triangle without area: files with six digits round that much.
inline constexpr double kFlapHeight = 1e-5;

/// Default tolerance for welding vertices on open edges, as a fraction of the model's diagonal: a micron on a
/// hand-sized figure, finer than any printer and coarser than files with six digits; at most kMaxRepairMoveMm ...
inline constexpr double kWeldFraction = 1e-5;

/// ... and its lower limit, in steps of 32-bit floats at the model's farthest coordinate.
inline constexpr double kWeldFloatSteps = 4;

/// Default diameter of the largest hole to fill, as a fraction of the model's diagonal. Scans lack the underside of the
/// object, about a fifth of the diagonal; vases and open boxes have wider openings.
inline constexpr double kHoleFraction = 0.2;

/// Largest move of a vertex to separate crossing triangles, as a fraction of the mean length of its edges: the vertex
/// stays nearer to its place than to its neighbours, so the facets around it keep their order ...
inline constexpr double kUntangleEdgeFraction = 0.5;

/// ... and in mm, as of every repair: what no printer shows. A fault that would need more is reported and left.
inline constexpr double kMaxRepairMoveMm = 0.005;

}  // namespace qrelief
