// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "carving/constrained_delaunay.h"
#include "message_codes/place.h"

namespace qrelief {
namespace {

constexpr int kUnknown = -1;

/// A constraint of the triangulation, with the facets and levels on its two sides.
struct Constraint {
  std::uint32_t from, to;
  std::uint32_t leftFacet = kNoFacet, rightFacet = kNoFacet;
  int leftLevel = kUnknown, rightLevel = kUnknown;
  bool onEdge = false;    ///< lies on a model edge
  bool onBorder = false;  ///< lies on the resampled square's border
  bool endsFacet() const { return onEdge || onBorder; }
};

Error leavesSurface(Vec2 where) {
  return {ErrorKind::NoSolution,
          message<"carving-leaves-surface">(with::lengthMm<"right">(where.x), with::lengthMm<"up">(where.y))};
}

std::vector<Arrangement::Crossing> findCrossings(const Footprint& footprint, EdgeGrid& edges,
                                                 const OutlineGraph& graph) {
  std::vector<Arrangement::Crossing> crossings;
  for (std::uint32_t k = 0; k < graph.outlines.size(); ++k) {
    if (!graph.outlines[k].meetsModel()) continue;
    const Vec2 p = graph.nodes[graph.outlines[k].from], q = graph.nodes[graph.outlines[k].to];
    const std::size_t first = crossings.size();
    for (const std::uint32_t e : edges.near(glm::min(p, q), glm::max(p, q))) {
      const Vec2 a = footprint.points[footprint.edges[e].a], b = footprint.points[footprint.edges[e].b];
      const double sideA = cross2(q - p, a - p), sideB = cross2(q - p, b - p);
      const double sideP = cross2(b - a, p - a), sideQ = cross2(b - a, q - a);
      if ((sideA > 0) == (sideB > 0) || (sideP > 0) == (sideQ > 0)) continue;
      crossings.push_back({e, k, sideA / (sideA - sideB), sideP / (sideP - sideQ)});
    }
    std::sort(crossings.begin() + static_cast<std::ptrdiff_t>(first), crossings.end(),
              [](const auto& x, const auto& y) {
                return x.alongOutline != y.alongOutline ? x.alongOutline < y.alongOutline : x.edge < y.edge;
              });
  }
  return crossings;
}

void addPoints(Arrangement& result, const Footprint& footprint, const OutlineGraph& graph) {
  result.points = footprint.points;
  result.firstNode = static_cast<std::uint32_t>(result.points.size());
  result.points.insert(result.points.end(), graph.nodes.begin(), graph.nodes.end());
  result.firstCrossing = static_cast<std::uint32_t>(result.points.size());
  for (const Arrangement::Crossing& c : result.crossings) {
    const Footprint::Edge& e = footprint.edges[c.edge];
    result.points.push_back(footprint.points[e.a] + (footprint.points[e.b] - footprint.points[e.a]) * c.alongEdge);
  }
}

/// Adds the outlines, cut at their crossings; the crossings are stored in the same order.
void addPieces(std::vector<Constraint>& constraints, Arrangement& result, const OutlineGraph& graph) {
  std::size_t next = 0;
  for (std::uint32_t k = 0; k < graph.outlines.size(); ++k) {
    const Outline& o = graph.outlines[k];
    std::uint32_t from = result.firstNode + o.from;
    const auto cutAt = [&](std::uint32_t to) {
      result.pieces.push_back({from, to, o.left, o.right});
      constraints.push_back({from, to, o.leftResampled ? Arrangement::kGridFacet : kNoFacet,
                             o.rightResampled ? Arrangement::kGridFacet : kNoFacet, o.left, o.right, false,
                             o.boundsGrid()});
      from = to;
    };
    for (; next < result.crossings.size() && result.crossings[next].outline == k; ++next)
      cutAt(result.firstCrossing + static_cast<std::uint32_t>(next));
    cutAt(result.firstNode + o.to);
  }
}

/// Finds the footprint vertices within the resampled square, by the parity of its borders to their right.
std::vector<char> findReplaced(const Footprint& footprint, const OutlineGraph& graph) {
  std::vector<char> replaced(footprint.points.size(), 0);
  std::vector<EdgeGrid::Edge> border;
  double inner = std::numeric_limits<double>::infinity(), outer = 0;  // of the border from the centre, maximum norm
  for (const Outline& o : graph.outlines) {
    if (!o.boundsGrid()) continue;
    border.push_back({graph.nodes[o.from], graph.nodes[o.to]});
    const double far = std::max(std::abs(border.back()[0].x), std::abs(border.back()[0].y));
    inner = std::min(inner, far);
    outer = std::max(outer, far);
  }
  if (border.empty()) return replaced;
  for (std::size_t v = 0; v < replaced.size(); ++v) {
    const Vec2 p = footprint.points[v];
    const double far = std::max(std::abs(p.x), std::abs(p.y));
    if (far < inner || far > outer) {
      replaced[v] = far < inner;
      continue;
    }
    for (const auto& [a, b] : border)
      if ((a.y > p.y) != (b.y > p.y) && a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) > p.x)
        replaced[v] = !replaced[v];
  }
  return replaced;
}

/// Adds the model edges, cut at their crossings, without the parts inside the resampled square.
/// @returns an error if the footprint's rim enters the square, or if crossings and sides contradict each other
std::optional<Error> addEdgeConstraints(std::vector<Constraint>& constraints, const Arrangement& arrangement,
                                        const Footprint& footprint, const OutlineGraph& graph,
                                        std::span<const char> replaced) {
  std::vector<std::uint32_t> order(arrangement.crossings.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto& crossings = arrangement.crossings;
  std::sort(order.begin(), order.end(), [&](std::uint32_t x, std::uint32_t y) {
    if (crossings[x].edge != crossings[y].edge) return crossings[x].edge < crossings[y].edge;
    return crossings[x].alongEdge != crossings[y].alongEdge ? crossings[x].alongEdge < crossings[y].alongEdge : x < y;
  });
  std::size_t next = 0;
  for (std::uint32_t e = 0; e < footprint.edges.size(); ++e) {
    const Footprint::Edge& edge = footprint.edges[e];
    Constraint piece{edge.a, edge.b, edge.left, edge.right, kUnknown, kUnknown, true, false};
    bool within = replaced[edge.a];
    const auto cutAt = [&](std::uint32_t to) {
      piece.to = to;
      if (!within) constraints.push_back(piece);
      piece.from = to;
    };
    for (; next < order.size() && crossings[order[next]].edge == e; ++next) {
      cutAt(arrangement.firstCrossing + order[next]);
      if (graph.outlines[crossings[order[next]].outline].boundsGrid()) within = !within;
      if (within && edge.right == kNoFacet) return leavesSurface(arrangement.points[piece.from]);
    }
    cutAt(edge.b);
    if (within && edge.right == kNoFacet) return leavesSurface(arrangement.points[edge.b]);
    if (within != static_cast<bool>(replaced[edge.b]))
      return Error{ErrorKind::Internal, message<"edge-on-wrong-side">()};
  }
  return std::nullopt;
}

/// Finds constraints by their end points.
class ConstraintIndex {
 public:
  ConstraintIndex(std::span<const Constraint> constraints, std::size_t points) : first_(points + 1, 0) {
    for (const Constraint& c : constraints) ++first_[std::min(c.from, c.to) + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    entries_.resize(constraints.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t k = 0; k < constraints.size(); ++k)
      entries_[next[std::min(constraints[k].from, constraints[k].to)]++] = {
          std::max(constraints[k].from, constraints[k].to), k};
  }

  /// Returns the index of the constraint between two points, or kNoFacet.
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t low = std::min(a, b), high = std::max(a, b);
    for (std::uint32_t k = first_[low]; k < first_[low + 1]; ++k)
      if (entries_[k].other == high) return entries_[k].constraint;
    return kNoFacet;
  }

 private:
  struct Entry {
    std::uint32_t other, constraint;
  };
  std::vector<std::uint32_t> first_;
  std::vector<Entry> entries_;
};

/// Facet and level of every triangle, spread from the constraints across all other edges.
struct Labels {
  std::vector<std::uint32_t> facets;
  std::vector<int> levels;
  std::vector<std::array<std::uint32_t, 3>> constraints;  ///< constraints at each triangle's edges
  bool consistent = true;
};

void seedLabels(Labels& labels, const PlaneTriangulation& cdt, std::span<const Constraint> constraints,
                const ConstraintIndex& index) {
  const auto assign = [&](auto& label, auto value, auto unknown) {
    if (value == unknown) return;
    if (label != unknown && label != value) labels.consistent = false;
    label = value;
  };
  for (std::size_t t = 0; t < cdt.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = cdt.triangles[t][k], b = cdt.triangles[t][(k + 1) % 3];
      const std::uint32_t constraint = index.find(a, b);
      labels.constraints[t][k] = constraint;
      if (constraint == kNoFacet) continue;
      const Constraint& c = constraints[constraint];
      assign(labels.facets[t], c.from == a ? c.leftFacet : c.rightFacet, kNoFacet);
      assign(labels.levels[t], c.from == a ? c.leftLevel : c.rightLevel, kUnknown);
    }
}

/// Spreads labels from triangle to triangle across edges that `passes` allows; records conflicts of labels.
template <class Label, class Passes>
void spread(std::vector<Label>& labels, Label unknown, const PlaneTriangulation& cdt, const Passes& passes,
            bool& consistent) {
  std::vector<std::uint32_t> front;
  for (std::uint32_t t = 0; t < labels.size(); ++t)
    if (labels[t] != unknown) front.push_back(t);
  while (!front.empty()) {
    const std::uint32_t t = front.back();
    front.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = cdt.neighbours[t][k];
      if (other == kNoNeighbour || !passes(t, k)) continue;
      if (labels[other] == unknown) {
        labels[other] = labels[t];
        front.push_back(other);
      } else if (labels[other] != labels[t]) {
        consistent = false;
      }
    }
  }
}

Labels labelTriangles(const PlaneTriangulation& cdt, std::span<const Constraint> constraints, std::size_t points) {
  const std::size_t count = cdt.triangles.size();
  Labels labels;
  labels.facets.assign(count, kNoFacet);
  labels.levels.assign(count, kUnknown);
  labels.constraints.resize(count);
  seedLabels(labels, cdt, constraints, ConstraintIndex(constraints, points));
  const auto constraintAt = [&](std::uint32_t t, std::size_t k) { return labels.constraints[t][k]; };
  spread(
      labels.facets, kNoFacet, cdt,
      [&](std::uint32_t t, std::size_t k) {
        return constraintAt(t, k) == kNoFacet || !constraints[constraintAt(t, k)].endsFacet();
      },
      labels.consistent);
  spread(
      labels.levels, kUnknown, cdt,
      [&](std::uint32_t t, std::size_t k) {
        return constraintAt(t, k) == kNoFacet || constraints[constraintAt(t, k)].onEdge;
      },
      labels.consistent);
  for (int& level : labels.levels)
    if (level == kUnknown) level = 0;  // no outline nearby: not carved
  return labels;
}

/// Returns an error if a carved area reaches the footprint's rim or an outline lies outside.
std::optional<Error> findLeak(const PlaneTriangulation& cdt, const Labels& labels,
                              std::span<const Constraint> constraints, std::span<const Vec2> points) {
  for (std::uint32_t t = 0; t < cdt.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t constraint = labels.constraints[t][k];
      if (constraint == kNoFacet) continue;
      const std::uint32_t other = cdt.neighbours[t][k];
      const bool outside = labels.facets[t] == kNoFacet;
      const bool rim = outside || other == kNoNeighbour || labels.facets[other] == kNoFacet;
      if (!rim || (constraints[constraint].onEdge && (outside || labels.levels[t] == 0))) continue;
      return leavesSurface((points[constraints[constraint].from] + points[constraints[constraint].to]) * 0.5);
    }
  return std::nullopt;
}

/// Triangulates the remaining points; the result uses the indices of all points.
Result<PlaneTriangulation> triangulate(const Arrangement& arrangement, std::span<const Constraint> constraints,
                                       std::span<const char> replaced) {
  std::vector<std::uint32_t> left, place(arrangement.points.size(), 0);
  std::vector<Vec2> points;
  for (std::uint32_t p = 0; p < place.size(); ++p) {
    if (p < replaced.size() && replaced[p]) continue;
    place[p] = static_cast<std::uint32_t>(left.size());
    left.push_back(p);
    points.push_back(arrangement.points[p]);
  }
  std::vector<std::array<std::uint32_t, 2>> pairs;
  pairs.reserve(constraints.size());
  for (const Constraint& c : constraints) pairs.push_back({place[c.from], place[c.to]});
  auto cdt = triangulateConstrained(points, pairs);
  if (!cdt) return cdt;
  for (Triangle& t : cdt->triangles)
    for (std::uint32_t& p : t) p = left[p];
  return cdt;
}

}  // namespace

