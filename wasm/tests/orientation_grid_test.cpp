// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's exact predicates need interval arithmetic, which needs directed rounding, which WebAssembly does not have.
// Without CGAL_ALWAYS_ROUND_TO_NEAREST about half of these orientations are silently wrong.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <cstdint>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Returns the sign of the orientation of three points in multiples of 2^-53, with integers that cannot overflow.
int exactOrientation(std::int64_t px, std::int64_t py, std::int64_t qx, std::int64_t qy, std::int64_t rx,
                     std::int64_t ry) {
  using Wide = __int128;
  const Wide determinant = Wide(qx - px) * Wide(ry - py) - Wide(qy - py) * Wide(rx - px);
  return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

TEST(CgalOnWebAssembly, DecidesNearlyCollinearPointsExactly) {
  // The grid of neighbouring doubles around (0.5, 0.5) against the line through (12, 12) and (24, 24).
  constexpr std::int64_t kUnit = std::int64_t{1} << 53;
  constexpr double kStep = 1.0 / static_cast<double>(kUnit);
  int wrong = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const CGAL::Orientation orientation = CGAL::orientation(Kernel::Point_2(0.5 + i * kStep, 0.5 + j * kStep),
                                                              Kernel::Point_2(12, 12), Kernel::Point_2(24, 24));
      wrong +=
          orientation != exactOrientation(kUnit / 2 + i, kUnit / 2 + j, 12 * kUnit, 12 * kUnit, 24 * kUnit, 24 * kUnit);
    }
  }
  EXPECT_EQ(wrong, 0) << "of 4096";
}

TEST(CgalOnWebAssembly, WidensAnIntervalAroundARoundedResult) {
  CGAL::Interval_nt<false>::Protector protector;
  const CGAL::Interval_nt<false> third = CGAL::Interval_nt<false>(1) / CGAL::Interval_nt<false>(3);
  // The nearest double to 1/3 is below it, so the upper bound must be at least the next double.
  EXPECT_LE(third.inf(), 1.0 / 3.0);
  EXPECT_GT(third.sup(), 1.0 / 3.0);
}

}  // namespace
}  // namespace qrelief
