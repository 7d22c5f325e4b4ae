// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "projection/silhouette.h"

namespace qrelief {

/// Returns the point of the silhouette nearest to the origin, `S` of [Papp 2022, §4]; ties go to the earlier segment.
/// Empty without a silhouette.
std::optional<Vec2> nearestSilhouettePoint(std::span<const Segment2> silhouette);

/// Returns the edge of the largest square about the origin that lies inside the silhouette at every rotation: √2 ·
/// distance of the closest silhouette point [Papp 2022, §4, figure 4a]. Infinite without a silhouette: then only the
/// searched radius bounds the size (√2 · radius).
double freeSize(std::span<const Segment2> silhouette);

/// Returns the edge of the largest square about the origin with sides along the plane's axes that the silhouette does
/// not enter [Papp 2022, §4, figure 4b, with segments instead of vertices]: 2 · min over the silhouette of max(|u|,
/// |v|). Infinite without a silhouette; valid as long as the square lies within the searched radius (√2 · radius).
double orientedSize(std::span<const Segment2> silhouette);

}  // namespace qrelief
