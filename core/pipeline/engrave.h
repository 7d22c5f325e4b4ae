// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "carving/embed.h"
#include "carving/outlined_pockets.h"
#include "depth/depth_solver.h"
#include "depth/fast_search.h"
#include "depth/paper_step_search.h"
#include "pipeline/depth_search_run.h"
#include "pipeline/engravable_model.h"
#include "pipeline/placement.h"
#include "pipeline/placement_measurement.h"
#include "qr/symbol.h"
#include "render/luminance_pass.h"
#include "settings/engrave_request.h"
#include "verification/printability.h"
#include "verification/reader_view.h"
#include "verification/solidity.h"

namespace qrelief {

/// Time spent in each stage, ms.
struct StageTimings {
  double direction = 0, size = 0, surface = 0, depthSearch = 0, embed = 0, verify = 0;
  double forPrint = 0;  ///< rough print of the first search's depths
  double print = 0;     ///< simulation of the final print; 0: not simulated

  /// Returns all stages in order, with their names in reports.
  std::array<std::pair<const char*, double>, 8> all() const {
    return {{{"direction", direction},
             {"size", size},
             {"surface", surface},
             {"depthSearch", depthSearch},
             {"forPrint", forPrint},
             {"embed", embed},
             {"verify", verify},
             {"print", print}}};
  }
};

/// The carved solid, and everything found out about it.
struct EngraveResult {
  Mesh mesh;                            ///< as a slicer reads its file: weldedByPiece(); with the model's bodies
  std::size_t keptTriangles = 0;        ///< facets of the input that are unchanged bit for bit; they come first
  std::vector<FacetOrigin> origins;     ///< of the triangles of `mesh`
  std::vector<Body> bodies = {Body()};  ///< of the model
  std::uint32_t carvedBody = 0;         ///< index of the body with the code
  bool coversColours = false;           ///< the model's surface under the code and its quiet zone has several colours
  EngraveRequest request;               ///< as carved, with defaults filled in (pipeline/default_patterns.h)
  Symbol symbol;
  Placement placement;
  DepthField depths;
  OutlinedPockets label;                 ///< text and frame as carved; empty: none
  int searchIterations = 0;              ///< of both searches, if the print required a second one
  std::size_t limitedSubmodules = 0;     ///< submodules too light because of a depth limit or the end of the search
  std::size_t unfinishedSubmodules = 0;  ///< those of them that the end of the search left too light
  /// Distance to another shell within the material under the code (shell_below.h), mm; none: there is no such
  /// shell, or all submodules are dark enough within their depth limits.
  std::optional<double> shellBelowMm;
  Grid<double> luminance;   ///< of every submodule of symbol and quiet zone, at the depths found
  Grid<Received> received;  ///< the light that makes this luminance
  SolidityReport solidity;  ///< report on the whole file, after the round trip
  /// Pairs of crossing triangles inherited from the model; any others would have been refused.
  std::size_t inheritedSelfIntersections = 0;
  /// Mark::Inlay: depth along the rays, the same in all modules, and the depth that would be opaque, mm; else 0.
  double markDepthMm = 0, opaqueDepthMm = 0;
  std::size_t modulesLeftOut = 0;  ///< Mark::Inlay: dark modules without an inlay, because walls are too thin
  /// Mark::Paint: the triangles of `mesh` in the second colour, ascending; else empty.
  std::vector<std::uint32_t> painted;
  std::optional<Mesh> inlay;        ///< of Mark::Inlay, or added to a shadow (add_inlay.h); after an STL round trip
  SolidityReport inlaySolidity;     ///< report on the inlay
  ReaderView readerView;            ///< the code as a phone sees it
  ReaderViewOptions readerOptions;  ///< options used to draw it
  bool litByShaders = false;        ///< shaders computed the light on the code; otherwise the processor did
  SearchRecord search;              ///< if requested
  StageTimings timingsMs;
};

/// Mean, maximum and 95th percentile of the carved submodules' depths, mm.
struct DepthSummary {
  double meanMm = 0, maxMm = 0, p95Mm = 0;
};
DepthSummary summarise(const DepthField& depths);

/// Summarises the pockets of a carving: of the code, or of a text alone, whose pockets have one depth.
DepthSummary pocketDepths(const EngraveResult& result);

/// Returns the symbol with the modules that are dark in a code in colour.
Symbol markedSymbol(const EngraveResult& result);

/// Returns the features that a printer has to make, measured from the depths.
CarvedFeatures featuresOf(const EngraveResult& result);

/// Maps of a running or finished job for the inspector. The job owns them all.
struct InspectorMaps {
  const PlacementLight* light =
      nullptr;  ///< with luminance and depths as textures; null before the surface is measured
  const Symbol* symbol = nullptr;
  const SearchRecord* search = nullptr;  ///< empty unless requested; takeResult() moves it into the result
};

/// Carves and checks once, a bounded piece of work at a time; to cancel, stop calling advance(). Needs the
/// model's GL context, if it has one.
///
///     auto job = CarveJob::create(model, request);
///     for (;;) { auto progress = job->advance(); if (!progress) …error…; if (progress->done) break; }
///     EngraveResult result = job->takeResult();
class CarveJob {
 public:
  /// Results of earlier work to reuse.
  struct Known {
    /// The place on this model for searchedPlacement(request, …).
    const FoundPlacement* placed = nullptr;
    std::shared_ptr<const LuminancePrograms> programs = nullptr;  ///< null: makes its own if the model uses shaders
    const Symbol* symbol = nullptr;  ///< replaces the symbol of the request's text and options
    /// From a finished job on the same model; the place is measured anew if this job's place differs.
    std::shared_ptr<PlacementMeasurement> measured = nullptr;
    Device device = Device::Faster;
    /// Replaces the request's objective and solver, if the request is not carved for its print
    /// (EngraveRequest::isForPrint). The study's methods use it.
    MakeSearch makeSearch = nullptr;
  };
  /// @returns the errors of checkEngraving()
  static Result<std::unique_ptr<CarveJob>> create(std::shared_ptr<const EngravableModel> model, EngraveRequest request,
                                                  const Known& known);
  static Result<std::unique_ptr<CarveJob>> create(std::shared_ptr<const EngravableModel> model, EngraveRequest request);
  ~CarveJob();

  /// Returns the next stage and the fraction of the job that is done.
  Progress progress() const;

  /// Does the next piece of work. Do not call it again after an error or `done`.
  Result<Progress> advance();

  /// Returns the result. Call it once, after `done`.
  EngraveResult takeResult();

  /// Returns the result once its mesh and symbol are set, while it is being checked and drawn; else null. The job
  /// owns it.
  const EngraveResult* writtenResult() const;

  /// Returns true once the first depth search has ended.
  bool hasSearched() const;
  /// Returns the place that the job has found; none if it was known. Call it after `done`.
  std::optional<FoundPlacement> foundPlace() const;
  /// Returns null before the surface is measured.
  std::shared_ptr<PlacementMeasurement> placementMeasurement() const;

  InspectorMaps inspectorMaps() const;
  /// Returns maps of the uncarved surface, drawn at the first call; null before the surface is measured.
  const SurfaceMaps* surfaceMaps() const;

 private:
  struct State;
  explicit CarveJob(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Runs a job to its end.
Result<EngraveResult> engrave(std::shared_ptr<const EngravableModel> model, const EngraveRequest& request);

}  // namespace qrelief
