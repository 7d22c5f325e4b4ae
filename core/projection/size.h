// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>

#include "projection/visible_patch.h"

namespace qrelief {

/// Edge of the largest square about the origin that lies inside the silhouette at any rotation: √2 · distance of the
/// closest silhouette point [Papp 2022, §4, figure 4a]. Infinite without a silhouette.
double freeSize(std::span<const Segment2> silhouette);

/// Edge of the largest square about the origin with sides along the plane's axes that the silhouette does not enter
/// [Papp 2022, §4, figure 4b, with segments instead of vertices]: 2 · min over the silhouette of max(|u|, |v|).
double orientedSize(std::span<const Segment2> silhouette);

}  // namespace qrelief
