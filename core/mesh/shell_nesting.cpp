// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/shell_nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vector_relational.hpp>

namespace qrelief {
namespace {

constexpr std::size_t kMaxShells = 4000;  // all pairs of boxes are compared
constexpr int kPointsPerShell = 3;

struct Shell {
  Box3 box;
  std::vector<std::uint32_t> triangles;
};

bool contains(const Box3& outer, const Box3& inner) {
  return glm::all(glm::lessThanEqual(outer.min, inner.min)) && glm::all(glm::lessThanEqual(inner.max, outer.max));
}

/// Returns true if the line from q to +x crosses the edge ab, seen from above. The ends are sorted first, so both
/// triangles of an edge get the same answer.
bool crossesRightOf(Vec3 a, Vec3 b, Vec3 q) {
  if ((a.y > q.y) == (b.y > q.y)) return false;
  if (std::array{b.y, b.x, b.z} < std::array{a.y, a.x, a.z}) std::swap(a, b);
  return a.x + (q.y - a.y) * (b.x - a.x) / (b.y - a.y) > q.x;
}

/// Returns true if the vertical ray upwards from q crosses the triangle.
bool crossesAbove(Vec3 a, Vec3 b, Vec3 c, Vec3 q) {
  if ((crossesRightOf(a, b, q) ^ crossesRightOf(b, c, q) ^ crossesRightOf(c, a, q)) == 0) return false;
  const Vec3 n = glm::cross(b - a, c - a);
  const double z = n.z != 0 ? a.z - (n.x * (q.x - a.x) + n.y * (q.y - a.y)) / n.z : (a.z + b.z + c.z) / 3;
  return z > q.z;
}

/// A point of a shell that may lie in another shell.
struct Query {
  Vec3 point;
  std::uint32_t shell;
  int crossings = 0;
};

Vec3 centroid(const Mesh& mesh, std::uint32_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
}

/// Counts the crossings of all queries, sorted by x, with one shell.
/// @returns pairs examined
std::size_t countCrossings(const Mesh& mesh, const Shell& shell, std::vector<Query>& queries) {
  std::size_t looks = 0;
  for (const std::uint32_t t : shell.triangles) {
    const Vec3 a = mesh.corner(t, 0);
    const Vec3 b = mesh.corner(t, 1);
    const Vec3 c = mesh.corner(t, 2);
    const double right = std::max({a.x, b.x, c.x});
    auto query = std::lower_bound(queries.begin(), queries.end(), std::min({a.x, b.x, c.x}),
                                  [](const Query& q, double x) { return q.point.x < x; });
    for (; query != queries.end() && query->point.x <= right; ++query, ++looks)
      query->crossings += crossesAbove(a, b, c, query->point);
  }
  return looks;
}

std::vector<Shell> gather(const Mesh& mesh, const Shells& shells, const std::vector<char>& closed) {
  std::vector<Shell> gathered(shells.count);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!closed[shells.of[t]]) continue;
    Shell& shell = gathered[shells.of[t]];
    shell.triangles.push_back(t);
    for (int k = 0; k < 3; ++k) shell.box.add(mesh.corner(t, k));
  }
  return gathered;
}

}  // namespace

ShellNesting enclosingShells(const Mesh& mesh, const Shells& shells, const std::vector<char>& closed,
                             std::size_t maxCrossings) {
  ShellNesting nesting;
  nesting.enclosing.resize(shells.count);
  const ShellNesting unknown{nesting.enclosing, false};
  const auto closedCount = std::count(closed.begin(), closed.end(), 1);
  if (closedCount < 2) return nesting;
  if (closedCount > static_cast<std::ptrdiff_t>(kMaxShells)) return unknown;
  std::size_t looks = 0;
  const std::vector<Shell> gathered = gather(mesh, shells, closed);
  for (std::uint32_t outer = 0; outer < shells.count; ++outer) {
    if (!closed[outer]) continue;
    std::vector<Query> queries;
    for (std::uint32_t inner = 0; inner < shells.count; ++inner) {
      if (inner == outer || !closed[inner] || !contains(gathered[outer].box, gathered[inner].box)) continue;
      const std::vector<std::uint32_t>& triangles = gathered[inner].triangles;
      for (std::size_t i = 0; i < kPointsPerShell; ++i)
        queries.push_back({centroid(mesh, triangles[i * triangles.size() / kPointsPerShell]), inner, 0});
    }
    if (queries.empty()) continue;
    std::stable_sort(queries.begin(), queries.end(),
                     [](const Query& a, const Query& b) { return a.point.x < b.point.x; });
    looks += countCrossings(mesh, gathered[outer], queries);
    if (looks > maxCrossings) return unknown;
    std::vector<int> votes(shells.count, 0);
    for (const Query& query : queries) votes[query.shell] += query.crossings & 1;
    for (std::uint32_t inner = 0; inner < shells.count; ++inner)
      if (2 * votes[inner] > kPointsPerShell) nesting.enclosing[inner].push_back(outer);
  }
  return nesting;
}

}  // namespace qrelief
