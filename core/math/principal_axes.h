// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "math/vec.h"

namespace qrelief {

/// Returns the unit vector, of either sign, along which points vary least about their mean: the eigenvector of the
/// smallest eigenvalue of their covariance (principal component analysis). If several axes vary equally little, returns
/// one of them; for fewer than three points, zero.
///
/// Cost: O(n), and a few Jacobi rotations [Golub, Van Loan, Matrix Computations, §8.5].
Vec3 leastVarianceAxis(std::span<const Vec3> points);

}  // namespace qrelief
