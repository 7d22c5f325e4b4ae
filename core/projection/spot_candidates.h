// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "projection/size_map.h"

namespace qrelief {

/// How a square lies on a surface, seen along its frame's normal.
struct SquareQuality {
  double varianceMm2 = 0;    ///< variance of the heights over the QR plane
  double bendMm = 0;         ///< see bend.h; of the facets' middles
  double worstAngleDeg = 0;  ///< between the surface and the QR plane; a hundredth of the area is steeper
};

/// Of the map's facets whose middles lie over the square and that face the reader; all zero if there is none.
/// Cost: O(T).
SquareQuality qualityOf(const SizeMap& map, const ProjectionFrame& frame, double edgeMm);

/// A place that the map thinks well of; still to be tested.
struct SpotCandidate {
  Vec3 position{0};   ///< on the map's mesh
  Vec3 direction{0};  ///< unit, towards the reader
  double sizeMm = 0;  ///< edge of the largest square, at every rotation, by the map
  SquareQuality quality;
};

struct CandidateOptions {
  double edgeMm = 0;     ///< of the square looked for, > 0
  double minSizeMm = 0;  ///< by the map; a map may err, so this may be less than the edge
  double enoughMm = std::numeric_limits<double>::infinity();  ///< sizes beyond it are as good as it
  double apart = 0.5;  ///< least distance of two spots that do not look away from each other, in edges
  std::size_t maxCount = 48;
};

/// Well separated spots, best first: the largest sizes, in classes of 10 %; in a class those with the least spread of
/// heights (as a fraction of the edge) and slope (1 - cosine of the worst angle) together.
///
/// Cost: O(V log V + most · (V + T)).
std::vector<SpotCandidate> spotCandidates(const SizeMap& map, const CandidateOptions& options);

/// The order of spots by size and quality; smaller is better. A spot counts as less large, in proportion, where it has
/// to be looked at more straight than hands hold a phone without care (10°; the more a surface bends under a code, the
/// smaller the code must be to forgive so much), and where it is steeper than 50°: a phone 30° aside hardly sees that.
/// @param edgeMm  of the square that `quality` is of
/// @param aimDeg  see aimToleranceDeg()
struct SpotRank {
  SpotRank(double sizeMm, const SquareQuality& quality, double edgeMm, double aimDeg);
  bool operator<(const SpotRank& other) const;

  int sizeClass = 0;  ///< classes of 10 %, larger is better
  double badness = 0;
};

}  // namespace qrelief
