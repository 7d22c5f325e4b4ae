// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/result.h"
#include "mesh/prepare.h"
#include "projection/direction.h"
#include "projection/visible_patch.h"
#include "qr/symbol.h"
#include "render/geometry_pass.h"

namespace qrelief {

enum class SizeMode {
  Free,      ///< the largest that fits at every rotation
  Oriented,  ///< the largest that fits at the rotation asked for
  Fixed      ///< the size asked for, or an error that names the largest
};

/// Where the code goes, which way it looks and how large it is.
struct PlacementRequest {
  Vec3 centreMm{0};  ///< moved to the nearest surface point
  SizeMode sizeMode = SizeMode::Free;
  double sizeMm = 0;      ///< Fixed: edge of the symbol without quiet zone, > 0
  double knownMarginMm = 0;  ///< the surface is looked at so much farther than the code reaches, ≥ 0
  double maxSizeMm = 60;  ///< upper bound of a found size, > 0
  bool quietZone = true;  ///< the quiet zone must fit, too
  Vec3 upHint{0, 0, 1};   ///< where the symbol's top points, projected onto the QR plane
  double rotateDeg = 0;   ///< then turned anticlockwise, as the reader sees it
  DirectionMethod directionMethod = DirectionMethod::DepthBalanced;
  std::optional<Vec3> direction;  ///< towards the reader; overrides the method
  double eyeDistanceMm = 250;     ///< > 0
};

/// The answer.
struct Placement {
  ProjectionFrame frame;
  std::uint32_t seed = 0;  ///< triangle under the centre
  double symbolMm = 0;     ///< edge of the symbol without quiet zone, on the QR plane
  double moduleMm = 0;
  double guaranteedMm = 0;  ///< largest symbol that fits at every rotation, not cut by maxSizeMm
  VisiblePatch patch;       ///< covers symbol and quiet zone
  std::vector<DirectionIteration> iterations;
};

/// Finds direction and size, which depend on each other: they are found in turn until the size moves by less than 1 %
/// (at most 5 rounds) [Papp 2022, §3 and §4].
class PlacementSearch {
 public:
  /// @param model, gpu, pass  kept by reference
  /// @param modules           of the symbol along its edge
  PlacementSearch(const PreparedModel& model, const GpuMesh& gpu, const GeometryPass& pass, int modules,
                  const PlacementRequest& request);

  /// One rendering or one silhouette. @returns true when done; NoSolution where no code fits (says the largest that
  /// does)
  Result<bool> step();

  const Placement& placement() const { return placement_; }
  double directionMs() const { return directionMs_; }
  double sizeMs() const { return sizeMs_; }

 private:
  Status start();
  Status measure(Vec3 normal);
  Status measureBestDirection();
  double outerFactor() const;
  ProjectionFrame frameFor(Vec3 normal) const;

  const PreparedModel* model_;
  const GpuMesh* gpu_;
  const GeometryPass* pass_;
  int modules_;
  PlacementRequest request_;
  Placement placement_;
  Vec3 surfaceNormal_{0};
  std::optional<DirectionSearch> direction_;
  int round_ = 0;
  bool started_ = false;
  double fitMm_ = 0;  // symbol size that the last silhouette allows
  double directionMs_ = 0, sizeMs_ = 0;
};

}  // namespace qrelief
