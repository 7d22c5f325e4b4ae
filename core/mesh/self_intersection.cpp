// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>

#include "mesh/box_tree.h"
#include "mesh/collinear.h"

namespace qrelief {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 pointOf(const Mesh& mesh, std::uint32_t vertex) {
  const Vec3f& p = mesh.positions[vertex];
  return {p.x, p.y, p.z};
}

Kernel::Triangle_3 triangleOf(const Mesh& mesh, const Triangle& t) {
  return {pointOf(mesh, t[0]), pointOf(mesh, t[1]), pointOf(mesh, t[2])};
}

bool hasArea(const Mesh& mesh, const Triangle& t) {
  return !collinear(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
}

bool uses(const Triangle& t, std::uint32_t vertex) { return t[0] == vertex || t[1] == vertex || t[2] == vertex; }

/// Triangles with one common vertex: anything else they share reaches from it to the edge opposite it in one of them.
bool meetBesidesVertex(const Mesh& mesh, const Triangle& a, const Triangle& b, std::uint32_t common) {
  const auto oppositeMeets = [&](const Triangle& t, const Triangle& other) {
    const std::size_t k = t[0] == common ? 0 : t[1] == common ? 1 : 2;
    const Kernel::Segment_3 opposite(pointOf(mesh, t[(k + 1) % 3]), pointOf(mesh, t[(k + 2) % 3]));
    return CGAL::do_intersect(triangleOf(mesh, other), opposite);
  };
  return oppositeMeets(a, b) || oppositeMeets(b, a);
}

/// Triangles with a common edge: they meet elsewhere only if one is folded onto the other in one plane.
bool foldedTogether(const Mesh& mesh, const Triangle& a, const Triangle& b) {
  std::array<std::uint32_t, 2> edge{};
  std::size_t n = 0;
  std::uint32_t apexA = a[0];
  for (const std::uint32_t v : a) {
    if (uses(b, v))
      edge[n++] = v;
    else
      apexA = v;
  }
  std::uint32_t apexB = b[0];
  for (const std::uint32_t v : b)
    if (!uses(a, v)) apexB = v;
  const auto p = pointOf(mesh, edge[0]);
  const auto q = pointOf(mesh, edge[1]);
  const auto r = pointOf(mesh, apexA);
  const auto s = pointOf(mesh, apexB);
  return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
}

bool meet(const Mesh& mesh, const Triangle& a, const Triangle& b) {
  std::size_t shared = 0;
  std::uint32_t common = 0;
  for (const std::uint32_t v : a)
    if (uses(b, v)) {
      common = v;
      ++shared;
    }
  if (!hasArea(mesh, a) || !hasArea(mesh, b)) return false;
  switch (shared) {
    case 0:
      return CGAL::do_intersect(triangleOf(mesh, a), triangleOf(mesh, b));
    case 1:
      return meetBesidesVertex(mesh, a, b, common);
    case 2:
      return foldedTogether(mesh, a, b);
    default:
      return true;  // one triangle twice
  }
}

/// @param suspects  ascending
std::vector<TrianglePair> findPairs(const Mesh& mesh, std::span<const std::uint32_t> suspects, std::size_t limit) {
  std::vector<char> isSuspect(mesh.triangles.size(), 0);
  for (const std::uint32_t t : suspects) isSuspect[t] = 1;
  const BoxTree tree(mesh);
  std::vector<TrianglePair> pairs;
  std::vector<std::uint32_t> nearby;
  for (const std::uint32_t t : suspects) {
    tree.findOverlaps(tree.boxOf(t), nearby);
    for (const std::uint32_t other : nearby) {
      if (other == t || (isSuspect[other] && other < t)) continue;  // a pair of suspects is tested once
      if (!meet(mesh, mesh.triangles[t], mesh.triangles[other])) continue;
      if (pairs.size() == limit) return pairs;
      pairs.push_back({std::min(t, other), std::max(t, other)});
    }
  }
  return pairs;
}

}  // namespace

Result<std::vector<TrianglePair>> findSelfIntersections(const Mesh& mesh, std::span<const std::uint32_t> suspects,
                                                        std::size_t limit) {
  std::vector<std::uint32_t> ordered(suspects.begin(), suspects.end());
  if (suspects.empty())
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) ordered.push_back(t);
  std::sort(ordered.begin(), ordered.end());
  try {
    std::vector<TrianglePair> pairs = findPairs(mesh, ordered, limit);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  } catch (const CGAL::Failure_exception& failure) {
    return fail(ErrorCode::Internal, std::string("The test for self-intersections failed: ") + failure.what());
  }
}

}  // namespace qrelief
