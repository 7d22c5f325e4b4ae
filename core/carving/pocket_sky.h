// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "carving/floor_horizons.h"
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

  /// The floors that floor `k` has in sight, and which have it in sight: its depth changes how much sky they see. In
  /// any order, some twice.
  template <class Visit>
  void forEachInSight(std::size_t k, const Visit& visit) const {
    for (int direction = 0; direction < kFloorDirections; ++direction)
      for (auto i = static_cast<std::size_t>(direction); i < steps_.offset.size(); i += kFloorDirections) {
        const std::uint32_t floor =
            floorOf_[static_cast<std::size_t>(static_cast<std::int32_t>(cell_[k]) + steps_.offset[i])];
        if (floor == kLight) break;
        visit(floor);
      }
  }

  /// Depths of all floors, for many questions about them.
  class Depths {
   public:
    /// @param sky       kept by reference
    /// @param depthsMm  in the order of carved()
    Depths(const PocketSky& sky, std::span<const double> depthsMm) : sky_(&sky), grid_(sky.onGrid(depthsMm)) {}

    /// Fraction of the sky that floor `k` sees, 0 … 1, were it, and it alone, as deep as `depthMm`.
    double fraction(std::size_t k, double depthMm) const {
      return skySeenFrom(&grid_[sky_->cell_[k]], static_cast<float>(depthMm), sky_->steps_).fraction;
    }

   private:
    const PocketSky* sky_;
    std::vector<float> grid_;
  };

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
  static constexpr std::uint32_t kLight = 0xffffffff;

  std::vector<float> onGrid(std::span<const double> depthsMm) const;
  double depthFor(std::size_t k, double fraction, double limitMm, const std::vector<float>& grid) const;

  std::vector<std::uint32_t> carved_;
  // A grid of cells. Light cells surround the symbol, and pad the grid so that no step leaves it.
  std::vector<std::uint32_t> cell_;     // of each floor
  std::vector<std::uint32_t> floorOf_;  // of each cell; kLight: it is not carved
  FloorSteps steps_;
};

}  // namespace qrelief
