// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "mesh/box_tree.h"
#include "mesh/collinear.h"
#include "mesh/topology.h"
#include "mesh/triangle_separation.h"
#include "mesh/vertex_stars.h"
#include "message_codes/model.h"

namespace qrelief {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Size of a piece of work, in leaves or in triangles other than suspects: some milliseconds.
constexpr std::size_t kLeavesAPiece = 4096;
constexpr std::size_t kTrianglesAPiece = 1 << 16;

/// Limits of pairs of boxes examined; a tested pair of triangles counts as ten. They allow some seconds for a model of
/// few pieces, otherwise 500 for each triangle of a piece of 4096 leaves. Scans take about 50.
constexpr std::size_t kMaxLooks = 400'000'000, kMaxLooksAPiece = 8'000'000, kLooksATest = 10;

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

/// Two triangles with their shared vertices moved to the front of both; the orientation is lost.
struct Contact {
  Triangle a, b;
  std::size_t shared = 0;

  Contact(const Triangle& first, const Triangle& second) : a(first), b(second) {
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = shared; j < 3; ++j)
        if (a[k] == b[j]) {
          std::swap(a[k], a[shared]);
          std::swap(b[j], b[shared]);
          ++shared;
          break;
        }
  }
};

Corners cornersOf(const Mesh& mesh, const Triangle& t) {
  return {Vec3(mesh.positions[t[0]]), Vec3(mesh.positions[t[1]]), Vec3(mesh.positions[t[2]])};
}

bool certainlyMeetNowhereElse(const Mesh& mesh, const Contact& pair) {
  const Corners a = cornersOf(mesh, pair.a);
  const Corners b = cornersOf(mesh, pair.b);
  switch (pair.shared) {
    case 0:
      return certainlySeparate(a, b);
    case 1:
      return certainlySeparateButForCorner(a, b);
    case 2:
      return certainlySeparateButForEdge(a, b);
    default:
      return false;
  }
}

/// Tests triangles with one common vertex. Anything else they share reaches from that vertex to the opposite edge of
/// one of them.
bool meetBesidesVertex(const Mesh& mesh, const Triangle& a, const Triangle& b) {
  const auto oppositeMeets = [&](const Triangle& t, const Triangle& other) {
    const Kernel::Segment_3 opposite(pointOf(mesh, t[1]), pointOf(mesh, t[2]));
    return CGAL::do_intersect(triangleOf(mesh, other), opposite);
  };
  return oppositeMeets(a, b) || oppositeMeets(b, a);
}

/// Tests triangles with a common edge. They meet elsewhere only if one is folded onto the other in one plane.
bool foldedTogether(const Mesh& mesh, const Triangle& a, const Triangle& b) {
  const auto p = pointOf(mesh, a[0]);
  const auto q = pointOf(mesh, a[1]);
  const auto r = pointOf(mesh, a[2]);
  const auto s = pointOf(mesh, b[2]);
  return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
}

bool meet(const Mesh& mesh, const Triangle& first, const Triangle& second) {
  const Contact pair(first, second);
  if (certainlyMeetNowhereElse(mesh, pair) || !hasArea(mesh, first) || !hasArea(mesh, second)) return false;
  switch (pair.shared) {
    case 0:
      return CGAL::do_intersect(triangleOf(mesh, first), triangleOf(mesh, second));
    case 1:
      return meetBesidesVertex(mesh, pair.a, pair.b);
    case 2:
      return foldedTogether(mesh, pair.a, pair.b);
    default:
      return true;  // the same triangle twice
  }
}

/// Pairs in the order of discovery, up to a limit.
class PairList {
 public:
  /// @param pieces  of the vertices; empty: pairs of any pieces count
  /// @param stars   see simpleStars()
  PairList(const Mesh& mesh, std::span<const std::uint32_t> pieces, std::span<const std::uint8_t> stars,
           std::size_t limit, std::size_t maxLooks)
      : mesh_(mesh), pieces_(pieces), stars_(stars), limit_(limit), maxLooks_(maxLooks) {}

  void look(std::size_t pairs) { looks_ += pairs; }
  void test(std::uint32_t t, std::uint32_t u) {
    if (!pieces_.empty() && pieces_[mesh_.triangles[t][0]] != pieces_[mesh_.triangles[u][0]]) return;
    if (shareSimpleStar(mesh_.triangles[t], mesh_.triangles[u])) return;
    looks_ += kLooksATest;
    if (!full() && meet(mesh_, mesh_.triangles[std::min(t, u)], mesh_.triangles[std::max(t, u)]))
      pairs_.push_back({std::min(t, u), std::max(t, u)});
  }
  bool full() const { return pairs_.size() >= limit_ || gaveUp(); }
  bool gaveUp() const { return looks_ > maxLooks_; }
  const std::vector<TrianglePair>& pairs() const { return pairs_; }

 private:
  bool shareSimpleStar(const Triangle& a, const Triangle& b) const {
    for (const std::uint32_t v : a)
      if ((v == b[0] || v == b[1] || v == b[2]) && stars_[v]) return true;
    return false;
  }

  const Mesh& mesh_;
  std::span<const std::uint32_t> pieces_;
  std::span<const std::uint8_t> stars_;
  std::size_t limit_, maxLooks_;
  std::size_t looks_ = 0;
  std::vector<TrianglePair> pairs_;
};

