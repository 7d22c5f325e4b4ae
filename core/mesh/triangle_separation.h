// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "math/vec.h"

namespace qrelief {

using Corners = std::array<Vec3, 3>;  ///< corners of a triangle; 32-bit floats held in doubles

/// Bound of the rounding error of a triple product of differences of corners, in the product of the largest coordinates
/// of its three vectors: at most 6 products of relative error 9 · 2^-53 each, doubled for directed rounding.
inline constexpr double kVolumeError = 3e-14;

/// Returns the largest coordinate without its sign.
double largestOf(Vec3 v);

// Quick tests of two triangles. True is certain; after false, ask the exact predicates. Each test looks for a plane
// between the triangles and allows for its own rounding errors. Triangles without area are allowed. Cost: tens of
// nanoseconds.

/// Returns true if two triangles certainly have no point in common.
bool certainlySeparate(const Corners& a, const Corners& b);

/// Returns true if two triangles that share their first corner certainly have no other point in common.
bool certainlySeparateButForCorner(const Corners& a, const Corners& b);

/// Returns true if two triangles that share their first two corners certainly have nothing but that edge in common.
bool certainlySeparateButForEdge(const Corners& a, const Corners& b);

}  // namespace qrelief