Result<Arrangement> arrange(const Footprint& footprint, EdgeGrid& edges, const OutlineGraph& graph) {
  Arrangement result;
  result.crossings = findCrossings(footprint, edges, graph);
  addPoints(result, footprint, graph);
  const std::vector<char> replaced = findReplaced(footprint, graph);
  std::vector<Constraint> constraints;
  if (auto error = addEdgeConstraints(constraints, result, footprint, graph, replaced))
    return tl::unexpected(std::move(*error));
  addPieces(constraints, result, graph);

  const auto cdt = triangulate(result, constraints, replaced);
  QRELIEF_TRY(cdt);
  const Labels labels = labelTriangles(*cdt, constraints, result.points.size());
  if (auto leak = findLeak(*cdt, labels, constraints, result.points)) return tl::unexpected(std::move(*leak));
  if (!labels.consistent) return fail(ErrorKind::Internal, message<"arrangement-contradicts-itself">());
  for (std::size_t t = 0; t < cdt->triangles.size(); ++t) {
    if (labels.facets[t] == kNoFacet) continue;
    result.triangles.push_back(cdt->triangles[t]);
    result.facets.push_back(labels.facets[t]);
    result.levels.push_back(labels.levels[t]);
  }
  return result;
}

}  // namespace qrelief
