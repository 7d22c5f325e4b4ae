// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "pipeline/engravable_model.h"
#include "printing/build_direction.h"
#include "projection/spot_candidates.h"

namespace qrelief {

/// Spots that may be asked for.
inline constexpr std::size_t kMaxSpots = 100;

/// What is to find a place.
struct SpotSearchRequest {
  /// As for engraving; `centreMm` does not count. With SizeMode::Fixed spots that take that size are found, else those
  /// that take the largest.
  PlacementRequest placement;
  int modules = 21;           ///< of the symbol along its edge; the fewer, the wider the quiet zone beside them
  double minWallMm = 0.8;     ///< material that must remain behind a floor, ≥ 0
  double leastDepthMm = 0.3;  ///< a spot whose wall does not take pockets of this depth is not offered, > 0
  std::size_t count = 5;      ///< spots to find, 1 … kMaxSpots
  /// Pose of the model on the printer, in which spots may face down (kSteepestOverhangDeg). None: no spot faces down.
  std::optional<BuildDirection> buildUp = {};
  double nozzleMm = 0.4;
  double leastPrintableMm = 0;  ///< edge of the smallest symbol that the nozzle can print; 0: no limit
  int views = 240;              ///< of the size map, ≥ 200
  /// File units → mm: a centre is rounded to what a user will read, about a micrometre, before it is tested.
  double scaleToMm = 1;

  /// Edge of what must fit, in edges of the symbol.
  double outerFactor() const { return roomFactor(modules, placement.quietZone); }
};

/// Decimals that a centre in file units is rounded to: a micrometre or finer, at most 15.
int centreDecimals(double scaleToMm);

/// A spot that takes the code: engraving with this centre (and this direction, where it is needed) has been tried as
/// far as placement and wall thickness go.
struct OfferedSpot {
  Vec3 centreFileUnits{0};  ///< exact to centreDecimals()
  Vec3 centreMm{0};
  Vec3 direction{0};              ///< towards the reader; where it is needed, unit but for four decimals
  bool facesDown = false;         ///< as SpotSearchRequest::buildUp says
  double unevenLight = 0;         ///< see pipeline/spot_light.h
  bool prints = true;             ///< is not smaller than SpotSearchRequest::leastPrintableMm
  bool needsDirection = false;    ///< the request's method alone finds no direction from which the code fits
  double symbolMm = 0;            ///< the size asked for, or the one found
  double largestMm = 0;           ///< that fits there, from that direction, at the rotation asked for
  double guaranteedMm = 0;        ///< at every rotation
  double aimToleranceDeg = 0;     ///< of the symbol, see projection/bend.h
  SquareQuality quality;          ///< of the symbol with its quiet zone, if that must fit
  std::vector<Message> concerns;  ///< reasons why a code may not print or decode there; empty if none is known
};

struct SpotSearchResult {
  SizeMap map;
  std::vector<OfferedSpot> spots;  ///< best first, spots with concerns last; at least one
  std::size_t tried = 0;           ///< spots that were tested
};

/// Finds where a code can go, a bounded piece of work at a time; to cancel, stop calling. Needs the GL context of the
/// model.
///
/// The size map (projection/size_map.h) proposes, and every proposal is tested as engraving will test it:
/// direction, exact silhouette, wall thickness. First with the direction method asked for; where the code does not fit
/// so, with the direction of the map.
class SpotSearchJob {
 public:
  /// @returns BadUsage for a request that makes no sense; a model's blocking findings
  static Result<std::unique_ptr<SpotSearchJob>> create(std::shared_ptr<const EngravableModel> model,
                                                       SpotSearchRequest request);
  ~SpotSearchJob();

  /// The next piece. @returns at the end NoSolution if there is no spot, with the largest size that fits somewhere.
  /// After an error or `done` it must not be called again.
  Result<Progress> advance();

  /// The map as far as it is known; complete when the first spot is tested.
  const SizeMap& map() const;

  /// The result, once, after `done`.
  SpotSearchResult takeResult();

 private:
  struct State;
  explicit SpotSearchJob(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Parameters of a spot search for an engraving: its placement, walls and printer.
SpotSearchRequest spotSearchFor(const EngraveRequest& request, const Symbol& symbol);

/// Runs a job to its end.
Result<SpotSearchResult> findSpots(std::shared_ptr<const EngravableModel> model, const SpotSearchRequest& request);

}  // namespace qrelief
