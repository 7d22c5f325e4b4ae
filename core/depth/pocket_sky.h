// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "depth/floor_horizons.h"
#include "math/vec.h"
#include "qr/module_pattern.h"

namespace qrelief {

/// A cell on a path from a floor outwards.
struct PathStep {
  glm::ivec2 cell;  ///< column and row, from the floor's own
  float perMm = 0;  ///< 1 / distance of the border where the cell begins
};

/// Returns the paths along which a floor looks for its horizon, through a mask of `size` submodules along its edge.
std::array<std::vector<PathStep>, kFloorDirections> floorPaths(int size, double submoduleMm);

/// The fraction of a uniform sky that the floors of a carved symbol see if the surface is flat. It predicts without
/// rendering how a submodule's depth affects the submodule and its neighbours.
///
/// In each of 16 directions from a floor, the highest step passed, of height Δ at distance d, leaves d²/(d² + Δ²) of
/// the sky, cosine-weighted. The first light submodule ends the path, because nothing behind it is higher. The
/// directions start at four places of the floor in turn, whose mean is close to the mean of the whole floor.
class PocketSky {
 public:
  /// Cost: O(carved submodules · width of the dark areas).
  PocketSky(const SubmoduleMask& mask, double submoduleMm);

  /// Returns the indices of the carved submodules in the mask, ascending; all other functions count floors in this
  /// order.
  const std::vector<std::uint32_t>& carved() const { return carved_; }

  /// Visits the floors in sight of floor `k`, in any order and some twice. Sight is mutual: its depth changes how much
  /// sky they see.
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

  /// Depths of all floors, prepared for many queries.
  class Depths {
   public:
    /// @param sky       kept by reference
    /// @param depthsMm  in the order of carved()
    Depths(const PocketSky& sky, std::span<const double> depthsMm) : sky_(&sky), grid_(sky.onGrid(depthsMm)) {}

    /// Returns the fraction of the sky that floor `k` sees, 0 … 1, if its own depth were `depthMm` and all others
    /// unchanged.
    double fraction(std::size_t k, double depthMm) const {
      return skySeenFrom(&grid_[sky_->cell_[k]], static_cast<float>(depthMm), sky_->steps_).fraction;
    }

   private:
    const PocketSky* sky_;
    std::vector<float> grid_;
  };

  /// Finds depths at which every floor sees no more than its fraction of the sky, or is at its limit.
  ///
  /// A floor gets darker as it gets deeper, and brighter as its neighbours get deeper; if all depths grow by one
  /// factor, all floors get darker. So there is exactly one solution, it has the least depth everywhere, and solving
  /// for one floor after the other converges to it from any start. Groups of floors out of each other's sight are
  /// solved on all cores.
  /// @param fractions  per floor, above 0 and below 1
  /// @param limitsMm   per floor, ≥ 0
  /// @param depthsMm   in: start; out: result
  /// @param isDue      per floor: solve for it even if no other floor moves
  /// @param maxSweeps  over all floors; a few sweeps come close, which suffices where the fractions will change again
  void solve(std::span<const double> fractions, std::span<const double> limitsMm, std::span<double> depthsMm,
             std::vector<char> isDue, int maxSweeps) const;

 private:
  static constexpr std::uint32_t kLight = 0xffffffff;

  void findGroups();
  std::vector<float> onGrid(std::span<const double> depthsMm) const;
  double depthFor(std::size_t k, double fraction, double limitMm, const std::vector<float>& grid) const;

  std::vector<std::uint32_t> carved_;
  // A grid of cells. Light cells surround the symbol, and pad the grid so that no step leaves it.
  std::vector<std::uint32_t> cell_;     // of each floor
  std::vector<std::uint32_t> floorOf_;  // of each cell; kLight: not carved
  FloorSteps steps_;
  std::vector<std::vector<std::uint32_t>> groups_;  // floors, ascending; none sees a floor of another group
};

}  // namespace qrelief
