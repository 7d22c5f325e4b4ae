// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/lift.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>

#include "projection/facet_locator.h"

namespace qrelief {
namespace {

class Lifter {
 public:
  Lifter(const Mesh& mesh, const ProjectionFrame& frame, const Footprint& footprint, const Arrangement& arrangement)
      : mesh_(mesh), frame_(frame), footprint_(footprint), arrangement_(arrangement) {}

  LiftedSurface run() {
    collectLevels();
    placeVertices();
    addFloors();
    result_.firstWall = result_.triangles.size();
    for (const Arrangement::Piece& piece : arrangement_.pieces) addWall(piece);
    result_.surfaceVertex = std::move(firstVertex_);
    return std::move(result_);
  }

 private:
  /// Makes a vertex for each pair of a point and the level of a triangle around it.
  void collectLevels() {
    const std::size_t points = arrangement_.points.size();
    std::vector<std::uint32_t> first(points + 1, 0);
    for (const Triangle& t : arrangement_.triangles)
      for (const std::uint32_t p : t) ++first[p + 1];
    for (std::size_t p = 0; p < points; ++p) first[p + 1] += first[p];
    std::vector<int> levels(first.back());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    facetOf_.assign(points, kNoFacet);
    for (std::size_t t = 0; t < arrangement_.triangles.size(); ++t)
      for (const std::uint32_t p : arrangement_.triangles[t]) {
        levels[next[p]++] = arrangement_.levels[t];
        if (arrangement_.facets[t] != Arrangement::kGridFacet) facetOf_[p] = arrangement_.facets[t];
      }
    locateGrid(first);
    firstVertex_.assign(points + 1, 0);
    for (std::uint32_t p = 0; p < points; ++p) {
      const auto begin = levels.begin() + first[p], end = levels.begin() + first[p + 1];
      std::sort(begin, end);
      const auto last = std::unique(begin, end);
      if (begin != last && *begin > 0) result_.vertices.push_back({p, 0});
      for (auto level = begin; level != last; ++level) result_.vertices.push_back({p, *level});
      firstVertex_[p + 1] = static_cast<std::uint32_t>(result_.vertices.size());
    }
  }

  /// Finds the facets under grid nodes whose triangles do not determine one.
  void locateGrid(std::span<const std::uint32_t> firstTriangle) {
    std::optional<FacetLocator> locator;
    for (std::uint32_t p = arrangement_.firstNode; p < arrangement_.firstCrossing; ++p) {
      if (facetOf_[p] != kNoFacet || firstTriangle[p] == firstTriangle[p + 1]) continue;
      if (!locator) {
        std::vector<Triangle2> images;
        images.reserve(footprint_.corners.size());
        for (const Triangle& t : footprint_.corners)
          images.push_back({footprint_.points[t[0]], footprint_.points[t[1]], footprint_.points[t[2]]});
        locator.emplace(std::move(images));
      }
      facetOf_[p] = locator->nearest(arrangement_.points[p]);
    }
  }

  Vec3 basePoint(std::uint32_t point) const {
    if (point < arrangement_.firstNode) return modelPoint(point);
    if (point < arrangement_.firstCrossing) return nodePoint(point);
    return crossingPoint(arrangement_.crossings[point - arrangement_.firstCrossing]);
  }

  Vec3 modelPoint(std::uint32_t local) const { return Vec3(mesh_.positions[footprint_.vertices[local]]); }

  Vec3 nodePoint(std::uint32_t point) const {
    const Triangle& t = footprint_.corners[facetOf_[point]];
    const Vec3 a = modelPoint(t[0]);
    const Vec3 normal = glm::cross(modelPoint(t[1]) - a, modelPoint(t[2]) - a);
    const Vec3 ray = frame_.rayDirection(arrangement_.points[point]);
    return frame_.eye() + ray * (glm::dot(normal, a - frame_.eye()) / glm::dot(normal, ray));
  }

  /// Returns the crossing's point in space. With s the parameter along the projected edge and z the distances of its
  /// ends from the eye's plane, the parameter along the edge in space is s·z_a / (s·z_a + (1 - s)·z_b).
  Vec3 crossingPoint(const Arrangement::Crossing& crossing) const {
    const Footprint::Edge& edge = footprint_.edges[crossing.edge];
    const Vec3 a = modelPoint(edge.a), b = modelPoint(edge.b);
    const double fromA = crossing.alongEdge * frame_.distanceAlongAxis(a);
    const double fromB = (1 - crossing.alongEdge) * frame_.distanceAlongAxis(b);
    return a + (b - a) * (fromA / (fromA + fromB));
  }

  void placeVertices() {
    const Vec3 eye = frame_.eye();
    result_.positions.resize(result_.vertices.size());
    for (std::uint32_t p = 0; p < arrangement_.points.size(); ++p) {
      if (firstVertex_[p] == firstVertex_[p + 1]) continue;
      const Vec3 base = basePoint(p);
      const double distance = glm::length(base - eye);
      for (std::uint32_t v = firstVertex_[p]; v < firstVertex_[p + 1]; ++v) {
        const double depth = depthOfLevel(result_.vertices[v].level);
        result_.positions[v] = Vec3f(depth == 0 ? base : base + (base - eye) * (depth / distance));
      }
    }
  }

  std::uint32_t vertexAt(std::uint32_t point, int level) const {
    std::uint32_t v = firstVertex_[point];
    while (result_.vertices[v].level != level) ++v;
    assert(v < firstVertex_[point + 1]);
    return v;
  }

  void addFloors() {
    for (std::size_t t = 0; t < arrangement_.triangles.size(); ++t) {
      const Triangle& corners = arrangement_.triangles[t];
      const int level = arrangement_.levels[t];
      result_.triangles.push_back(
          {vertexAt(corners[0], level), vertexAt(corners[1], level), vertexAt(corners[2], level)});
    }
  }

  float squaredDistance(std::uint32_t v, std::uint32_t w) const {
    const Vec3f d = result_.positions[v] - result_.positions[w];
    return glm::dot(d, d);
  }

  void addWall(const Arrangement::Piece& piece) {
    const bool pocketLeft = piece.left > piece.right;
    const int top = std::min(piece.left, piece.right), bottom = std::max(piece.left, piece.right);
    const std::uint32_t p = pocketLeft ? piece.from : piece.to, q = pocketLeft ? piece.to : piece.from;
    std::uint32_t i = vertexAt(p, top), j = vertexAt(q, top);
    const std::uint32_t lastI = vertexAt(p, bottom), lastJ = vertexAt(q, bottom);
    while (i < lastI || j < lastJ) {
      const bool alongP = j == lastJ || (i < lastI && squaredDistance(i + 1, j) <= squaredDistance(i, j + 1));
      if (alongP) {
        result_.triangles.push_back({i + 1, i, j}), ++i;
      } else {
        result_.triangles.push_back({j, j + 1, i}), ++j;
      }
    }
  }

  const Mesh& mesh_;
  const ProjectionFrame& frame_;
  const Footprint& footprint_;
  const Arrangement& arrangement_;
  std::vector<std::uint32_t> facetOf_;      // point → any facet around it
  std::vector<std::uint32_t> firstVertex_;  // point → its first vertex
  LiftedSurface result_;
};

}  // namespace

LiftedSurface lift(const Mesh& mesh, const ProjectionFrame& frame, const Footprint& footprint,
                   const Arrangement& arrangement) {
  return Lifter(mesh, frame, footprint, arrangement).run();
}

}  // namespace qrelief
