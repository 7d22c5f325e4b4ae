// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/fill_holes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "mesh/collinear.h"
#include "mesh/self_intersection.h"
#include "mesh/topology.h"

namespace qrelief {
namespace {

/// Above this number of loops the surface is in pieces rather than full of holes.
constexpr std::size_t kMaxHoles = 1000;

/// A loop of open edges, in the direction that its patch's triangles take: from corners[i] to corners[i + 1].
struct Hole {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> triangles;  ///< at each of the edges
};

struct HoleEdge {
  std::uint32_t from, to, triangle;
};

/// Returns the open edges reversed, sorted by their start.
std::vector<HoleEdge> holeEdges(const Mesh& mesh, const EdgeTable& edges) {
  std::vector<HoleEdge> result;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.at(e).size() != 1) continue;
    const std::uint32_t h = edges.at(e)[0];
    const Triangle& t = mesh.triangles[h / 3];
    result.push_back({t[(h + 1) % 3], t[h % 3], h / 3});
  }
  std::sort(result.begin(), result.end(),
            [](const HoleEdge& a, const HoleEdge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  return result;
}

/// Walks along open edges. Whenever the walk meets itself, the loop is a hole. If the walk ends otherwise, its edges
/// belong to no hole.
std::vector<Hole> findHoles(std::size_t vertexCount, const std::vector<HoleEdge>& edges) {
  constexpr std::size_t kOff = std::numeric_limits<std::size_t>::max();
  std::vector<Hole> holes;
  std::vector<std::size_t> placeOnPath(vertexCount, kOff);
  std::vector<std::size_t> nextFrom(vertexCount, kOff);  // first unused edge from each vertex
  for (std::size_t e = edges.size(); e-- > 0;) nextFrom[edges[e].from] = e;
  const auto takeFrom = [&](std::uint32_t vertex) {
    const std::size_t e = nextFrom[vertex];
    if (e != kOff) nextFrom[vertex] = e + 1 < edges.size() && edges[e + 1].from == vertex ? e + 1 : kOff;
    return e;
  };
  for (const HoleEdge& first : edges) {
    std::vector<std::uint32_t> path{first.from};
    std::vector<std::uint32_t> beside;
    placeOnPath[first.from] = 0;
    for (std::size_t e = takeFrom(path.back()); e != kOff; e = takeFrom(path.back())) {
      beside.push_back(edges[e].triangle);
      const std::size_t place = placeOnPath[edges[e].to];
      if (place == kOff) {
        placeOnPath[edges[e].to] = path.size();
        path.push_back(edges[e].to);
        continue;
      }
      const auto begin = static_cast<std::ptrdiff_t>(place);
      holes.push_back({{path.begin() + begin, path.end()}, {beside.begin() + begin, beside.end()}});
      for (std::size_t i = place + 1; i < path.size(); ++i) placeOnPath[path[i]] = kOff;
      path.resize(place + 1);
      beside.resize(place);
    }
    for (const std::uint32_t v : path) placeOnPath[v] = kOff;
  }
  return holes;
}

double diameterOf(const Mesh& mesh, const Hole& hole) {
  if (hole.corners.size() > kMaxHoleEdges) {
    Box3 box;
    for (const std::uint32_t v : hole.corners) box.add(Vec3(mesh.positions[v]));
    return box.diagonal();
  }
  double diameter = 0;
  for (const std::uint32_t u : hole.corners)
    for (const std::uint32_t v : hole.corners)
      diameter = std::max(diameter, glm::distance(Vec3(mesh.positions[u]), Vec3(mesh.positions[v])));
  return diameter;
}

/// Edges between corners of holes, sorted by their lower vertex, then by the higher one.
using NeighbourList = std::vector<std::array<std::uint32_t, 2>>;

bool canBeFilled(const Mesh& mesh, const Hole& hole, double maxDiameterMm) {
  if (hole.corners.size() == 3) return true;  // there is only one way
  return hole.corners.size() <= kMaxHoleEdges && diameterOf(mesh, hole) <= maxDiameterMm;
}

NeighbourList neighboursOnHoles(const Mesh& mesh, const EdgeTable& edges, std::span<const Hole> holes,
                                double maxDiameterMm) {
  std::vector<char> onHole(mesh.positions.size(), 0);
  for (const Hole& hole : holes)
    if (canBeFilled(mesh, hole, maxDiameterMm))
      for (const std::uint32_t v : hole.corners) onHole[v] = 1;
  NeighbourList neighbours;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::uint32_t h = edges.at(e)[0];
    const std::uint32_t a = mesh.triangles[h / 3][h % 3], b = mesh.triangles[h / 3][(h + 1) % 3];
    if (onHole[a] && onHole[b]) neighbours.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(neighbours.begin(), neighbours.end());
  return neighbours;
}

/// Search for the best triangulation of a hole: triangulates all runs of its corners, from short ones to the whole.
class PatchSearch {
 public:
  PatchSearch(const Mesh& mesh, const NeighbourList& neighbours, const Hole& hole)
      : mesh_(mesh), hole_(hole), n_(hole.corners.size()), runs_(n_ * n_), isEdge_(n_ * n_, 0) {
    std::vector<std::pair<std::uint32_t, std::size_t>> places;
    for (std::size_t i = 0; i < n_; ++i) places.emplace_back(hole.corners[i], i);
    std::sort(places.begin(), places.end());
    const auto placeOf = [&](std::uint32_t vertex) {
      const auto it = std::lower_bound(places.begin(), places.end(), std::pair(vertex, std::size_t{0}));
      return it != places.end() && it->first == vertex ? it->second : n_;
    };
    for (const auto& [vertex, i] : places)
      for (auto edge = std::lower_bound(neighbours.begin(), neighbours.end(), std::array{vertex, std::uint32_t{0}});
           edge != neighbours.end() && (*edge)[0] == vertex; ++edge) {
        const std::size_t j = placeOf((*edge)[1]);
        if (j < n_) isEdge_[std::min(i, j) * n_ + std::max(i, j)] = 1;
      }
  }

  std::optional<std::vector<Triangle>> find() {
    for (std::size_t length = 2; length < n_; ++length)
      for (std::size_t i = 0; i + length < n_; ++i) findRun(i, i + length);
    if (runs_[n_ - 1].fold == kImpossible) return std::nullopt;
    std::vector<Triangle> triangles;
    collect(0, n_ - 1, triangles);
    return triangles;
  }

 private:
  static constexpr double kImpossible = std::numeric_limits<double>::infinity();

  /// A run of corners from i to j, closed by the chord from j to i.
  struct Run {
    double fold = kImpossible;  ///< 1 - cosine of the sharpest fold
    double area = 0;
    std::size_t apex = 0;
    Vec3 normal{0};  ///< of the triangle at the chord
  };

  Vec3 at(std::size_t i) const { return Vec3(mesh_.positions[hole_.corners[i]]); }

  /// Returns the normal of the triangle beyond the edge from i to j: the surface's, or the run's.
  Vec3 normalBeyond(std::size_t i, std::size_t j) const {
    return j == i + 1 ? triangleNormal(mesh_, hole_.triangles[i]) : runs_[i * n_ + j].normal;
  }

  void findRun(std::size_t i, std::size_t j) {
    const bool whole = i == 0 && j == n_ - 1;
    if (!whole && isEdge_[i * n_ + j]) return;  // the mesh's edge has both its triangles
    Run& best = runs_[i * n_ + j];
    for (std::size_t m = i + 1; m < j; ++m) {
      const Run& left = runs_[i * n_ + m];
      const Run& right = runs_[m * n_ + j];
      if ((m > i + 1 && left.fold == kImpossible) || (j > m + 1 && right.fold == kImpossible)) continue;
      const Vec3 cross = glm::cross(at(m) - at(i), at(j) - at(i));
      const double twice = glm::length(cross);
      if (twice == 0 || collinear(mesh_.positions[hole_.corners[i]], mesh_.positions[hole_.corners[m]],
                                  mesh_.positions[hole_.corners[j]]))
        continue;
      Run run{0, twice / 2, m, cross / twice};
      if (m > i + 1) run.fold = left.fold, run.area += left.area;
      if (j > m + 1) run.fold = std::max(run.fold, right.fold), run.area += right.area;
      run.fold = std::max(run.fold, 1 - glm::dot(run.normal, normalBeyond(i, m)));
      run.fold = std::max(run.fold, 1 - glm::dot(run.normal, normalBeyond(m, j)));
      if (whole) run.fold = std::max(run.fold, 1 - glm::dot(run.normal, triangleNormal(mesh_, hole_.triangles[j])));
      if (std::tie(run.fold, run.area) < std::tie(best.fold, best.area) || best.fold == kImpossible) best = run;
    }
  }

  void collect(std::size_t i, std::size_t j, std::vector<Triangle>& triangles) const {
    if (j < i + 2) return;
    const std::size_t m = runs_[i * n_ + j].apex;
    triangles.push_back({hole_.corners[i], hole_.corners[m], hole_.corners[j]});
    collect(i, m, triangles);
    collect(m, j, triangles);
  }

  const Mesh& mesh_;
  const Hole& hole_;
  std::size_t n_;
  std::vector<Run> runs_;     // at i·n + j
  std::vector<char> isEdge_;  // at i·n + j, i < j: the mesh has an edge between the two corners
};

struct Patch {
  std::vector<Triangle> triangles;
  std::uint32_t beside;
  double diameter;
};

/// Returns, for each patch, true if its triangles meet others elsewhere than at common edges and corners.
Result<std::vector<char>> findBadPatches(const Mesh& mesh, const std::vector<Patch>& patches) {
  Mesh filled = mesh;
  std::vector<std::size_t> patchOf;  // of the added triangles
  std::vector<std::uint32_t> added;
  for (std::size_t i = 0; i < patches.size(); ++i)
    for (const Triangle& t : patches[i].triangles) {
      added.push_back(static_cast<std::uint32_t>(filled.triangles.size()));
      filled.triangles.push_back(t);
      patchOf.push_back(i);
    }
  std::vector<char> bad(patches.size(), 0);
  const auto blame = [&](std::size_t triangle) {
    if (triangle >= mesh.triangles.size()) bad[patchOf[triangle - mesh.triangles.size()]] = 1;
  };
  constexpr std::size_t kMaxCrossings = 100'000;
  const auto crossings = findCrossings(filled, added, kMaxCrossings);
  if (!crossings && crossings.error().kind == ErrorKind::NoSolution) return std::vector<char>(patches.size(), 1);
  QRELIEF_TRY(crossings);
  if (crossings->size() == kMaxCrossings) return std::vector<char>(patches.size(), 1);
  for (const TrianglePair& pair : *crossings)
    for (const std::uint32_t t : pair) blame(t);
  const EdgeTable edges = buildEdgeTable(filled.triangles);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.at(e).size() > 2)
      for (const std::uint32_t h : edges.at(e)) blame(h / 3);
  return bad;
}

}  // namespace

