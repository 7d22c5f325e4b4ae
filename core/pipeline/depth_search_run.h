// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/result.h"
#include "depth/depth_solver.h"
#include "depth/fast_search.h"
#include "depth/shader_search.h"
#include "pipeline/placement_light.h"

namespace qrelief {

struct EngraveRequest;

/// Factory of the solver that replaces a request's own.
using MakeSearch = std::function<std::unique_ptr<DepthSolver>(CarvingTarget)>;

/// The depth search of an engraving at a measured place. Where shaders compute the light, the default search runs on
/// the GPU (ShaderSearch). Otherwise a solver on the CPU and the light take turns, pass by pass.
class DepthSearchRun {
 public:
  struct Place {
    CellLayout layout;
    double moduleMm = 0;              ///< on the QR plane
    PlacementLight* light = nullptr;  ///< uncarved; kept by reference
  };

  /// @param request        checked (checkSettings); kept by reference
  /// @param makeOwnSearch  replaces the request's objective and solver; may be empty
  /// @returns Internal if the GL implementation cannot make the textures
  static Result<std::unique_ptr<DepthSearchRun>> create(const EngraveRequest& request, CarvingTarget target,
                                                        Place place, const MakeSearch& makeOwnSearch);

  /// Starts the second search of a request that is carved for its print. It begins with the first search's result.
  /// @param contrastOfModule  target contrasts from the print (contrast_for_print.h)
  void restart(std::vector<double> contrastOfModule);

  /// Returns a record with the carved submodules, for step().
  SearchRecord startedRecord() const;

  /// Runs a pass, or on a GPU a batch of passes. Do not call it once found() is finished.
  /// @param record  where to add the passes; may be null
  void step(SearchRecord* record);

  /// Returns what the search has found so far; its iterations count since restart().
  const DepthSearch& found() const { return onGpu_ ? static_cast<const DepthSearch&>(*onGpu_) : *solver_; }
  /// Returns the luminances of the last pass, of symbol and quiet zone; see DepthSolver::update.
  const Grid<double>& luminance() const { return luminance_; }
  /// Returns the light that makes this luminance, in the same order.
  Grid<Received> received() const;

 private:
  DepthSearchRun(const EngraveRequest& request, CarvingTarget target, Place place);
  Status startOnGpu(LuminancePass& light);
  void stepOnGpu(SearchRecord* record);
  std::vector<float> depthsOfCells() const;
  std::vector<float> measured();
  double reachMm(double deepestMm) const;
  std::uint32_t cellOf(std::uint32_t submodule) const;
  /// Picks the cells of symbol and quiet zone.
  template <class Value, class Cells>
  Grid<Value> ofQuietZone(const Cells& cells) const;

  const EngraveRequest& request_;
  CarvingTarget target_;
  Place place_;
  std::vector<std::uint32_t> carved_;    // indices in the mask
  std::unique_ptr<DepthSolver> solver_;  // null: the GPU searches
  std::unique_ptr<ShaderSearch> onGpu_;
  Grid<double> luminance_;
};

/// Makes the depth search for a request's objective and solver, on the CPU.
/// @param request  checked (checkSettings)
std::unique_ptr<DepthSolver> makeDepthSolver(const EngraveRequest& request, CarvingTarget target);

/// Returns true if FastSearch (on a GPU, ShaderSearch) serves the request's objective and solver.
bool usesFastSearch(const EngraveRequest& request);

/// Returns the search options for such a request. If the request is carved for its print (EngraveRequest::isForPrint),
/// this is the first of two searches. It stops after a few passes, because the rough print needs only approximate
/// depths; under lamps it runs to its end, because depths grow little by little.
FastSearchOptions fastSearchOptions(const EngraveRequest& request);

/// Returns the options of the second search, which begins with the first search's result.
/// @param contrastOfModule  target contrasts from the print (contrast_for_print.h)
FastSearchOptions fastSearchOptionsAfterPrint(const EngraveRequest& request, std::vector<double> contrastOfModule);

}  // namespace qrelief
