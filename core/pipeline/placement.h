// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "mesh/prepare.h"
#include "pipeline/module_walls.h"
#include "pipeline/placement_errors.h"
#include "projection/direction.h"
#include "projection/optimal_direction.h"
#include "projection/placement_request.h"
#include "projection/silhouette.h"
#include "qr/symbol.h"
#include "render/surface_renderer.h"

namespace qrelief {

/// Result of a placement search.
struct Placement {
  ProjectionFrame frame;
  std::uint32_t seed = 0;  ///< triangle under the centre
  double symbolMm = 0;     ///< edge of the symbol without quiet zone, on the QR plane
  double moduleMm = 0;
  double largestMm = 0;  ///< largest symbol up to the size limit that fits at this rotation, walls ignored
  double guaranteedMm =
      0;                   ///< the same at every rotation; with walls counted, as in symbolMm, unless the size is fixed
  double bendMm = 0;       ///< bend of the surface under the symbol, see projection/flatness.h
  double rotationDeg = 0;  ///< from upHint to the symbol's top, anticlockwise as the viewer sees it
  VisiblePatch patch;      ///< covers symbol and quiet zone, and beyondMm more
  std::vector<DirectionIteration> iterations;
};

/// The result of a PlacementSearch.
struct FoundPlacement {
  Placement placement;
  double directionMs = 0, sizeMs = 0;  ///< time to find direction and size
};

/// Search for direction and size. They depend on each other, so it finds them in turn until the size changes by less
/// than 1 % (at most 5 rounds) [Papp 2022, §3 and §4]. Then it searches once for the optimal direction, at the size
/// found, starting from the depth-balanced direction. For SizeMode::Best the round with the largest size wins. Unless
/// that is the size limit, it also looks from the direction that SizeMode::Free finds.
///
/// For DirectionMethod::Largest a pattern search [Hooke, Jeeves 1961] begins at the direction found. It looks from six
/// directions round the best one, 8° away, goes on from the first where the code is larger by at least 0.1 %, and
/// halves the angle where none is, down to 2°; at most 36 looks. It ignores walls, which may then reduce the size.
///
/// Walls too thin for the pockets reduce a found size. From the same direction, with walls counted, a code turned to
/// fit is at least as large as an upright one, and that as one that fits at every rotation.
class PlacementSearch {
 public:
  /// What the error proposes if a fixed size does not fit.
  enum class Advice {
    Turn,  ///< also the rotation at which the largest code fits; this takes another silhouette
    None   ///< only how large a code fits
  };

  /// @param model, surface  kept by reference
  /// @param modules         along the symbol's edge
  PlacementSearch(const PreparedModel& model, const SurfaceRenderer& surface, int modules,
                  const PlacementRequest& request, Advice advice = Advice::Turn);

  /// Does one rendering or one silhouette.
  /// @returns true when done; NoSolution if the code does not fit (the message names the largest that fits)
  Result<bool> step();

  int modules() const { return modules_; }
  /// Returns true if crossing triangles lay within the code from a direction from which it does not fit.
  bool meetsCrossings() const { return meetsCrossings_; }
  /// Returns true if crossing triangles would lie within a larger symbol at the place found.
  bool wouldMeetCrossings(double symbolMm) const;
  const Placement& placement() const { return placement_; }
  /// Returns the result. Call it after step() has returned true.
  FoundPlacement found() const { return {placement_, directionMs_, sizeMs_}; }

 private:
  /// One way in which the code fits.
  struct Fit {
    enum class Turn { EveryRotation, Upright, ToFit };
    Turn turn = Turn::Upright;
    Placement placement;
    bool leavesWalls = false;  ///< false: walls may still reduce its size
  };

  /// State of the search for the direction of the largest code.
  struct Growth {
    Vec3 best{0};
    double bestMm = 0;
    double angleDeg = 0;      ///< of the next looks to `best`
    int side = 0, looks = 0;  ///< looks round `best` at this angle, and all
  };

  Result<bool> find();
  Result<bool> searchOnce();
  Status start();
  Status extend(Fit& fit);
  Status leaveWalls(Fit& fit);
  bool lookFromFree();
  Result<double> sizeAnyWayUp(Vec3 normal);
  Status takeBestFit();
  Status measure(Vec3 normal, Advice advice = Advice::None);
  Result<std::vector<Fit>> fitsFrom(const ProjectionFrame& frame);
  Fit fitIn(VisiblePatch patch, const ProjectionFrame& frame, Fit::Turn turn) const;
  Result<Fit> turnedFit(const VisiblePatch& disc, const ProjectionFrame& frame);
  static Fit& fitToTake(std::vector<Fit>& fits);
  Status measureFirstFitting(std::span<const Vec3> normals);
  std::vector<Vec3> roundCandidates() const;
  FittingSizes fittingSizes(Advice advice);
  Result<std::optional<Vec3>> crossingWithin(double radiusMm) const;
  bool isAtCentre(Vec3 crossing) const;
  Result<bool> refine();
  bool grow();
  Result<VisiblePatch> patchWithin(const ProjectionFrame& frame, double radiusMm, GrowingRegion region,
                                   std::optional<SilhouetteFinder>& finder);
  Result<VisiblePatch> decisivePatch(const ProjectionFrame& frame, GrowingRegion region,
                                     std::optional<SilhouetteFinder>& finder);
  double sizeWithin(std::span<const Segment2> silhouette, GrowingRegion region) const;
  double halfDiagonalMm(double symbolMm) const;
  double largestMm() const;
  double sampledMm() const;
  double outerFactor() const;
  const std::vector<TrianglePair>* knownCrossings() const { return model_->crossings ? &*model_->crossings : nullptr; }
  DirectionOptions directionOptions() const;
  ProjectionFrame frameFor(Vec3 normal) const;

  const PreparedModel* model_;
  const SurfaceRenderer* surface_;
  int modules_;
  PlacementRequest request_;
  Advice advice_;
  Placement placement_;
  Vec3 surfaceNormal_{0};
  std::optional<DirectionSearch> direction_;
  std::optional<OptimalDirection> optimal_;
  std::vector<Fit> fits_;                  // of the last round; SizeMode::Best: of all rounds that fit
  std::unique_ptr<PlacementSearch> free_;  // SizeMode::Best: the search for the free size's direction
  std::optional<Error> doesNotFit_;        // the error of all rounds, if none fits
  std::optional<Growth> growth_;           // DirectionMethod::Largest: the search for a larger code
  int round_ = 0;
  bool started_ = false;
  bool isFound_ = false;  // but for a larger code
  bool meetsCrossings_ = false;
  double fitMm_ = 0;  // symbol size that the last silhouette allows; at first an estimate
  double directionMs_ = 0, sizeMs_ = 0;
};

}  // namespace qrelief