Result<HoleFilling> fillHoles(Mesh& mesh, double maxDiameterMm) {
  HoleFilling result;
  const EdgeTable edges = buildEdgeTable(mesh.triangles);
  const std::vector<Hole> holes = findHoles(mesh.positions.size(), holeEdges(mesh, edges));
  if (holes.size() > kMaxHoles) return result;
  const NeighbourList neighbours = neighboursOnHoles(mesh, edges, holes, maxDiameterMm);
  std::vector<Patch> patches;
  const auto block = [&](std::uint32_t vertex) {
    if (result.blocked++ == 0) result.blockedAt = Vec3(mesh.positions[vertex]);
  };
  for (const Hole& hole : holes) {
    const double diameter = diameterOf(mesh, hole);
    if (!canBeFilled(mesh, hole, maxDiameterMm)) {
      ++result.tooLarge;
      if (diameter > result.largestLeftMm) {
        result.largestLeftMm = diameter;
        result.largestLeftEdges = hole.corners.size();
        result.leftAt = Vec3(mesh.positions[hole.corners[0]]);
      }
      continue;
    }
    auto triangles = hole.corners.size() < 3 ? std::nullopt : PatchSearch(mesh, neighbours, hole).find();
    if (triangles)
      patches.push_back({std::move(*triangles), hole.triangles[0], diameter});
    else
      block(hole.corners[0]);
  }
  if (patches.empty()) return result;
  const auto bad = findBadPatches(mesh, patches);
  QRELIEF_TRY(bad);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const std::uint32_t corner = patches[i].triangles[0][0];
    if ((*bad)[i]) {
      block(corner);
      continue;
    }
    ++result.filled;
    if (patches[i].diameter > result.largestFilledMm) {
      result.largestFilledMm = patches[i].diameter;
      result.filledAt = Vec3(mesh.positions[corner]);
    }
    mesh.triangles.insert(mesh.triangles.end(), patches[i].triangles.begin(), patches[i].triangles.end());
    result.beside.insert(result.beside.end(), patches[i].triangles.size(), patches[i].beside);
  }
  return result;
}

}  // namespace qrelief
