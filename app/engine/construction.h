// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "pipeline/placement.h"
#include "viewer/line_drawing.h"

namespace qrelief {

/// Colours of the parts of a drawn construction, sRGB.
struct ConstructionColours {
  Vec3f plane{0.08f, 0.40f, 0.84f};
  Vec3f projection{0.56f, 0.30f, 0.82f};
  Vec3f silhouette{0.86f, 0.10f, 0.30f};
  Vec3f square{0.02f, 0.55f, 0.30f};
  Vec3f directions{0.91f, 0.48f, 0.02f};
};

/// How a code was placed, in the terms of [Papp 2022, §3 and §4].
struct Construction {
  ProjectionFrame frame;               ///< the QR plane and the eye of its central projection
  std::vector<Segment2> silhouette;    ///< on the QR plane, mm, as far as it was searched
  std::optional<Vec2> closest;         ///< S, the silhouette's point nearest to the centre; none: it was not met
  double largestMm = 0, squareMm = 0;  ///< largest code, and the square that has to fit for it
  struct Direction {
    Vec3 towards{0};  ///< the viewer, unit
    double varianceMm2 = 0;
  };
  std::vector<Direction> directions;  ///< that the search tried, in their order
  std::optional<std::size_t> chosen;  ///< the one among them that the code has

  /// Returns the point where the arrow of a direction ends, mm.
  Vec3 tip(const Direction& direction) const { return frame.centre + direction.towards * (kArrowShare * squareMm); }

 private:
  static constexpr double kArrowShare = 1.1;  // length of an arrow, in edges of the square
};

/// @param roomFactor  see projection/placement_request.h
Construction constructionOf(const Placement& placement, double roomFactor);

/// Returns the QR plane, the rays from the eye through the corners of the largest square and that square, the
/// silhouette, the circle about C through S, and an arrow for each direction.
/// @param pixelRatio  device pixels in a pixel of the page
LineDrawing drawingOf(const Construction& construction, double pixelRatio);

}  // namespace qrelief
