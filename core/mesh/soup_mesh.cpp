// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/soup_mesh.h"

#include <utility>
#include <vector>

#include "mesh/weld.h"

namespace qrelief {

Mesh meshOfSoup(const PolygonSoup& soup, double scaleToMm) {
  if (!soup.bodyOf.empty()) {
    std::vector<Vec3f> corners;
    corners.reserve(3 * soup.triangles.size());
    for (const Triangle& t : soup.triangles)
      for (const std::uint32_t v : t) corners.emplace_back(soup.positions[v] * scaleToMm);
    return weldedByGroup(corners, soup.bodyOf);
  }
  std::vector<char> used(soup.positions.size(), 0);
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  std::vector<Vec3f> points;
  std::vector<std::uint32_t> newIndex(used.size(), 0);
  points.reserve(used.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    newIndex[i] = static_cast<std::uint32_t>(points.size());
    points.emplace_back(soup.positions[i] * scaleToMm);
  }
  Welding welding = weldEqual(points);
  Mesh mesh;
  mesh.positions = std::move(welding.positions);
  mesh.triangles.reserve(soup.triangles.size());
  for (const auto& [a, b, c] : soup.triangles)
    mesh.triangles.push_back(
        {welding.indexOf[newIndex[a]], welding.indexOf[newIndex[b]], welding.indexOf[newIndex[c]]});
  return mesh;
}

}  // namespace qrelief
