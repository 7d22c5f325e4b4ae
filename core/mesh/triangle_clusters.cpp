// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_clusters.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <numeric>
#include <span>

#include "base/parallel.h"

namespace qrelief {
namespace {

/// A surface meets some 6·n² of the n³ cells around it: cells of about 500 triangles.
constexpr double kTrianglesPerSquaredCell = 3000;
constexpr int kMaxCells = 64;  // along an edge

/// Factor that widens the square by more than any rounding error, so that the very edge is drawn as well.
constexpr double kSlack = 1 + 1e-3;

constexpr double kAngleSlack = 1e-4;  // more than any rounding error of a normal

/// Finds the cone of a cluster's normals. Triangles without area face no eye and do not count.
void setCone(const Mesh& mesh, std::span<const Triangle> triangles, TriangleCluster& cluster) {
  std::vector<Vec3> normals;
  Vec3 sum(0);
  for (const Triangle& t : triangles) {
    const Vec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    const Vec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    normals.push_back(normal / length);
    sum += normals.back();
  }
  const double length = glm::length(sum);
  if (!(length > 0)) return;
  cluster.axis = sum / length;
  double least = 1;
  for (const Vec3 normal : normals) least = std::min(least, glm::dot(normal, cluster.axis));
  cluster.spread = std::min(std::numbers::pi, std::acos(std::clamp(least, -1.0, 1.0)) + kAngleSlack);
}

}  // namespace

/// @param awayFromEye  the cone's axis, or its opposite
bool TriangleCluster::turnsTo(Vec3 eye, Vec3 awayFromEye) const {
  const Vec3 fromEye = (box.min + box.max) / 2.0 - eye;
  const double distance = glm::length(fromEye), radius = glm::length(box.size()) / 2;
  if (distance <= radius) return false;
  const double towards = std::acos(std::clamp(glm::dot(fromEye, awayFromEye) / distance, -1.0, 1.0));
  return towards + spread + std::asin(radius / distance) < std::numbers::pi / 2;
}

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
  parallelFor(result.clusters.size(), [&](std::size_t k) {
    TriangleCluster& cluster = result.clusters[k];
    setCone(mesh, std::span(result.triangles).subspan(cluster.begin, cluster.end - cluster.begin), cluster);
  });
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
