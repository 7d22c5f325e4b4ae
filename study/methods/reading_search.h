// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "depth/depth_solver.h"
#include "depth/light_neighbours.h"

namespace qrelief::study {

struct ReadingOptions {
  double dataContrast = 0.1;     ///< a dark module must look darker than its surroundings by this fraction, 0 … 1
  double finderContrast = 0.15;  ///< the same for the modules of the three finder patterns
  double blurModules = 0.4;      ///< standard deviation of the blur by a phone's lens and sensor, in module widths
  double tolerance = 0.005;      ///< a module is done if its contrast exceeds the required contrast by at most this
  int maxPasses = 12;

  bool operator==(const ReadingOptions&) const = default;
};

/// Search for the least depths that a decoder needs: every dark module *as a whole*, in a blurred picture, is darker
/// than its surroundings by the required contrast. The paper's rule [Papp 2022, §7] tests each submodule, unblurred,
/// which says little about a pattern that leaves two thirds of a module uncarved.
///
/// The luminance M of a module is taken at its middle in the map blurred by a Gaussian. The surroundings A are the mean
/// of the four darkest light modules around it, likewise blurred, as in PaperStepSearch. The goal is M = (1 − c)·A for
/// every dark module. All pockets of a module share one depth, so their floor stays one facet. Each pass moves the
/// depth along the secant of the last two passes, between the depths found too bright and dark enough.
class ReadingSearch final : public DepthSolver {
 public:
  ReadingSearch(CarvingTarget target, const ReadingOptions& options);

  void update(const Grid<double>& luminance) override;

  bool finished() const override { return finished_; }
  int iterations() const override { return passes_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  std::size_t limitedCount() const override;
  std::size_t unfinishedCount() const override;
  /// Returns the last measured contrast of each dark module, row-major; 0 for light ones.
  const std::vector<double>& contrasts() const { return contrast_; }

 private:
  struct Pocket {
    std::size_t module = 0;
    double wanted = 0;   // contrast
    double limitMm = 0;  // greatest limit of its submodules
    double depthMm = 0;
    double brightMm = 0;  // deepest depth found too bright
    double darkMm = 0;    // shallowest depth found dark enough; 0: none yet
    double lastMm = 0, lastContrast = 0;
    bool done = false, limited = false;
  };

  template <class Counts>
  std::size_t submodulesOf(const Counts& counts) const;
  void carve(const Pocket& pocket);
  void deepen(Pocket& pocket, double contrast);

  CarvingTarget target_;
  ReadingOptions options_;
  LightNeighbours neighbours_;
  DepthField depths_;
  std::vector<Pocket> pockets_;
  std::vector<double> contrast_;
  int passes_ = 0;
  bool finished_ = false;
};

}  // namespace qrelief::study
