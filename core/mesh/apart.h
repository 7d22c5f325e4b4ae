// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "math/vec.h"

namespace qrelief {

using Corners = std::array<Vec3, 3>;  ///< of a triangle; 32-bit floats in doubles

// Quick answers about two triangles, right when they say yes: the exact predicates are for the rest. Each looks for a
// plane between the triangles and allows for the rounding of its own arithmetic. Any corners will do, also those of
// triangles without area. Cost: tens of nanoseconds.

/// Whether two triangles certainly have no point in common.
bool certainlyApart(const Corners& a, const Corners& b);

/// Whether two triangles that share their first corner certainly have no other point in common.
bool certainlyApartButForCorner(const Corners& a, const Corners& b);

/// Whether two triangles that share their first two corners certainly have no point beyond that edge in common.
bool certainlyApartButForEdge(const Corners& a, const Corners& b);

}  // namespace qrelief
