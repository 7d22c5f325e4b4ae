// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/clearance.h"

#include <algorithm>
#include <cmath>

namespace qrelief {
namespace {

constexpr std::uint32_t kDartsPerTurn = 32;

/// Returns a uniform number in [0, 1), the same on every machine: SplitMix64's finaliser [Steele, Lea, Flood 2014].
double hashToUnit(std::uint64_t key) {
  key += 0x9e3779b97f4a7c15u;
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9u;
  key = (key ^ (key >> 27)) * 0x94d049bb133111ebu;
  key ^= key >> 31;
  return static_cast<double>(key >> 11) * 0x1p-53;
}

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
  return glm::length(p - a - ab * t);
}

}  // namespace

Clearance::Clearance(OutlineGraph& graph, EdgeGrid& edges, double snapMm)
    : graph_(graph),
      edges_(edges),
      snapMm_(snapMm),
      plentyMm_(snapMm / 4),
      ideal_(graph.nodes),
      firstIncident_(graph.nodes.size() + 1, 0),
      incident_(2 * graph.outlines.size()),
      placed_(graph.nodes.size(), 0),
      throws_(graph.nodes.size(), 0) {
  for (const Outline& o : graph.outlines)
    if (o.meetsModel()) ++firstIncident_[o.from + 1], ++firstIncident_[o.to + 1];
  for (std::size_t n = 1; n < firstIncident_.size(); ++n) firstIncident_[n] += firstIncident_[n - 1];
  std::vector<std::uint32_t> next(firstIncident_.begin(), firstIncident_.end() - 1);
  for (std::uint32_t k = 0; k < graph.outlines.size(); ++k) {
    if (!graph.outlines[k].meetsModel()) continue;
    incident_[next[graph.outlines[k].from]++] = k;
    incident_[next[graph.outlines[k].to]++] = k;
  }
}

/// @param enough  stops early once the clearance is known to be below this
double Clearance::outlineClearance(Vec2 p, Vec2 q, double enough) const {
  double clear = plentyMm_;
  crossings_.clear();
  for (const std::uint32_t e : edges_.near(glm::min(p, q) - plentyMm_, glm::max(p, q) + plentyMm_)) {
    const auto& [a, b] = edges_.edge(e);
    clear = std::min({clear, distanceToSegment(p, a, b), distanceToSegment(q, a, b), distanceToSegment(a, p, q),
                      distanceToSegment(b, p, q)});
    if (clear < enough) return clear;
    const double sideA = cross2(q - p, a - p), sideB = cross2(q - p, b - p);
    const double sideP = cross2(b - a, p - a), sideQ = cross2(b - a, q - a);
    if ((sideA > 0) != (sideB > 0) && (sideP > 0) != (sideQ > 0)) crossings_.push_back({sideP / (sideP - sideQ), e});
  }
  std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& x, const Crossing& y) {
    return x.along != y.along ? x.along < y.along : x.edge < y.edge;
  });
  for (std::size_t k = 1; k < crossings_.size(); ++k) {
    const Crossing &first = crossings_[k - 1], &second = crossings_[k];
    const EdgeGrid::Edge &e = edges_.edge(first.edge), &f = edges_.edge(second.edge);
    clear = std::min({clear, distanceToSegment(p + (q - p) * first.along, f[0], f[1]),
                      distanceToSegment(p + (q - p) * second.along, e[0], e[1])});
    if (clear < enough) return clear;
  }
  return clear;
}

/// Returns the clearance of a node and of its outlines to nodes already placed.
double Clearance::nodeClearance(std::uint32_t node, Vec2 position, double enough) const {
  double clear = plentyMm_;
  bool alone = true;
  for (std::uint32_t k = firstIncident_[node]; k < firstIncident_[node + 1]; ++k) {
    const Outline& o = graph_.outlines[incident_[k]];
    const std::uint32_t other = o.from == node ? o.to : o.from;
    if (!placed_[other]) continue;
    alone = false;
    clear = std::min(clear, outlineClearance(position, graph_.nodes[other], enough));
    if (clear < enough) return clear;
  }
  if (!alone) return clear;
  for (const std::uint32_t e : edges_.near(position - plentyMm_, position + plentyMm_))
    clear = std::min(clear, distanceToSegment(position, edges_.edge(e)[0], edges_.edge(e)[1]));
  return clear;
}

/// Returns another place for a node, uniform in a square around its ideal place. Uses exact arithmetic only, so that
/// every maths library gives the same place.
Vec2 Clearance::dart(std::uint32_t node) {
  const std::uint32_t number = throws_[node]++;
  const int doublings = std::clamp(static_cast<int>(number / kDartsPerTurn) - 2, 0, 30);
  const double farthest = std::min(graph_.leewayMm[node], std::ldexp(snapMm_, doublings));
  const double half = farthest * 0.7;  // the square's half diagonal is shorter than `farthest`
  const std::uint64_t key = (static_cast<std::uint64_t>(node) << 32 | number) * 2;
  return ideal_[node] + (Vec2(hashToUnit(key), hashToUnit(key + 1)) * 2.0 - 1.0) * half;
}

void Clearance::place(std::uint32_t node) {
  placed_[node] = 1;
  if (graph_.leewayMm[node] == 0) return;
  Vec2 best = graph_.nodes[node];
  double bestClear = nodeClearance(node, best, 0);
  for (std::uint32_t k = 0; k < kDartsPerTurn && bestClear < plentyMm_; ++k) {
    const Vec2 candidate = dart(node);
    const double clear = nodeClearance(node, candidate, bestClear);
    if (clear <= bestClear) continue;
    best = candidate;
    bestClear = clear;
  }
  graph_.nodes[node] = best;
}

void Clearance::placeAll() {
  const auto count = static_cast<std::uint32_t>(graph_.nodes.size());
  for (std::uint32_t node = 0; node < count; ++node) place(node);
  for (std::uint32_t node = 0; node < count; ++node)
    if (throws_[node] > 0) place(node);
}

void Clearance::placeAgain(std::span<const std::uint32_t> nodes) {
  for (const std::uint32_t node : nodes) {
    // Move it even if it already has the best place by this measure.
    graph_.nodes[node] = dart(node);
    place(node);
  }
}

double Clearance::smallest() const {
  double clear = plentyMm_;
  for (const Outline& o : graph_.outlines) {
    if (!o.meetsModel()) continue;
    clear = std::min(clear, outlineClearance(graph_.nodes[o.from], graph_.nodes[o.to], 0));
  }
  return clear;
}

}  // namespace qrelief
