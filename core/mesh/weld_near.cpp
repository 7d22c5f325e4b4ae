// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/weld_near.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "mesh/open_border.h"

namespace qrelief {
namespace {

/// Limit of pairs examined: a vertex in a heap of thousands of loose points has as many partners.
constexpr std::size_t kMaxPairs = 20'000'000;

/// Limit of vertices and triangles examined while clusters are joined: about a second.
constexpr std::size_t kMaxJoinWork = 200'000'000;

struct Pair {
  double distance;
  std::uint32_t u, v;  // u < v
};

/// Finds pairs of open vertices of one body within the tolerance of each other; the nearest first, ties by index.
/// @param cutShort  set to true if there are too many to find all
std::vector<Pair> nearPairs(const Mesh& mesh, const OpenBorder& border, double tolerance,
                            const std::vector<std::uint32_t>& bodyOfVertex, bool& cutShort) {
  std::vector<Pair> pairs;
  std::size_t looks = 0;
  std::vector<std::uint32_t> nearby, partners;
  for (const std::uint32_t u : border.vertices()) {
    const Vec3 p(mesh.positions[u]);
    looks += border.findNear(p, tolerance, nearby);
    partners.clear();
    for (const std::uint32_t h : nearby)
      for (const std::uint32_t v : {mesh.triangles[h / 3][h % 3], mesh.triangles[h / 3][(h + 1) % 3]})
        if (v > u && bodyOfVertex[v] == bodyOfVertex[u] && glm::distance(Vec3(mesh.positions[v]), p) <= tolerance)
          partners.push_back(v);
    std::sort(partners.begin(), partners.end());
    partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
    for (const std::uint32_t v : partners) pairs.push_back({glm::distance(Vec3(mesh.positions[v]), p), u, v});
    cutShort = pairs.size() > kMaxPairs || looks > border.maxLooks();
    if (cutShort) break;
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.distance, a.u, a.v) < std::tie(b.distance, b.u, b.v);
  });
  return pairs;
}

/// Clusters of merged vertices, and the triangles of the open vertices.
class Clusters {
 public:
  Clusters(const Mesh& mesh, const OpenBorder& border) : mesh_(mesh), lead_(mesh.positions.size()) {
    std::iota(lead_.begin(), lead_.end(), 0u);
    members_.resize(lead_.size());
    trianglesAt_.resize(lead_.size());
    for (const std::uint32_t v : border.vertices()) members_[v] = {v};
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (const std::uint32_t v : mesh.triangles[t])
        if (border.isOpen(v)) trianglesAt_[v].push_back(t);
  }

  std::uint32_t leadOf(std::uint32_t v) const { return lead_[v]; }
  std::size_t work() const { return work_; }  ///< vertices and triangles examined so far

  /// Joins the two vertices' clusters unless a vertex would move too far or a triangle collapse.
  void join(std::uint32_t u, std::uint32_t v, double tolerance) {
    const std::uint32_t low = std::min(lead_[u], lead_[v]);
    const std::uint32_t high = std::max(lead_[u], lead_[v]);
    if (low == high) return;
    const Vec3 target(mesh_.positions[low]);
    for (const std::uint32_t member : members_[high]) {
      work_ += 1 + trianglesAt_[member].size();
      if (glm::distance(Vec3(mesh_.positions[member]), target) > tolerance) return;
      for (const std::uint32_t t : trianglesAt_[member])
        for (const std::uint32_t corner : mesh_.triangles[t])
          if (lead_[corner] == low) return;
    }
    for (const std::uint32_t member : members_[high]) lead_[member] = low;
    members_[low].insert(members_[low].end(), members_[high].begin(), members_[high].end());
    members_[high].clear();
  }

 private:
  const Mesh& mesh_;
  std::vector<std::uint32_t> lead_;
  std::vector<std::vector<std::uint32_t>> members_, trianglesAt_;
  std::size_t work_ = 0;
};

std::vector<std::uint32_t> bodiesOfVertices(const Mesh& mesh, std::span<const std::uint32_t> bodyOfTriangle) {
  std::vector<std::uint32_t> bodies(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < bodyOfTriangle.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) bodies[v] = bodyOfTriangle[t];
  return bodies;
}

}  // namespace

NearWelding weldNear(Mesh& mesh, double toleranceMm, std::span<const std::uint32_t> bodyOfTriangle) {
  NearWelding result;
  const OpenBorder border(mesh);
  if (border.vertices().empty() || !(toleranceMm > 0)) return result;
  Clusters clusters(mesh, border);
  for (const Pair& pair :
       nearPairs(mesh, border, toleranceMm, bodiesOfVertices(mesh, bodyOfTriangle), result.cutShort)) {
    clusters.join(pair.u, pair.v, toleranceMm);
    if (clusters.work() <= kMaxJoinWork) continue;
    result.cutShort = true;
    break;
  }
  for (const std::uint32_t v : border.vertices()) {
    const std::uint32_t lead = clusters.leadOf(v);
    if (lead == v) continue;
    const Vec3 from(mesh.positions[v]);
    if (result.moved++ == 0) result.at = from;
    result.largestMoveMm = std::max(result.largestMoveMm, glm::distance(from, Vec3(mesh.positions[lead])));
  }
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = clusters.leadOf(v);
  return result;
}

}  // namespace qrelief
