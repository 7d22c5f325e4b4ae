// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "carving/depth_search.h"
#include "carving/fast_search.h"
#include "carving/search_record.h"
#include "pipeline/engravable_model.h"
#include "pipeline/measured_place.h"
#include "pipeline/placement.h"
#include "qr/symbol.h"
#include "render/geometry_pass.h"
#include "render/luminance_pass.h"
#include "settings/engrave_request.h"
#include "verification/printability.h"
#include "verification/reader_view.h"
#include "verification/solidity.h"

namespace qrelief {

/// Milliseconds spent in each stage.
struct StageTimings {
  double direction = 0, size = 0, surface = 0, depthSearch = 0, embed = 0, verify = 0;
  double forPrint = 0;  ///< to find out what the printer would make of the depths of a first search
  double print = 0;     ///< to find out how it comes off the printer; 0: that was not done
};

/// The carved solid and everything that is known of it.
struct EngraveResult {
  Mesh mesh;                      ///< as an STL round trip gives it back
  std::vector<std::uint8_t> stl;  ///< the very bytes that were checked
  std::size_t keptTriangles = 0;  ///< facets of the input that came out bit for bit
  /// Part of the model (PreparedModel::partOfTriangle) each triangle belongs to, the new ones to that of the facet
  /// under the centre; empty: one part only.
  std::vector<std::uint32_t> partOfTriangle;
  std::uint32_t carvedPart = 0;
  EngraveRequest
      request;  ///< as it was carved: with the patterns and depths that were left open (pipeline/default_patterns.h)
  Symbol symbol;
  Placement placement;
  DepthField depths;
  int searchIterations = 0;           ///< of both searches, where the print asked for a second one
  std::size_t limitedSubmodules = 0;  ///< that a limit kept from being dark enough
  /// Of every submodule of symbol and quiet zone, at the depths found; row-major from the quiet zone's top left.
  std::vector<double> luminance;
  std::vector<Received> received;  ///< the light that this luminance is made of, in the same order
  SolidityReport solidity;         ///< of the whole file, after the round trip
  /// Pairs of crossing triangles among those that the model brought along; all others would have been refused.
  std::size_t inheritedSelfIntersections = 0;
  std::optional<Mesh> inlay;        ///< if it was asked for; as an STL round trip gives it back, too
  SolidityReport inlaySolidity;     ///< of the inlay
  ReaderView readerView;            ///< what a phone would see
  ReaderViewOptions readerOptions;  ///< with which it was drawn
  SearchRecord search;              ///< if it was asked for
  StageTimings timingsMs;
};

/// Mean, maximum and 95th percentile over the carved submodules, mm.
struct DepthSummary {
  double meanMm = 0, maxMm = 0, p95Mm = 0;
};
DepthSummary summarise(const DepthField& depths);

/// What a printer has to make of what was carved, from the depths.
CarvedFeatures featuresOf(const EngraveResult& result);

/// What the inspector shows of a running or finished job. Everything belongs to the job.
struct InspectorMaps {
  const gl::Texture* luminance = nullptr;  ///< R32F; null before the surface was measured
  const gl::Texture* depths = nullptr;     ///< R32F, one texel a submodule
  const Symbol* symbol = nullptr;
  const SearchRecord* search = nullptr;  ///< empty if it was not asked for; moves into the result when that is taken
};

/// Engraves one symbol, a bounded piece of work at a time; to cancel, stop calling. Needs the GL context of the model.
///
///     auto job = EngraveJob::create(model, request);
///     for (;;) { auto progress = job->advance(); if (!progress) …error…; if (progress->done) break; }
///     EngraveResult result = job->takeResult();
class EngraveJob {
 public:
  /// What has been made before.
  struct Known {
    /// The place: a search of this model for searchedPlacement(request, …) that is done.
    const PlacementSearch* placed = nullptr;
    std::shared_ptr<const GeometryPass> pass = nullptr;
    std::shared_ptr<const LuminancePrograms> programs = nullptr;
    const Symbol* symbol = nullptr;  ///< in place of what the request's text and options give
    /// Of the same model, by a job that is over; measured anew where this one's place is another.
    std::shared_ptr<MeasuredPlace> measured = nullptr;
    LightBy lightBy = LightBy::Renderer;
  };
  /// @returns what checkEngraving() does
  static Result<std::unique_ptr<EngraveJob>> create(std::shared_ptr<const EngravableModel> model,
                                                    EngraveRequest request, const Known& known);
  static Result<std::unique_ptr<EngraveJob>> create(std::shared_ptr<const EngravableModel> model,
                                                    EngraveRequest request);
  ~EngraveJob();

  /// What comes next, and what share of the whole is behind it.
  Progress progress() const;

  /// The next piece. After an error or `done` it must not be called again.
  Result<Progress> advance();

  /// The result, once, after `done`.
  EngraveResult takeResult();

  /// The result as soon as its file, mesh and symbol are set: during the check and the picture. Else null. The job owns
  /// it.
  const EngraveResult* writtenResult() const;

  /// Null before the surface was measured.
  std::shared_ptr<MeasuredPlace> measuredPlace() const;

  InspectorMaps inspectorMaps() const;
  /// Of the uncarved surface, drawn when they are first asked for; null before the surface was measured.
  const SurfaceMaps* surfaceMaps() const;

 private:
  struct State;
  explicit EngraveJob(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Runs a job to its end.
Result<EngraveResult> engrave(std::shared_ptr<const EngravableModel> model, const EngraveRequest& request);

}  // namespace qrelief
