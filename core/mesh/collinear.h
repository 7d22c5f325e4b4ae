// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "math/vec.h"

namespace qrelief {

/// Returns true if three points lie on one line or two are equal. Exact: a filter in doubles, then CGAL's predicate.
/// Cost: a few nanoseconds where the triangle has a visible area.
bool collinear(Vec3f a, Vec3f b, Vec3f c);

}  // namespace qrelief