/// Tests suspects against each other: each leaf against itself and later leaves.
void testAmongLeaves(const BoxTree& tree, std::size_t begin, std::size_t end, PairList& list) {
  std::vector<std::uint32_t> nearby;
  for (std::size_t leaf = begin; leaf < end && !list.full(); ++leaf) {
    tree.findLeaves(tree.boxOfLeaf(leaf), leaf, nearby);
    const auto triangles = tree.trianglesIn(leaf);
    const auto boxes = tree.boxesIn(leaf);
    for (const std::uint32_t other : nearby) {
      if (list.full()) break;
      list.look(BoxTree::kLeafSize * BoxTree::kLeafSize);
      const auto others = tree.trianglesIn(other);
      const auto otherBoxes = tree.boxesIn(other);
      for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = other == leaf ? i + 1 : 0; j < others.size(); ++j)
          if (boxes[i].overlaps(otherBoxes[j])) list.test(triangles[i], others[j]);
    }
  }
}

/// Tests suspects against the other triangles from `begin` to `end`.
void testBystanders(const Mesh& mesh, const BoxTree& tree, std::span<const char> isSuspect, std::uint32_t begin,
                    std::uint32_t end, PairList& list) {
  std::vector<std::uint32_t> nearby;
  for (std::uint32_t t = begin; t < end && !list.full(); ++t) {
    const FloatBox box = boxOfTriangle(mesh, mesh.triangles[t]);
    if (isSuspect[t] || !box.overlaps(tree.bounds())) continue;
    tree.findLeaves(box, 0, nearby);
    list.look(BoxTree::kLeafSize * nearby.size());
    for (const std::uint32_t leaf : nearby) {
      const auto suspects = tree.trianglesIn(leaf);
      const auto boxes = tree.boxesIn(leaf);
      for (std::size_t i = 0; i < suspects.size(); ++i)
        if (box.overlaps(boxes[i])) list.test(t, suspects[i]);
    }
  }
}

/// Finds the pairs in pieces of work that depend on the mesh alone; the limit keeps the first pairs of the first
/// pieces.
Result<std::vector<TrianglePair>> findPairs(const Mesh& mesh, std::span<const std::uint32_t> pieces,
                                            std::span<const std::uint32_t> suspects, std::size_t limit,
                                            std::optional<std::size_t> maxLooks) {
  const bool allSuspect = suspects.size() == mesh.triangles.size();
  const std::vector<std::uint8_t> stars = simpleStars(mesh, allSuspect ? std::span<const std::uint32_t>() : suspects);
  const BoxTree tree(mesh, suspects);
  std::vector<char> isSuspect(allSuspect ? 0 : mesh.triangles.size(), 0);
  if (!allSuspect)
    for (const std::uint32_t t : suspects) isSuspect[t] = 1;

  const std::size_t leafPieces = (tree.leafCount() + kLeavesAPiece - 1) / kLeavesAPiece;
  const std::size_t bystanderPieces =
      allSuspect || suspects.empty() ? 0 : (mesh.triangles.size() + kTrianglesAPiece - 1) / kTrianglesAPiece;
  const std::size_t tasks = leafPieces + bystanderPieces;
  const std::size_t looksAPiece = std::max(kMaxLooksAPiece, kMaxLooks / std::max<std::size_t>(tasks, 1));
  std::vector<PairList> lists(tasks, PairList(mesh, pieces, stars, limit, maxLooks.value_or(looksAPiece)));
  parallelFor(lists.size(), [&](std::size_t task) {
    if (task < leafPieces) {
      const std::size_t begin = task * kLeavesAPiece;
      testAmongLeaves(tree, begin, std::min(begin + kLeavesAPiece, tree.leafCount()), lists[task]);
    } else {
      const std::size_t begin = (task - leafPieces) * kTrianglesAPiece;
      testBystanders(mesh, tree, isSuspect, static_cast<std::uint32_t>(begin),
                     static_cast<std::uint32_t>(std::min(begin + kTrianglesAPiece, mesh.triangles.size())),
                     lists[task]);
    }
  });

  std::vector<TrianglePair> pairs;
  for (const PairList& list : lists) pairs.insert(pairs.end(), list.pairs().begin(), list.pairs().end());
  if (pairs.size() < limit && std::any_of(lists.begin(), lists.end(), [](const PairList& l) { return l.gaveUp(); }))
    return fail(ErrorKind::NoSolution, message<"crossings-too-crowded">());
  if (pairs.size() > limit) pairs.resize(limit);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// @param pieces  see PairList
Result<std::vector<TrianglePair>> findGuarded(const Mesh& mesh, std::span<const std::uint32_t> pieces,
                                              std::span<const std::uint32_t> suspects, std::size_t limit,
                                              std::optional<std::size_t> maxLooks) {
  std::vector<std::uint32_t> all(suspects.empty() ? mesh.triangles.size() : 0);
  std::iota(all.begin(), all.end(), 0u);
  try {
    return findPairs(mesh, pieces, suspects.empty() ? all : suspects, limit, maxLooks);
  } catch (const CGAL::Failure_exception& failure) {
    return fail(ErrorKind::Internal, message<"crossing-test-failed">(with::term<"reason">(failure.what())));
  }
}

}  // namespace

Result<std::vector<TrianglePair>> findCrossings(const Mesh& mesh, std::span<const std::uint32_t> suspects,
                                                std::size_t limit, std::optional<std::size_t> maxLooks) {
  return findGuarded(mesh, {}, suspects, limit, maxLooks);
}

Result<std::vector<TrianglePair>> findSelfIntersections(const Mesh& mesh, std::span<const std::uint32_t> suspects,
                                                        std::size_t limit, std::optional<std::size_t> maxLooks) {
  return findGuarded(mesh, piecesOf(mesh), suspects, limit, maxLooks);
}

}  // namespace qrelief
