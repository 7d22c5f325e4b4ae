// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "math/vec.h"

namespace qrelief {

/// Whether three points lie on one line, exactly (a filter in doubles, then CGAL's predicate); also if two are equal.
/// Cost: a few nanoseconds where the triangle has a visible area.
bool collinear(Vec3f a, Vec3f b, Vec3f c);

}  // namespace qrelief
