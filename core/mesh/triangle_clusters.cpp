// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_clusters.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <numeric>

namespace qrelief {
namespace {

/// A surface meets some 6·n² of the n³ cells around it: cells of about 500 triangles.
constexpr double kTrianglesPerSquaredCell = 3000;
constexpr int kMaxCells = 64;  // along an edge

/// Factor that widens the square by more than any rounding error, so that the very edge is drawn as well.
constexpr double kSlack = 1 + 1e-3;

}  // namespace

ClusteredTriangles clusterTriangles(const Mesh& mesh) {
  const Box3 box = boundingBox(mesh);
  const double cellsAlongAnEdge = std::sqrt(static_cast<double>(mesh.triangles.size()) / kTrianglesPerSquaredCell);
  const int n = static_cast<int>(std::clamp(std::round(cellsAlongAnEdge), 1.0, double{kMaxCells}));
  const Vec3 perMm = Vec3(n) / glm::max(box.size(), Vec3(1e-9));
  const auto cellOf = [&](const Triangle& t) {
    const Vec3 middle = (Vec3(mesh.positions[t[0]]) + Vec3(mesh.positions[t[1]]) + Vec3(mesh.positions[t[2]])) / 3.0;
    const Vec3 cell = glm::min((middle - box.min) * perMm, Vec3(n - 1));
    return static_cast<std::size_t>((static_cast<int>(cell.z) * n + static_cast<int>(cell.y)) * n +
                                    static_cast<int>(cell.x));
  };

  std::vector<TriangleCluster> cells(static_cast<std::size_t>(n) * static_cast<std::size_t>(n * n));
  std::vector<std::uint32_t> cellOfTriangle;
  cellOfTriangle.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const std::size_t cell = cellOf(t);
    cellOfTriangle.push_back(static_cast<std::uint32_t>(cell));
    ++cells[cell].end;  // counts first; turned into an end below
    for (const std::uint32_t v : t) cells[cell].box.add(Vec3(mesh.positions[v]));
  }
  std::uint32_t begin = 0;
  for (TriangleCluster& cell : cells) {
    const std::uint32_t count = cell.end;
    cell.begin = cell.end = begin;
    begin += count;
  }
  ClusteredTriangles result;
  result.triangles.resize(mesh.triangles.size());
  result.origins.resize(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t at = cells[cellOfTriangle[t]].end++;
    result.triangles[at] = mesh.triangles[t];
    result.origins[at] = t;
  }
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(result.clusters),
               [](const TriangleCluster& cell) { return cell.begin < cell.end; });
  return result;
}

ClusteredTriangles oneCluster(const Mesh& mesh) {
  ClusteredTriangles result{mesh.triangles, std::vector<std::uint32_t>(mesh.triangles.size()), {}};
  std::iota(result.origins.begin(), result.origins.end(), 0u);
  if (!mesh.triangles.empty())
    result.clusters.push_back({boundingBox(mesh), 0, static_cast<std::uint32_t>(mesh.triangles.size())});
  return result;
}

ViewPyramid::ViewPyramid(const ProjectionFrame& frame, double extentMm) : eye_(frame.eye()) {
  const Vec3 forwards = -frame.normal * (kSlack * extentMm / 2 / frame.eyeDistance);
  inwards_ = {forwards + frame.right, forwards - frame.right, forwards + frame.up, forwards - frame.up};
}

bool ViewPyramid::mayMeet(const Box3& box) const {
  return std::all_of(inwards_.begin(), inwards_.end(), [&](Vec3 inwards) {
    const Vec3 farthest = glm::mix(box.min, box.max, glm::greaterThan(inwards, Vec3(0)));
    return glm::dot(inwards, farthest - eye_) >= 0;
  });
}

}  // namespace qrelief
