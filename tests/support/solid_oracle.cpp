// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/solid_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <map>

#include "math/box.h"
#include "math/orientation.h"

namespace qrelief {
namespace {

/// Returns true if a·b = c·d exactly: both the rounded products and their rounding errors agree.
bool equalProducts(double a, double b, double c, double d) {
  const double ab = a * b, cd = c * d;
  return ab == cd && std::fma(a, b, -ab) == std::fma(c, d, -cd);
}

/// Returns true if a triangle has no area; treats differences of floats as exact in double precision.
bool hasNoArea(Vec3f a, Vec3f b, Vec3f c) {
  const Vec3 u = Vec3(b) - Vec3(a), v = Vec3(c) - Vec3(a);
  return equalProducts(u.x, v.y, u.y, v.x) && equalProducts(u.y, v.z, u.z, v.y) && equalProducts(u.z, v.x, u.x, v.z);
}

using HalfEdge = std::array<std::uint32_t, 2>;  // from, to

std::string edgeProblem(const Mesh& mesh) {
  std::vector<HalfEdge> edges;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    return "two triangles run along an edge the same way";
  for (const HalfEdge& e : edges)
    if (!std::binary_search(edges.begin(), edges.end(), HalfEdge{e[1], e[0]})) return "an edge is open";
  return {};
}

/// Walks once round each vertex; requires correct edges.
std::string vertexProblem(const Mesh& mesh) {
  using Link = std::array<std::uint32_t, 3>;  // vertex, from, to
  std::vector<Link> links;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) links.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
  std::sort(links.begin(), links.end());
  for (std::size_t begin = 0, end = 0; begin < links.size(); begin = end) {
    const std::uint32_t vertex = links[begin][0];
    while (end < links.size() && links[end][0] == vertex) ++end;
    std::size_t steps = 0;
    std::uint32_t at = links[begin][1];
    do {
      at = (*std::lower_bound(links.begin() + static_cast<std::ptrdiff_t>(begin), links.end(), Link{vertex, at, 0}))[2];
      ++steps;
    } while (at != links[begin][1] && steps <= end - begin);
    if (steps != end - begin) return fmt::format("at vertex {} parts touch in a point only", vertex);
  }
  return {};
}

using Corners = std::array<std::array<float, 3>, 3>;

Corners cornersOf(const Mesh& mesh, std::size_t t) {
  Corners corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3f p = mesh.positions[mesh.triangles[t][k]];
    corners[k] = {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};  // -0 is 0
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

int side(const std::array<Vec3, 3>& t, Vec3 p) { return sideOfPlane(t[0], t[1], t[2], p); }

/// Returns true if a segment that is not in the triangle's plane has a point in common with the triangle.
bool meets(Vec3 p, Vec3 q, const std::array<Vec3, 3>& t) {
  const int atP = side(t, p), atQ = side(t, q);
  if (atP * atQ > 0 || (atP == 0 && atQ == 0)) return false;
  bool left = true, right = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const int turn = sideOfPlane(p, q, t[k], t[(k + 1) % 3]);
    left = left && turn >= 0;
    right = right && turn <= 0;
  }
  return left || right;
}

/// Returns true if the inner points of two triangles in one plane overlap, i.e. no side of either separates them.
/// Orientation in the plane is tested against a plane perpendicular to it.
bool overlapInPlane(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t) {
  const Vec3 normal = glm::normalize(glm::cross(s[1] - s[0], s[2] - s[0])) * glm::distance(s[0], s[1]);
  const auto parts = [&](const std::array<Vec3, 3>& x, const std::array<Vec3, 3>& y) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = x[k], b = x[(k + 1) % 3], above = a + normal;
      const int inner = sideOfPlane(a, b, above, x[(k + 2) % 3]);
      if (std::all_of(y.begin(), y.end(), [&](Vec3 p) { return sideOfPlane(a, b, above, p) * inner <= 0; }))
        return true;
    }
    return false;
  };
  return !parts(s, t) && !parts(t, s);
}

bool cross(const Mesh& mesh, std::uint32_t first, std::uint32_t second) {
  const Triangle &a = mesh.triangles[first], &b = mesh.triangles[second];
  const auto points = [&](std::uint32_t t) {
    return std::array{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
  };
  const std::array<Vec3, 3> s = points(first), t = points(second);
  const auto isShared = [](const Triangle& other, std::uint32_t v) {
    return std::find(other.begin(), other.end(), v) != other.end();
  };
  const auto shared = std::count_if(a.begin(), a.end(), [&](std::uint32_t v) { return isShared(b, v); });
  if (std::all_of(t.begin(), t.end(), [&](Vec3 p) { return side(s, p) == 0; })) return overlapInPlane(s, t);
  if (shared >= 2) return false;  // their planes meet in the shared edge
  // With a shared vertex, triangles meet elsewhere only if the side opposite that vertex does.
  const auto anySideMeets = [&](const Triangle& x, const std::array<Vec3, 3>& xs, const Triangle& y,
                                const std::array<Vec3, 3>& ys) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (isShared(y, x[k]) || isShared(y, x[(k + 1) % 3])) continue;
      if (meets(xs[k], xs[(k + 1) % 3], ys)) return true;
    }
    return false;
  };
  return anySideMeets(a, s, b, t) || anySideMeets(b, t, a, s);
}

