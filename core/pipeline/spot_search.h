// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "pipeline/coloured_code.h"
#include "pipeline/engravable_model.h"
#include "pipeline/placement.h"
#include "printing/build_direction.h"
#include "projection/spot_candidates.h"
#include "settings/engrave_request.h"

namespace qrelief {

/// Greatest number of spots to request.
inline constexpr std::size_t kMaxSpots = 100;

/// Parameters of a spot search.
struct SpotSearchRequest {
  /// As for engraving; `centreMm` is ignored. SizeMode::Fixed finds spots for that size; all other modes find the spots
  /// for the largest code.
  PlacementRequest placement;
  int modules = 21;              ///< along the symbol's edge; fewer modules need a relatively wider quiet zone
  double minWallMm = 0.8;        ///< material that must remain behind a floor, ≥ 0
  double leastDepthMm = 0.3;     ///< spots whose wall is too thin for pockets of this depth are left out, > 0
  bool offersThinWalls = false;  ///< true: they come last instead, for a mark that may become paint
  std::size_t count = 5;         ///< spots to find, 1 … kMaxSpots
  /// Pose of the model on the printer, to detect spots that face down (kSteepestOverhangDeg). None: no spot faces down.
  std::optional<BuildDirection> buildUp = {};
  std::vector<DirectionalLight> lamps = {};  ///< in addition to the sky; see unevenLight()
  double nozzleMm = 0.4;
  double leastPrintableMm = 0;  ///< edge of the smallest symbol that the nozzle can print; 0: no limit
  /// A code in a second colour: spots where it lies in fewer layers come first, since each such layer costs about one
  /// filament change. None: layers do not matter.
  std::optional<ColouredCode> coloured = {};
  int views = 240;  ///< number of views for the size map, ≥ 200
  /// A size map of the same model, to be used if this search would make it with the same options; may be null.
  std::shared_ptr<const SizeMap> known = nullptr;
  /// File units → mm. A centre is rounded as the user will read it, to about a micrometre, before it is tested.
  double scaleToMm = 1;

  /// Returns the edge of the square that must fit, in edges of the symbol.
  double outerFactor() const { return roomFactor(modules, placement); }
};

/// Returns the number of decimals to which a centre in file units is rounded: to a micrometre or finer, at most 15.
int centreDecimals(double scaleToMm);

/// A spot that takes the code. Placement and wall thickness have been tested for this centre (and direction, if
/// needed).
struct Spot {
  Vec3 centreFileUnits{0};  ///< exact to centreDecimals()
  Vec3 centreMm{0};
  std::uint32_t body = 0;         ///< index of its body (PreparedModel::bodies)
  Vec3 direction{0};              ///< towards the viewer; if needed, a unit vector rounded to four decimals
  bool coversColours = false;     ///< the surface under the code has several colours
  bool facesDown = false;         ///< according to SpotSearchRequest::buildUp
  double unevenLight = 0;         ///< see pipeline/spot_light.h
  bool prints = true;             ///< not smaller than SpotSearchRequest::leastPrintableMm
  bool takesPockets = true;       ///< the wall takes pockets of SpotSearchRequest::leastDepthMm
  bool needsDirection = false;    ///< the request's method finds no direction that fits
  double symbolMm = 0;            ///< the size requested or found
  double largestMm = 0;           ///< see Placement
  double guaranteedMm = 0;        ///< largest size at every rotation
  double aimToleranceDeg = 0;     ///< of the symbol, see projection/flatness.h
  SquareQuality quality;          ///< of the symbol, with its quiet zone if that must fit
  int colourLayers = 0;           ///< layersOfCode(); 0 without SpotSearchRequest::coloured
  std::vector<Message> concerns;  ///< reasons why a code may not print or decode there; empty if none
  std::shared_ptr<const Placement> placement;  ///< as an engraving there finds it, see placedAt()
};

struct SpotSearchResult {
  std::shared_ptr<const SizeMap> map;
  std::vector<Spot> spots;  ///< best first, spots with concerns last; at least one
  std::size_t tried = 0;    ///< number of spots tested
};

/// Finds spots for a code, a bounded piece of work at a time; to cancel, stop calling advance(). Needs the
/// model's GL context, if it has one.
///
/// The size map (projection/size_map.h) proposes spots. Each is tested as in engraving: direction, exact silhouette,
/// wall thickness. The requested direction method is tried first, then, if the code does not fit, the map's direction.
class SpotSearchJob {
 public:
  /// @returns BadUsage for an invalid request; the model's blocking findings
  static Result<std::unique_ptr<SpotSearchJob>> create(std::shared_ptr<const EngravableModel> model,
                                                       const SpotSearchRequest& request);
  ~SpotSearchJob();

  /// Returns the next stage and the fraction of the job that is done.
  Progress progress() const;

  /// Does the next piece of work. Do not call it again after an error or `done`.
  /// @returns at the end, NoSolution if there is no spot; the message names the largest size that fits somewhere
  Result<Progress> advance();

  /// Returns the result. Call it once, after `done`.
  SpotSearchResult takeResult();

 private:
  struct State;
  explicit SpotSearchJob(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Returns the parameters of a spot search for an engraving: its placement, walls and printer.
SpotSearchRequest spotSearchFor(const EngraveRequest& request, const Symbol& symbol);

/// Runs a job to its end.
Result<SpotSearchResult> findSpots(std::shared_ptr<const EngravableModel> model, const SpotSearchRequest& request);

}  // namespace qrelief
