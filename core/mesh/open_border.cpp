// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/open_border.h"

#include <algorithm>
#include <utility>

namespace qrelief {

OpenBorder::Found OpenBorder::find(const Mesh& mesh) {
  const EdgeTable edges = buildEdgeTable(mesh.triangles);
  Found border;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.at(e).size() != 1) continue;
    const std::uint32_t halfEdge = edges.at(e)[0];
    const Triangle& t = mesh.triangles[halfEdge / 3];
    border.halfEdges.push_back(halfEdge);
    const std::uint32_t from = t[halfEdge % 3], to = t[(halfEdge + 1) % 3];
    border.vertices.insert(border.vertices.end(), {from, to});
    const Vec3f a = mesh.positions[from], b = mesh.positions[to];
    border.boxes.push_back({glm::min(a, b), glm::max(a, b)});
  }
  std::sort(border.vertices.begin(), border.vertices.end());
  border.vertices.erase(std::unique(border.vertices.begin(), border.vertices.end()), border.vertices.end());
  return border;
}

OpenBorder::OpenBorder(const Mesh& mesh) : OpenBorder(mesh, find(mesh)) {}

OpenBorder::OpenBorder(const Mesh& mesh, Found parts)
    : halfEdges_(std::move(parts.halfEdges)),
      vertices_(std::move(parts.vertices)),
      isOpen_(mesh.positions.size(), 0),
      tree_(halfEdges_, parts.boxes) {
  for (const std::uint32_t v : vertices_) isOpen_[v] = 1;
}

std::size_t OpenBorder::findNear(Vec3 point, double reach, std::vector<std::uint32_t>& halfEdges) const {
  halfEdges.clear();
  // Search slightly farther, so that rounding to floats loses nothing.
  const Vec3 margin = reach + 1e-6 * (glm::abs(point) + reach);
  const FloatBox box{Vec3f(point - margin), Vec3f(point + margin)};
  std::vector<std::uint32_t> leaves;
  tree_.findLeaves(box, 0, leaves);
  for (const std::uint32_t leaf : leaves)
    for (std::size_t i = 0; i < tree_.trianglesIn(leaf).size(); ++i)
      if (tree_.boxesIn(leaf)[i].overlaps(box)) halfEdges.push_back(tree_.trianglesIn(leaf)[i]);
  return BoxTree::kLeafSize * leaves.size();
}

}  // namespace qrelief
