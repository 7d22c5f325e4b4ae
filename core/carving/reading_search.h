// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "carving/depth_solver.h"
#include "carving/light_neighbours.h"

namespace qrelief {

struct ReadingOptions {
  double dataContrast = 0.1;     ///< a dark module must be seen darker than its surroundings by this fraction, 0 … 1
  double finderContrast = 0.15;  ///< the same for the modules of the three finder patterns
  double blurModules = 0.4;      ///< standard deviation of what a phone's lens and sensor blur, in module widths
  double tolerance = 0.005;      ///< a module is done once its contrast exceeds what is asked for by at most this
  int maxPasses = 12;

  bool operator==(const ReadingOptions&) const = default;
};

/// The search for what a reader needs: the least depth at which every dark module *as a whole*, as a blurred picture
/// shows it, is darker than its surroundings by the contrast asked for. The paper's rule [Papp 2022, §7] asks this of
/// each submodule, unblurred, which says little of a pattern that leaves two thirds of a module uncarved.
///
/// Seen luminance M of a module: that of its middle in the map blurred by a Gaussian. Surroundings A: the mean of the
/// four darkest light modules around it, likewise blurred, as in DepthSearch. Wanted: M = (1 − c)·A for every dark
/// module. The pockets of a module share one depth, so that their floor stays one facet; each pass moves it along the
/// secant of the last two, kept within what was already too bright and already dark enough.
class ReadingSearch final : public DepthSolver {
 public:
  ReadingSearch(CarvingTarget target, const ReadingOptions& options);

  void update(std::span<const double> luminance) override;

  bool finished() const override { return finished_; }
  int iterations() const override { return passes_; }
  double doneFraction() const override;
  const DepthField& depths() const override { return depths_; }
  std::size_t limitedCount() const override;
  /// Contrast of each dark module as last seen, row-major; 0 for light ones.
  const std::vector<double>& contrasts() const { return contrast_; }

 private:
  struct Pocket {
    std::size_t module = 0;
    double wanted = 0;   // contrast
    double limitMm = 0;  // the greatest of its submodules'
    double depthMm = 0;
    double brightMm = 0;  // the deepest that was too bright
    double darkMm = 0;    // the shallowest that was dark enough; 0: none yet
    double lastMm = 0, lastContrast = 0;
    bool done = false, limited = false;
  };

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

}  // namespace qrelief
