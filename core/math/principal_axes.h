// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "math/vec.h"

namespace qrelief {

/// Unit vector along which points vary least about their mean: the eigenvector of the smallest eigenvalue of their
/// covariance (principal component analysis), of either sign. Where several axes vary equally little, one of them; zero
/// for fewer than three points.
///
/// Cost: O(n), and a few Jacobi rotations [Golub, Van Loan, Matrix Computations, §8.5].
Vec3 leastVarianceAxis(std::span<const Vec3> points);

}  // namespace qrelief