struct Boxes {
  std::vector<Vec3f> lo, hi;

  explicit Boxes(const Mesh& mesh) {
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3f &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
      lo.push_back(glm::min(p, glm::min(q, r)));
      hi.push_back(glm::max(p, glm::max(q, r)));
    }
  }
  bool meet(std::uint32_t s, std::uint32_t t) const {
    return !glm::any(glm::greaterThan(lo[s], hi[t])) && !glm::any(glm::greaterThan(lo[t], hi[s]));
  }
};

/// Square cells over the region of the suspects, across its shortest side; lists the boxes that meet each cell.
class Cells {
 public:
  static constexpr int kEdge = 160;

  Cells(const Boxes& boxes, const std::vector<std::uint32_t>& suspects) {
    for (const std::uint32_t t : suspects) {
      region_.add(Vec3(boxes.lo[t]));
      region_.add(Vec3(boxes.hi[t]));
    }
    const Vec3 size = region_.size();
    const int shortest = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    axes_ = {(shortest + 1) % 3, (shortest + 2) % 3};
    cells_.resize(kEdge * kEdge);
    for (std::uint32_t t = 0; t < boxes.lo.size(); ++t) {
      const auto [x, y] = cellOf(boxes.lo[t]);
      const auto [lastX, lastY] = cellOf(boxes.hi[t]);
      for (int row = y; row <= lastY; ++row)
        for (int column = x; column <= lastX; ++column)
          cells_[static_cast<std::size_t>(row * kEdge + column)].push_back(t);
    }
  }

  const std::vector<std::uint32_t>& at(int x, int y) const { return cells_[static_cast<std::size_t>(y * kEdge + x)]; }

  /// Returns a point's cell; outside the region, the nearest cell.
  std::array<int, 2> cellOf(Vec3f p) const {
    std::array<int, 2> cell{};
    for (std::size_t k = 0; k < 2; ++k) {
      const int axis = axes_[k];
      const double share = (static_cast<double>(p[axis]) - region_.min[axis]) / region_.size()[axis];
      cell[k] = static_cast<int>(std::clamp(share * kEdge, 0.0, kEdge - 1.0));
    }
    return cell;
  }

 private:
  Box3 region_;
  std::array<int, 2> axes_{};
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace

Mesh meshOfStl(std::span<const std::uint8_t> bytes) {
  Mesh mesh;
  std::map<std::array<float, 3>, std::uint32_t> index;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  if (bytes.size() != 84 + std::size_t{50} * count) return mesh;
  for (std::size_t facet = 0; facet < count; ++facet) {
    std::array<std::array<float, 3>, 3> corners{};
    std::memcpy(corners.data(), bytes.data() + 84 + 50 * facet + 12, sizeof corners);
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (float& x : corners[k]) x += 0.0f;  // -0 is 0
      const auto [entry, isNew] = index.try_emplace(corners[k], static_cast<std::uint32_t>(mesh.positions.size()));
      if (isNew) mesh.positions.emplace_back(corners[k][0], corners[k][1], corners[k][2]);
      triangle[k] = entry->second;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

std::string surfaceProblems(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (hasNoArea(mesh.positions[a], mesh.positions[b], mesh.positions[c]))
      return fmt::format("triangle {} has no area", t);
  }
  std::vector<Triangle> sorted = mesh.triangles;
  for (Triangle& t : sorted) std::sort(t.begin(), t.end());
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return "two triangles have the same corners";
  const std::string problem = edgeProblem(mesh);
  return problem.empty() ? vertexProblem(mesh) : problem;
}

std::vector<std::uint32_t> facetsNotIn(const Mesh& mesh, const Mesh& original) {
  std::vector<Corners> known;
  for (std::size_t t = 0; t < original.triangles.size(); ++t) known.push_back(cornersOf(original, t));
  std::sort(known.begin(), known.end());
  std::vector<std::uint32_t> others;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (!std::binary_search(known.begin(), known.end(), cornersOf(mesh, t))) others.push_back(t);
  return others;
}

std::size_t countCrossings(const Mesh& mesh, const std::vector<std::uint32_t>& suspects) {
  const Boxes boxes(mesh);
  const Cells cells(boxes, suspects);
  std::vector<char> suspected(mesh.triangles.size(), 0);
  for (const std::uint32_t t : suspects) suspected[t] = 1;
  std::size_t crossings = 0;
  for (int y = 0; y < Cells::kEdge; ++y)
    for (int x = 0; x < Cells::kEdge; ++x)
      for (const std::uint32_t s : cells.at(x, y))
        for (const std::uint32_t t : cells.at(x, y)) {
          if (t >= s || (!suspected[s] && !suspected[t]) || !boxes.meet(s, t)) continue;
          // Pairs that share several cells are tested in the first.
          if (cells.cellOf(glm::max(boxes.lo[s], boxes.lo[t])) == std::array{x, y} && cross(mesh, s, t)) ++crossings;
        }
  return crossings;
}

}  // namespace qrelief
