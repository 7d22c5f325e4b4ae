// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/polygon_soup.h"

namespace qrelief {

/// Scales a file's triangles to mm, rounds them to 32-bit floats and welds equal positions within each body. Leaves out
/// positions that no triangle uses. Cost: O(T).
/// @param soup  finite after scaling
Mesh meshOfSoup(const PolygonSoup& soup, double scaleToMm);

}  // namespace qrelief
