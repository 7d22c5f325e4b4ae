// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "projection/size_map.h"

namespace qrelief {

/// Flatness of the surface under a square, seen along the frame's normal.
struct SquareQuality {
  double varianceMm2 = 0;    ///< variance of the heights over the QR plane
  double bendMm = 0;         ///< see flatness.h; computed from the facets' middles
  double worstAngleDeg = 0;  ///< between the surface and the QR plane; a hundredth of the area is steeper
  Vec3 normal{0};            ///< mean of the surface, unit
};

/// Rates the map's facets whose middles lie over the square and that face the viewer; all zero if there is none.
/// Cost: O(T).
SquareQuality qualityOf(const SizeMap& map, const ProjectionFrame& frame, double edgeMm);

/// A promising place according to the map; not yet checked.
struct SpotCandidate {
  Vec3 position{0};   ///< on the map's mesh
  Vec3 direction{0};  ///< unit, towards the viewer
  double sizeMm = 0;  ///< edge of the largest square that fits at every rotation, according to the map
  SquareQuality quality;
};

struct CandidateOptions {
  double edgeMm = 0;     ///< edge of the square, > 0
  double minSizeMm = 0;  ///< smallest size in the map; may be less than the edge, because the map is an estimate
  double enoughMm = std::numeric_limits<double>::infinity();  ///< larger sizes count as this size
  double apart = 0.5;  ///< least distance of two spots, in edges, unless they face away from each other
  std::size_t maxCount = 48;
};

/// Finds well separated spots, best first: the largest sizes, in classes of 10 %. Within a class it ranks by height
/// spread (as a fraction of the edge) plus slope (1 - cosine of the worst angle), least first.
///
/// Cost: O(V log V + maxCount · (V + T)).
std::vector<SpotCandidate> spotCandidates(const SizeMap& map, const CandidateOptions& options);

/// Returns the part of a size that counts. It is less than 1 in two cases. First, where the phone must be held
/// straighter than people do without taking care (10°): the more a surface bends, the smaller a code must be to
/// tolerate that tilt. Second, where the surface is steeper than 50°: a phone 30° aside hardly sees such a surface.
/// @param aimDeg  see aimToleranceDeg()
double countedPart(const SquareQuality& quality, double aimDeg);

/// Returns the part of the map's sizes that counts, mm, for a symbol of version 3 in the square. Rates the surface by a
/// sample of 4000 of its facets.
///
/// Cost: O(V), a few thousand steps for each.
/// @param edgeMm  edge of the largest square that is wanted, > 0
std::vector<float> countedSizes(const SizeMap& map, double edgeMm);

/// Rank of a spot by size, as far as it counts, and quality; smaller is better.
/// @param edgeMm  edge of the square that `quality` describes
/// @param aimDeg  see aimToleranceDeg()
struct SpotRank {
  SpotRank(double sizeMm, const SquareQuality& quality, double edgeMm, double aimDeg);
  bool operator<(const SpotRank& other) const;

  int sizeClass = 0;  ///< classes of 10 %, larger is better
  double badness = 0;
};

}  // namespace qrelief
