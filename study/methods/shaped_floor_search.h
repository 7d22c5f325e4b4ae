// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "depth/depth_solver.h"
#include "depth/light_neighbours.h"

namespace qrelief::study {

/// Shapes of the dark modules' floors [Papp 2021]. In a section from the symbol's top (left) to its bottom, two modules
/// each:
///
///     Flat              Tilted            Wavy
///     ¯¯|_____|_____|¯  ¯¯\     |\     |¯  ¯¯\          /¯¯
///                          ¯-_  |  ¯-_ |      ¯-_    _-¯
///                             ¯-|     ¯-|         ¯-_¯
///
/// Depths grow towards the symbol's bottom, so a floor faces away from light from above, which is usual indoors and
/// outdoors. A tilted floor consists of five steps, one per submodule: the embedding has one depth per submodule, a
/// printer works in layers anyway, and a staircase is nearly as dark as the slope that it follows.
enum class FloorShape : std::uint8_t { Flat, Tilted, Wavy };

/// Returns "flat", "tilted" or "wavy".
const char* floorShapeName(FloorShape shape);

/// Returns the depth of a floor's step relative to its deepest step, 0 … 1; it rises evenly to 1. In a wavy floor every
/// other row of modules is mirrored, so the wave continues from module to module.
/// @param moduleRow  from the symbol's top
/// @param step       among the carved rows of the module's submodules, from the top, 0 … steps − 1
double floorWeight(FloorShape shape, int moduleRow, int step, int steps);

struct ShapedFloorOptions {
  FloorShape shape = FloorShape::Tilted;
  double contrast = 0.3;  ///< c: a module's floor must be darker than its surroundings by this fraction, 0 … 1
  double slackMm = 0.05;  ///< tolerated excess depth of the deepest step, approximate, > 0
  int maxIterations = 40;
};

/// Search for the least depths of shaped floors [Papp 2021] at which every dark module is dark enough: the mean
/// luminance of its carved submodules is at most (1 − c) of its surroundings (light_neighbours.h). Testing each
/// submodule, as for flat floors, would let the first step of a staircase decide.
///
/// Each module has one depth, the depth of its deepest step. Its darkness is log((1 − V)/V), where V is its luminance
/// relative to its surroundings. If all depths grow by one factor, darkness grows by about 2·log of that factor, as for
/// the sky over a round pit; it grows more if one module alone gets deeper. So a pass multiplies a depth by exp(missing
/// darkness / 3). In the first passes depths may rise and fall. Afterwards modules that are too bright only get deeper,
/// by at least a quantum, so the search ends. A submodule stops at its own limit.
class ShapedFloorSearch final : public DepthSolver {
 public:
  ShapedFloorSearch(CarvingTarget target, const ShapedFloorOptions& options);

  void update(const Grid<double>& luminance) override;

  bool finished() const override { return finished_; }
  int iterations() const override { return iterations_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  std::size_t limitedCount() const override;
  std::size_t unfinishedCount() const override;
  /// Returns the last measured contrast of each dark module's floor, row-major; 0 for light ones.
  const std::vector<double>& contrasts() const { return contrast_; }

 private:
  enum class State : std::uint8_t { TooBright, TooDeep, Done, Limited };
  struct Step {
    std::uint32_t submodule;  // index in the mask
    double weight;
  };
  struct Floor {
    std::size_t module = 0;
    std::vector<Step> steps;
    double depthMm = 0;  // of the deepest step
    double limitMm = 0;  // depth at which every step is at its limit
    State state = State::TooBright;
  };

  void carve(const Floor& floor);
  void judge(Floor& floor, double fraction);

  CarvingTarget target_;
  ShapedFloorOptions options_;
  LightNeighbours neighbours_;
  DepthField depths_;
  std::vector<Floor> floors_;
  std::vector<double> contrast_;
  int iterations_ = 0;
  bool finished_ = false;
};

}  // namespace qrelief::study
