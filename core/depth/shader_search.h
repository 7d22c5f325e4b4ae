// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "base/result.h"
#include "depth/depth_solver.h"
#include "depth/fast_search.h"
#include "render/floor_passes.h"

namespace qrelief {

/// Returns the paths along which floors look for their horizon (floorPaths), for FloorPasses::Setup::steps.
std::vector<glm::vec4> floorSteps(int size, double submoduleMm);

/// FastSearch under the sky, on the GPU. Depths stay in textures: a batch of passes measures and moves the floors, and
/// then one read-back tells whether it was enough.
///
/// It differs from FastSearch in three ways. The solver on the plane moves all floors at once, with more sweeps.
/// Between the passes that measure all floors, a pass measures only floors that moved, or that touch one that did. The
/// search measures all floors at the end of a batch, and ends only there.
class ShaderSearch final : public DepthSearch {
 public:
  /// The place whose floors are carved.
  struct Place {
    /// Computes the light; kept by reference. From now on the search sets its selected cells and its reach.
    LuminancePass* light = nullptr;
    std::vector<std::uint32_t> cells;  ///< of the carved submodules, in the order of the mask
    Grid<double> luminance;            ///< before carving, of symbol and quiet zone; see DepthSolver::update
  };

  /// @param options  without lamps; sweepsPerPass does not apply
  /// @returns Internal if the GL implementation cannot make the textures
  static Result<std::unique_ptr<ShaderSearch>> create(CarvingTarget target, const FastSearchOptions& options,
                                                      Place place);

  /// Starts another search for the same target with other contrasts, from the result so far.
  void restart(const FastSearchOptions& options);

  static constexpr int kSweepsPerPass = 6;  ///< of the solver on the plane
  /// Returns true if a pass measures all floors, by its number from 0. The last pass of a search always does.
  static bool measuresAll(int pass, int freePasses);

  /// Runs a batch of passes and reads back. Do not call it once finished().
  /// @returns the record of each pass, without times
  std::vector<SearchRecord::Pass> advance();

  bool finished() const override { return finished_; }
  int iterations() const override { return iterations_; }  ///< since the last restart()
  int readBacks() const { return readBacks_; }             ///< since the last restart()
  double doneFraction() const override { return doneFraction_; }
  const DepthField& depths() const override { return depths_; }
  /// Returns the luminances at depths(), of symbol and quiet zone; see DepthSolver::update.
  const Grid<double>& luminance() const { return place_.luminance; }
  std::size_t limitedCount() const override { return limited_ + unfinishedCount(); }
  std::size_t unfinishedCount() const override { return finished_ ? tooBright_ : 0; }

 private:
  ShaderSearch(CarvingTarget target, Place place);
  void runPass(int record, bool isLast);
  void take(const SearchRecord::Pass& last);

  CarvingTarget target_;
  FastSearchOptions options_;
  Place place_;
  std::vector<std::uint32_t> carved_;  // indices in the mask
  std::vector<double> around_;         // light of each carved submodule's surroundings
  std::vector<FloorTarget> targets_;
  FloorPasses passes_;
  DepthField depths_;
  int iterations_ = 0, freePasses_ = 0, readBacks_ = 0;
  std::size_t limited_ = 0, tooBright_ = 0;  // at the last read-back, at a limit and below it
  double doneFraction_ = 0;
  bool finished_ = false;
};

}  // namespace qrelief
