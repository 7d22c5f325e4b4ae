// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "carving/depth_solver.h"
#include "carving/light_neighbours.h"

namespace qrelief {

/// Bottoms of the dark modules [Papp 2021]. In a section from the symbol's top (left) to its bottom, two modules each:
///
///     Flat              Tilted            Wavy
///     ¯¯|_____|_____|¯  ¯¯\     |\     |¯  ¯¯\          /¯¯
///                          ¯-_  |  ¯-_ |      ¯-_    _-¯
///                             ¯-|     ¯-|         ¯-_¯
///
/// Depths grow towards the symbol's bottom, so that a floor faces away from light from above, as most rooms and days
/// have it. A tilted floor is made of five steps, one a submodule: the embedding has one depth a submodule, a printer
/// lays layers anyway, and a staircase is nearly as dark as the slope that it follows.
enum class FloorShape : std::uint8_t { Flat, Tilted, Wavy };

/// "flat", "tilted" or "wavy".
const char* floorShapeName(FloorShape shape);

/// Depth of a floor's step beside that of its deepest, 0 … 1: it rises evenly to 1. Of a wavy floor every other row of
/// modules is mirrored, so that the wave goes on from module to module.
/// @param moduleRow  from the symbol's top
/// @param step       of the carved rows of the module's submodules, from the top, 0 … steps − 1
double floorWeight(FloorShape shape, int moduleRow, int step, int steps);

struct ShapedFloorOptions {
  FloorShape shape = FloorShape::Tilted;
  double contrast = 0.3;  ///< c: a module's floor must be darker than its surroundings by this fraction, 0 … 1
  double slackMm = 0.05;  ///< the deepest step is no deeper than it must be by more than about this, > 0
  int maxIterations = 40;
};

/// The least depths of shaped floors [Papp 2021] with which every dark module is dark enough: the mean luminance of its
/// carved submodules is at most (1 − c) of its surroundings (light_neighbours.h). That of single submodules, as a flat
/// floor has it, would make a staircase's first step decide.
///
/// Each module has one depth, that of its deepest step. Its darkness log((1 − V)/V), V the luminance beside that of the
/// surroundings, grows by about 2·log of the factor by which all depths grow, as the sky over a round pit has it; more
/// where a module alone gets deeper. So a pass multiplies a depth by exp(what is missing / 3). At first depths rise and
/// fall; then what is too bright only gets deeper, by a quantum at least, so that the search ends. A submodule stops at
/// its own limit.
class ShapedFloorSearch final : public DepthSolver {
 public:
  ShapedFloorSearch(CarvingTarget target, const ShapedFloorOptions& options);

  void update(std::span<const double> luminance) override;

  bool finished() const override { return finished_; }
  int iterations() const override { return iterations_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  std::size_t limitedCount() const override;
  /// Contrast of each dark module's floor as last seen, row-major; 0 for light ones.
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
    double depthMm = 0;  // of the deepest
    double limitMm = 0;  // beyond it every step is at its limit
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

}  // namespace qrelief
