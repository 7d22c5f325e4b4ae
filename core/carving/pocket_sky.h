// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "qr/module_pattern.h"

namespace qrelief {

/// How much of a uniform sky the floors of a carved symbol see, were the surface plane. It tells without rendering
/// what each submodule's depth does to itself and to its neighbours.
///
/// From a floor, in each of 16 directions, the highest of the steps passed, of height Δ at distance d, leaves
/// d²/(d² + Δ²), cosine-weighted; the first light submodule ends the search, as nothing behind it is higher. The
/// directions begin at four places of the floor in turn, whose mean is near that of the whole floor.
class PocketSky {
 public:
  /// Cost: O(carved submodules · width of the dark areas).
  PocketSky(const SubmoduleMask& mask, double submoduleMm);

  /// Indices of the carved submodules in the mask, ascending; what follows counts in this order.
  const std::vector<std::uint32_t>& carved() const { return carved_; }

  /// The floors that have floor `k` in sight. On a plane surface its depth changes how much sky they see, and no
  /// other's.
  std::span<const std::uint32_t> seenFrom(std::size_t k) const {
    return std::span(seenFrom_).subspan(seenFromBegin_[k], seenFromBegin_[k + 1] - seenFromBegin_[k]);
  }

  /// Fraction of the sky that floor `k` sees, 0 … 1, were its depth `depthMm` and those of the others `depthsMm`.
  double fraction(std::size_t k, double depthMm, std::span<const double> depthsMm) const;

  /// Depths at which every floor sees no more than its fraction, or is as deep as it may be.
  ///
  /// A floor gets darker as it gets deeper, and brighter as its neighbours do; and all get darker if all depths grow by
  /// one factor. So there is one solution, it is the least depth in every place, and solving for one floor after the
  /// other ends there from any start.
  /// @param fractions  per floor, above 0 and below 1
  /// @param limitsMm   per floor, ≥ 0
  /// @param depthsMm   where to begin; the answer
  /// @param isDue      per floor: whether it is to be solved for even if no other moves
  /// @param maxSweeps  over all floors; a few bring it near, and near is enough where the fractions will change again
  void solve(std::span<const double> fractions, std::span<const double> limitsMm, std::span<double> depthsMm,
             std::vector<char> isDue, int maxSweeps) const;

 private:
  struct Step {
    std::uint32_t floor;  // the floor that begins here; kLight: the uncarved surface
    float inverseDistanceMm;
  };
  static constexpr std::uint32_t kLight = 0xffffffff;
  static constexpr int kDirections = 16;

  struct FractionAndSlope {
    double fraction = 0, perMm = 0;
  };

  void listSeenFrom();
  FractionAndSlope fractionAndSlope(std::size_t k, double depthMm, std::span<const double> depthsMm) const;
  double depthFor(std::size_t k, double fraction, double limitMm, std::span<const double> depthsMm) const;

  std::vector<std::uint32_t> carved_;
  std::vector<Step> steps_;                              // by floor and direction, outwards
  std::vector<std::uint32_t> begin_;                     // of the steps of floor and direction
  std::vector<std::uint32_t> seenFrom_, seenFromBegin_;  // for each floor, those that have it among their steps
};

}  // namespace qrelief
