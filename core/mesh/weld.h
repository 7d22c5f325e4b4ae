// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/polygon_soup.h"

namespace qrelief {

/// Points after equal points are merged, as 32-bit floats; -0 equals 0.
struct Welding {
  std::vector<Vec3f> positions;        ///< in the order of first appearance
  std::vector<std::uint32_t> indexOf;  ///< for each input point, the index of its position
};

/// Welds equal points by an open-addressing hash table; the result does not depend on the hash. Cost: O(n).
/// @param points   finite, fewer than 2^32
/// @param groupOf  point → group; points of different groups stay apart. Empty: one group
Welding weldEqual(std::span<const Vec3f> points, std::span<const std::uint32_t> groupOf = {});

/// Welds a mesh as a slicer reads an STL: corners at one place become one vertex, and every triangle stays.
/// @param triangles  of indices into `corners`
Mesh welded(std::span<const Vec3f> corners, std::vector<Triangle> triangles);

/// Welds a mesh group by group.
/// @param corners  position of each corner: corner k of triangle t is 3·t + k
/// @param groupOf  triangle → group; empty: one group
Mesh weldedByGroup(std::span<const Vec3f> corners, std::span<const std::uint32_t> groupOf);

/// Welds a mesh as a slicer reads its file: equal positions of a piece (piecesOf) become one vertex. A slicer joins
/// touching pieces as it likes, so they stay apart. Vertices come in the order of their first triangles.
/// Cost: O(T).
Mesh weldedByPiece(const Mesh& mesh);

/// Drops positions that no triangle uses, keeping the order, and renumbers the triangles.
void dropUnused(Mesh& mesh);

/// Scales a file's triangles to mm, rounds them to 32-bit floats and welds equal positions within each body. Leaves out
/// positions that no triangle uses. Cost: O(T).
/// @param soup  finite after scaling
Mesh meshOfSoup(const PolygonSoup& soup, double scaleToMm);

}  // namespace qrelief
