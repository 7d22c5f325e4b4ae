// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/inlaid_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "carving/needle.h"
#include "mesh/ray_tree.h"
#include "mesh/weld.h"

namespace qrelief {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr double kDepthToleranceMm = 0.005;  // half of the step of depths

class SurfaceFinder {
 public:
  SurfaceFinder(const Mesh& mesh, const ProjectionFrame& frame, int modules, double symbolMm, double depthMm)
      : frame_(frame),
        modules_(modules),
        moduleMm_(symbolMm / modules),
        depthMm_(depthMm),
        toleranceMm_(lowestHeight(mesh.positions)) {
    found_.mesh = welded(mesh.positions, mesh.triangles);
    found_.inlaid = {modules, modules};
  }

  InlaidSurface run() {
    dropInnerFaces();
    projectVertices();
    findRims();
    spreadOverFloors();
    closePockets();
    dropUnused(found_.mesh);
    return std::move(found_);
  }

 private:
  using Pair = std::array<std::uint32_t, 2>;

  /// Returns the pairs of triangles with the same corners in opposite order.
  std::vector<Pair> backToBack() const {
    struct Face {
      std::array<std::uint32_t, 3> corners;  // ascending
      bool isOdd;                            // permutation
      std::uint32_t triangle;
      auto key() const { return std::tie(corners, isOdd, triangle); }
    };
    std::vector<Face> faces;
    const std::vector<Triangle>& triangles = found_.mesh.triangles;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const Triangle& c = triangles[t];
      Face face{{c[0], c[1], c[2]}, (c[0] > c[1]) != ((c[1] > c[2]) != (c[0] > c[2])), t};
      std::sort(face.corners.begin(), face.corners.end());
      faces.push_back(face);
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.key() < b.key(); });
    std::vector<Pair> pairs;
    for (std::size_t k = 0; k + 1 < faces.size(); ++k) {
      if (faces[k].corners != faces[k + 1].corners || faces[k].isOdd == faces[k + 1].isOdd) continue;
      pairs.push_back({faces[k].triangle, faces[k + 1].triangle});
      ++k;
    }
    return pairs;
  }

  /// Returns how far a vertex lies behind the surface that the eye sees, along its ray.
  double depthOf(std::uint32_t v, const RayTree& surface) const {
    const Vec3 p(found_.mesh.positions[v]);
    if (frame_.distanceAlongAxis(p) <= 0) return INFINITY;
    const double far = glm::distance(frame_.eye(), p);
    const auto hit = surface.firstHit(frame_.eye(), (p - frame_.eye()) / far, 0);
    return hit ? far - hit->distance : 0;
  }

  /// Drops the faces between the two bodies: connected pairs that nowhere reach deeper than the inlay.
  void dropInnerFaces() {
    const std::vector<Pair> pairs = backToBack();
    if (pairs.empty()) return;
    std::vector<Triangle>& triangles = found_.mesh.triangles;
    std::vector<std::uint32_t> groupOf(found_.mesh.positions.size());  // a vertex of the same group, or itself
    std::iota(groupOf.begin(), groupOf.end(), 0u);
    const auto group = [&](std::uint32_t v) {
      while (groupOf[v] != v) v = groupOf[v] = groupOf[groupOf[v]];
      return v;
    };
    for (const auto& [one, other] : pairs)
      for (const std::uint32_t v : triangles[one]) groupOf[group(v)] = group(triangles[one][0]);
    const RayTree surface(found_.mesh);
    std::vector<char> isDeep(groupOf.size(), 0);
    for (const auto& [one, other] : pairs)
      for (const std::uint32_t v : triangles[one])
        if (char& deep = isDeep[group(v)]; !deep) deep = depthOf(v, surface) > depthMm_ + kDepthToleranceMm;
    std::vector<char> isInner(triangles.size(), 0);
    for (const auto& [one, other] : pairs) {
      if (isDeep[group(triangles[one][0])]) continue;
      isInner[one] = isInner[other] = 1;
      found_.hasBothBodies = true;
      markModules(triangles[one]);
    }
    std::uint32_t next = 0;
    std::erase_if(triangles, [&](const Triangle&) { return isInner[next++] != 0; });
  }

  void projectVertices() {
    const std::vector<Vec3f>& positions = found_.mesh.positions;
    const double reach = (modules_ / 2.0 + 0.5) * moduleMm_;
    places_.assign(positions.size(), Vec2(0));
    isNear_.assign(positions.size(), 0);
    for (std::size_t v = 0; v < positions.size(); ++v) {
      const Vec3 p(positions[v]);
      if (frame_.distanceAlongAxis(p) <= 0) continue;
      places_[v] = frame_.project(p);
      isNear_[v] = std::abs(places_[v].x) <= reach && std::abs(places_[v].y) <= reach;
    }
  }

  double distance(std::uint32_t v) const { return glm::distance(frame_.eye(), Vec3(found_.mesh.positions[v])); }

  /// Finds the vertices of rims, and of the floors below them, by the edges between them.
  void findRims() {
    rimOf_.assign(places_.size(), kNone);
    isRim_.assign(places_.size(), 0);
    for (std::uint32_t t = 0; t < found_.mesh.triangles.size(); ++t) {
      const Triangle& corners = found_.mesh.triangles[t];
      if (!isNear_[corners[0]] || !isNear_[corners[1]] || !isNear_[corners[2]]) continue;
      bool isWall = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
        if (glm::length(places_[a] - places_[b]) > toleranceMm_) continue;
        const double down = distance(b) - distance(a);
        if (std::abs(std::abs(down) - depthMm_) > kDepthToleranceMm) continue;
        rimOf_[down > 0 ? b : a] = down > 0 ? a : b;
        isRim_[down > 0 ? a : b] = 1;
        isWall = true;
      }
      if (!isWall) others_.push_back(t);
    }
  }

  /// Finds the floors: all triangles that join on to their outer vertices without a wall.
  void spreadOverFloors() {
    isFloor_.assign(places_.size(), 0);
    for (std::size_t v = 0; v < rimOf_.size(); ++v) isFloor_[v] = rimOf_[v] != kNone;
    std::vector<char> isDone(others_.size(), 0);
    for (bool isGrowing = true; isGrowing;) {
      isGrowing = false;
      for (std::size_t k = 0; k < others_.size(); ++k) {
        const Triangle& corners = found_.mesh.triangles[others_[k]];
        if (isDone[k] || !(isFloor_[corners[0]] || isFloor_[corners[1]] || isFloor_[corners[2]])) continue;
        if (isRim_[corners[0]] || isRim_[corners[1]] || isRim_[corners[2]]) continue;
        isDone[k] = 1, isGrowing = true;
        for (const std::uint32_t v : corners) isFloor_[v] = 1;
        markModules(corners);
      }
    }
  }

  void closePockets() {
    for (std::size_t v = 0; v < isFloor_.size(); ++v) {
      if (!isFloor_[v] || rimOf_[v] != kNone) continue;
      const Vec3 p(found_.mesh.positions[v]);
      found_.mesh.positions[v] = Vec3f(p + glm::normalize(frame_.eye() - p) * depthMm_);
    }
    for (Triangle& t : found_.mesh.triangles)
      for (std::uint32_t& v : t)
        if (rimOf_[v] != kNone) v = rimOf_[v];
    std::erase_if(found_.mesh.triangles,
                  [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  }

  /// Marks the modules whose middle lies in the image of a triangle.
  void markModules(const Triangle& corners) {
    std::array<Vec2, 3> at;  // in modules from the top left, to the right and down
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p(found_.mesh.positions[corners[k]]);
      if (frame_.distanceAlongAxis(p) <= 0) return;
      const Vec2 plane = frame_.project(p) / moduleMm_;
      at[k] = {plane.x + modules_ / 2.0, modules_ / 2.0 - plane.y};
    }
    const Vec2 low = glm::min(glm::min(at[0], at[1]), at[2]), high = glm::max(glm::max(at[0], at[1]), at[2]);
    const auto first = [&](double x) { return std::max(0, static_cast<int>(std::ceil(std::max(-1.0, x - 0.5)))); };
    const auto last = [&](double x) {
      return std::min(modules_ - 1, static_cast<int>(std::floor(std::min<double>(modules_, x - 0.5))));
    };
    for (int row = first(low.y); row <= last(high.y); ++row)
      for (int column = first(low.x); column <= last(high.x); ++column) {
        const Vec2 middle(column + 0.5, row + 0.5);
        std::array<double, 3> side{};
        for (std::size_t k = 0; k < 3; ++k) side[k] = cross2(at[(k + 1) % 3] - at[k], middle - at[k]);
        const auto [least, most] = std::minmax_element(side.begin(), side.end());
        if (*least >= 0 || *most <= 0) found_.inlaid.at(row, column) = 1;
      }
  }

  const ProjectionFrame& frame_;
  const int modules_;
  const double moduleMm_, depthMm_, toleranceMm_;
  InlaidSurface found_;
  std::vector<Vec2> places_;           // by vertex: on the QR plane
  std::vector<char> isNear_;           // by vertex: within the symbol or next to it
  std::vector<std::uint32_t> rimOf_;   // vertex of a floor's border → vertex of the rim above it
  std::vector<char> isRim_, isFloor_;  // by vertex
  std::vector<std::uint32_t> others_;  // triangles near the symbol that are no walls
};

}  // namespace

InlaidSurface inlaidSurface(const Mesh& mesh, const ProjectionFrame& frame, int modules, double symbolMm,
                            double depthMm) {
  return SurfaceFinder(mesh, frame, modules, symbolMm, depthMm).run();
}

}  // namespace qrelief
