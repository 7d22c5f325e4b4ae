// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/untangle.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "math/tolerance.h"
#include "mesh/box_tree.h"
#include "mesh/collinear.h"
#include "mesh/crossing_segments.h"
#include "mesh/self_intersection.h"
#include "mesh/topology.h"
#include "message_codes/model.h"

namespace qrelief {
namespace {

constexpr std::size_t kMaxMended = 100;      // more pairs mean overlapping parts, not scanner errors
constexpr int kHalvings = 7;                 // of the largest move; below 40 nm 32-bit floats differ by chance
constexpr std::size_t kMaxWork = 1'000'000;  // triangles tested in all tries together: about 2 s

struct Move {
  std::uint32_t vertex;
  Vec3f to;
  double length;  // mm
};

bool contains(const std::vector<std::uint32_t>& ascending, std::uint32_t v) {
  return std::binary_search(ascending.begin(), ascending.end(), v);
}

bool usesAny(const Triangle& t, const std::vector<std::uint32_t>& ascending) {
  return contains(ascending, t[0]) || contains(ascending, t[1]) || contains(ascending, t[2]);
}

/// Returns the vertices of the first pair and of all pairs connected with it, ascending.
std::vector<std::uint32_t> firstTangle(const Mesh& mesh, const std::vector<TrianglePair>& pairs) {
  const Triangle& first = mesh.triangles[pairs.front()[0]];
  std::vector<std::uint32_t> vertices(first.begin(), first.end());
  std::sort(vertices.begin(), vertices.end());
  for (std::size_t size = 0; size != vertices.size();) {
    size = vertices.size();
    for (const auto& [t, u] : pairs) {
      const Triangle& a = mesh.triangles[t];
      const Triangle& b = mesh.triangles[u];
      if (!usesAny(a, vertices) && !usesAny(b, vertices)) continue;
      vertices.insert(vertices.end(), a.begin(), a.end());
      vertices.insert(vertices.end(), b.begin(), b.end());
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
  }
  return vertices;
}

/// All triangles that can meet a triangle at the tangle, wherever its vertices move: their boxes lie within reach of
/// the moves. Vertices keep their order.
struct Surroundings {
  Mesh mesh;
  std::vector<std::uint32_t> vertices;  ///< their indices in the whole mesh, ascending
  std::vector<std::uint32_t> tangle;    ///< in `mesh`
  std::vector<std::uint32_t> pieces;    ///< of its vertices, in the whole mesh; see piecesOf()

  std::uint32_t indexOf(std::uint32_t v) const {
    return static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  }
};

/// @param pieces  of the mesh's vertices
Surroundings surroundingsOf(const Mesh& mesh, std::span<const std::uint32_t> pieces,
                            const std::vector<std::uint32_t>& tangle) {
  Box3 box;
  for (const Triangle& t : mesh.triangles)
    if (usesAny(t, tangle))
      for (const std::uint32_t v : t) box.add(Vec3(mesh.positions[v]));
  const double margin = 1.01 * kMaxRepairMoveMm;  // a hundredth more, for rounding
  const FloatBox region{Vec3f(box.min - margin), Vec3f(box.max + margin)};
  Surroundings around;
  for (const Triangle& t : mesh.triangles)
    if (boxOfTriangle(mesh, t).overlaps(region)) {
      around.mesh.triangles.push_back(t);
      around.vertices.insert(around.vertices.end(), t.begin(), t.end());
    }
  std::sort(around.vertices.begin(), around.vertices.end());
  around.vertices.erase(std::unique(around.vertices.begin(), around.vertices.end()), around.vertices.end());
  for (const std::uint32_t v : around.vertices) {
    around.mesh.positions.push_back(mesh.positions[v]);
    around.pieces.push_back(pieces[v]);
  }
  for (Triangle& t : around.mesh.triangles)
    for (std::uint32_t& v : t) v = around.indexOf(v);
  for (const std::uint32_t v : tangle) around.tangle.push_back(around.indexOf(v));
  return around;
}

/// Adds the possible moves of one vertex of the tangle: towards the mean of its neighbours, in space and along its
/// normal.
void addMoves(const Mesh& mesh, std::uint32_t v, Vec3 normal, std::vector<Move>& moves) {
  const Vec3 from(mesh.positions[v]);
  Vec3 sum(0);
  double lengths = 0;
  double n = 0;
  for (const Triangle& t : mesh.triangles) {
    if (t[0] != v && t[1] != v && t[2] != v) continue;
    for (const std::uint32_t w : t) {  // a neighbour counts twice, once for each triangle at the edge
      if (w == v) continue;
      sum += Vec3(mesh.positions[w]);
      lengths += glm::distance(Vec3(mesh.positions[w]), from);
      ++n;
    }
  }
  const Vec3 toMean = sum / n - from;
  const double limit = std::min(kUntangleEdgeFraction * lengths / n, kMaxRepairMoveMm);
  for (const Vec3 way : {toMean, normal * glm::dot(toMean, normal)})
    if (const double whole = glm::length(way); whole > 0)
      for (int halvings = 0; halvings < kHalvings; ++halvings) {
        const double wanted = std::ldexp(std::min(whole, limit), -halvings);
        const Vec3f to(from + way * (wanted / whole));
        const double length = glm::distance(Vec3(to), from);
        if (length > 0) moves.push_back({v, to, length});
      }
}

/// Returns all moves, the shortest first; ties by vertex.
std::vector<Move> movesOf(const Surroundings& around) {
  const std::vector<Vec3f> normals = vertexNormals(around.mesh);
  std::vector<Move> moves;
  for (const std::uint32_t v : around.tangle) addMoves(around.mesh, v, Vec3(normals[v]), moves);
  std::stable_sort(moves.begin(), moves.end(), [](const Move& a, const Move& b) { return a.length < b.length; });
  return moves;
}

bool allHaveArea(const Mesh& mesh) {
  return std::none_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return collinear(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
  });
}

bool isTooCrowded(const Result<std::vector<TrianglePair>>& pairs) {
  return !pairs && pairs.error().kind == ErrorKind::NoSolution;
}

/// Finds the pairs that findSelfIntersections() finds in the whole mesh: pieces may be joined outside the surroundings.
/// @returns NoSolution if there are too many to examine
Result<std::vector<TrianglePair>> selfIntersectionsIn(const Surroundings& around) {
  auto pairs = findCrossings(around.mesh, {}, kMaxCrossingsListed);
  QRELIEF_TRY(pairs);
  if (pairs->size() == kMaxCrossingsListed) return fail(ErrorKind::NoSolution, message<"crossings-too-crowded">());
  std::erase_if(*pairs, [&](const TrianglePair& pair) {
    return around.pieces[around.mesh.triangles[pair[0]][0]] != around.pieces[around.mesh.triangles[pair[1]][0]];
  });
  return pairs;
}

/// Separates the tangle by the shortest move that removes all its pairs and creates no other.
/// @param work  triangles tested so far, in all tries
/// @returns true if there is such a move
Result<bool> part(Mesh& mesh, std::span<const std::uint32_t> pieces, const std::vector<std::uint32_t>& tangle,
                  std::size_t& work) {
  Surroundings around = surroundingsOf(mesh, pieces, tangle);
  auto others = selfIntersectionsIn(around);
  if (isTooCrowded(others)) return false;
  QRELIEF_TRY(others);
  const auto ofTangle = [&](const TrianglePair& pair) {
    return usesAny(around.mesh.triangles[pair[0]], around.tangle) ||
           usesAny(around.mesh.triangles[pair[1]], around.tangle);
  };
  const auto end = std::remove_if(others->begin(), others->end(), ofTangle);
  if (end == others->end()) return true;  // already separated together with another tangle
  others->erase(end, others->end());

  for (const Move& move : movesOf(around)) {
    work += around.mesh.triangles.size();
    if (work > kMaxWork) return false;
    const Vec3f from = std::exchange(around.mesh.positions[move.vertex], move.to);
    const auto left = selfIntersectionsIn(around);
    if (isTooCrowded(left)) return false;
    QRELIEF_TRY(left);
    if (std::includes(others->begin(), others->end(), left->begin(), left->end()) && allHaveArea(around.mesh)) {
      mesh.positions[around.vertices[move.vertex]] = move.to;
      return true;
    }
    around.mesh.positions[move.vertex] = from;
  }
  return false;
}

}  // namespace

Result<Untangling> untangle(Mesh& mesh) {
  auto pairs = findSelfIntersections(mesh, {}, kMaxCrossingsListed);
  Untangling result;
  result.tooCrowded = isTooCrowded(pairs);
  if (result.tooCrowded) return result;
  QRELIEF_TRY(pairs);
  result.pairs = pairs->size();
  result.atLeast = pairs->size() == kMaxCrossingsListed;
  if (pairs->empty()) return result;
  result.at = crossingPoint(mesh, pairs->front());
  result.left = *pairs;
  if (pairs->size() > kMaxMended) return result;

  const std::vector<Vec3f> before = mesh.positions;
  const std::vector<std::uint32_t> pieces = piecesOf(mesh);
  std::size_t work = 0;
  while (!pairs->empty()) {
    const std::vector<std::uint32_t> tangle = firstTangle(mesh, *pairs);
    const Result<bool> parted = part(mesh, pieces, tangle, work);
    if (!parted || !*parted) {
      mesh.positions = before;
      return parted ? Result<Untangling>(result) : tl::unexpected(parted.error());
    }
    pairs->erase(std::remove_if(pairs->begin(), pairs->end(),
                                [&](const TrianglePair& pair) { return usesAny(mesh.triangles[pair[0]], tangle); }),
                 pairs->end());
  }
  result.mended = true;
  result.left.clear();
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (mesh.positions[v] == before[v]) continue;
    ++result.moved;
    result.largestMoveMm = std::max(result.largestMoveMm, glm::distance(Vec3(mesh.positions[v]), Vec3(before[v])));
  }
  return result;
}

}  // namespace qrelief
