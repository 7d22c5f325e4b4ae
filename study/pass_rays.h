// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "study/carved_surface.h"

namespace qrelief::study {

/// Measures rays from the floors of submodules, pass after pass of a search that only deepens submodules, and casts
/// again only rays whose result may have changed.
///
/// Deepening a submodule only removes material, so an open ray stays open until the floor it starts from moves. A
/// blocked ray is cast again if that floor or a submodule at its hit moved, or one next to the hit: two submodules
/// share a wall.
class PassRays {
 public:
  /// A ray's result.
  struct Cast {
    double value;
    std::optional<Vec3> hit;  ///< none: open
  };

  /// @param submodules  where rays start, row-major indices
  /// @param rays        for each submodule
  PassRays(std::vector<std::uint32_t> submodules, std::size_t rays);

  const std::vector<std::uint32_t>& submodules() const { return submodules_; }
  std::size_t rays() const { return rays_; }

  /// Begins a pass. @param depths  of this pass, nowhere less than in the previous one
  void begin(const ProjectionFrame& frame, const DepthField& depths);

  /// Returns the value of a ray. Different submodules may be measured at the same time.
  /// @param k     of `submodules`
  /// @param ray   < rays
  /// @param cast  () → Cast, called if no earlier result holds
  template <class CastRay>
  double value(std::size_t k, std::size_t ray, const CastRay& cast) {
    Known& known = known_[k * rays_ + ray];
    if (!holds(k, known)) {
      const Cast result = cast();
      known = {result.value, result.hit ? submoduleOf(*result.hit) : kOpen};
    }
    return known.value;
  }

 private:
  static constexpr std::int32_t kUnknown = -1, kOpen = -2, kBesideCode = -3;  // instead of a submodule

  struct Known {
    double value = 0;
    std::int32_t blocker = kUnknown;
  };

  bool holds(std::size_t k, const Known& known) const {
    if (known.blocker == kUnknown || hasMoved_[submodules_[k]]) return false;
    return known.blocker < 0 || !isNearMoved_[static_cast<std::size_t>(known.blocker)];
  }
  std::int32_t submoduleOf(Vec3 point) const;

  std::vector<std::uint32_t> submodules_;
  std::size_t rays_;
  std::vector<Known> known_;  // submodule after submodule
  ProjectionFrame frame_;
  DepthField depths_;
  std::vector<char> hasMoved_, isNearMoved_;
};

/// Casts rays evenly over the hemisphere from the middle of a submodule.
/// @param k      of `rays.submodules()`
/// @param count  the first so many rays, ≤ rays.rays()
/// @param seed   for Hemisphere
/// @param tell   called with the cosine of each ray and the distance of its hit in mm, if any
/// @returns false if the eye sees nothing there
bool overHemisphere(PassRays& rays, const CarvedSurface& surface, std::size_t k, std::size_t count, std::uint64_t seed,
                    const std::function<void(double, const std::optional<double>&)>& tell);

/// Measures with an eighth of the rays, then with twice as many each time. Stops at all of them, or as soon as the
/// value exceeds the target by the margin, which is halved each time.
/// @param margin   greatest error with an eighth of the rays
/// @param measure  (number of rays) → value
double measureUntilClear(std::size_t rays, double target, double margin,
                         const std::function<double(std::size_t)>& measure);

/// The sky as seen from a point of the surface.
struct SkySeen {
  double cosineWeighted = 0;  ///< ∫ cos ω over the open directions, divided by π: 1 = all
  double solidAngle = 0;      ///< of the open directions, sr, 0 … 2π
};

/// Measures the sky with these rays. @returns none if the eye sees nothing there
std::optional<SkySeen> skySeen(PassRays& rays, const CarvedSurface& surface, std::size_t k, std::size_t count,
                               std::uint64_t seed);

}  // namespace qrelief::study
