// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/touching_shells.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "math/orientation.h"
#include "mesh/topology.h"

namespace qrelief {
namespace {

using HalfEdges = std::vector<std::uint32_t>;

/// Triangles at one edge, seen along it from its smaller vertex to its larger one.
class Turn {
 public:
  Turn(const Mesh& mesh, std::span<const std::uint32_t> halfEdges) : mesh_(mesh) {
    const Triangle& t = mesh.triangles[halfEdges[0] / 3];
    const std::uint32_t from = t[halfEdges[0] % 3], to = t[(halfEdges[0] + 1) % 3];
    low_ = std::min(from, to);
    a_ = Vec3(mesh.positions[low_]);
    b_ = Vec3(mesh.positions[std::max(from, to)]);
    first_ = apexOf(halfEdges[0]);
  }

  /// Returns true if the solid begins behind the triangle, counter-clockwise; false if it ends there.
  bool begins(std::uint32_t halfEdge) const { return mesh_.triangles[halfEdge / 3][halfEdge % 3] != low_; }

  /// Returns true if the triangle of `h` comes before that of `g`, counter-clockwise from the first.
  bool isBefore(std::uint32_t h, std::uint32_t g) const {
    const int quarterOfH = quarterOf(h), quarterOfG = quarterOf(g);
    if (quarterOfH != quarterOfG) return quarterOfH < quarterOfG;
    return quarterOfH % 2 == 1 && sideOfPlane(a_, b_, apexOf(h), apexOf(g)) > 0;
  }

  bool sameAngle(std::uint32_t h, std::uint32_t g) const { return !isBefore(h, g) && !isBefore(g, h); }

 private:
  Vec3 apexOf(std::uint32_t halfEdge) const { return mesh_.corner(halfEdge / 3, static_cast<int>((halfEdge + 2) % 3)); }

  /// Returns 0 in the first triangle's half-plane, 1 less than half a turn behind it, 2 opposite, 3 beyond.
  int quarterOf(std::uint32_t halfEdge) const {
    const Vec3 apex = apexOf(halfEdge);
    if (const int side = sideOfPlane(a_, b_, first_, apex); side != 0) return side > 0 ? 1 : 3;
    // In one plane with the edge: the projections across the edge point the same way or opposite ways.
    const Vec3 along = b_ - a_;
    return glm::dot(glm::cross(along, first_ - a_), glm::cross(along, apex - a_)) > 0 ? 0 : 2;
  }

  const Mesh& mesh_;
  std::uint32_t low_ = 0;
  Vec3 a_{0}, b_{0}, first_{0};
};

/// Returns the half-edges of a crowded edge in pairs that enclose solid; none if they do not take turns.
std::optional<HalfEdges> pairsAround(const Mesh& mesh, std::span<const std::uint32_t> halfEdges) {
  const Turn turn(mesh, halfEdges);
  HalfEdges order(halfEdges.begin(), halfEdges.end());
  std::sort(order.begin(), order.end(), [&](std::uint32_t h, std::uint32_t g) {
    if (turn.isBefore(h, g)) return true;
    if (turn.isBefore(g, h)) return false;
    return std::pair(turn.begins(h), h) <
           std::pair(turn.begins(g), g);  // face to face: one solid ends, then one begins
  });
  const auto firstBegin = std::find_if(order.begin(), order.end(), [&](std::uint32_t h) { return turn.begins(h); });
  std::rotate(order.begin(), firstBegin, order.end());
  for (std::size_t i = 0; i < order.size(); ++i)
    if (turn.begins(order[i]) != (i % 2 == 0)) return std::nullopt;
  for (std::size_t i = 0; i < order.size(); i += 2)
    if (turn.sameAngle(order[i], order[i + 1])) return std::nullopt;  // a solid without thickness
  return order;
}

/// Disjoint sets of triangles.
class Pieces {
 public:
  explicit Pieces(std::size_t triangles) : parent_(triangles) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t t) {
    while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
    return t;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Gives the corners at each vertex one vertex for each of their groups; the first group keeps the old one.
/// @param groupOf  corner → group
template <class GroupOf>
void splitVertices(Mesh& mesh, const GroupOf& groupOf) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> firstGroup(mesh.positions.size(), kNone);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> split;  // vertex and group → new vertex
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
    const std::uint32_t group = groupOf(corner, vertex);
    if (firstGroup[vertex] == kNone) firstGroup[vertex] = group;
    if (firstGroup[vertex] == group) continue;
    const auto [known, isNew] = split.try_emplace({vertex, group}, static_cast<std::uint32_t>(mesh.positions.size()));
    if (isNew) mesh.positions.push_back(Vec3f(mesh.positions[vertex]));
    vertex = known->second;
  }
}

}  // namespace

std::size_t separateTouchingShells(Mesh& mesh, const EdgeTable& edges) {
  const std::size_t before = mesh.positions.size();
  std::vector<std::pair<std::size_t, HalfEdges>> separated;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.at(e).size() > 3)
      if (auto pairs = pairsAround(mesh, edges.at(e))) separated.emplace_back(e, std::move(*pairs));
  CornerFans fans(mesh);
  Pieces pieces(mesh.triangles.size());
  const auto join = [&](std::uint32_t h, std::uint32_t g) {
    fans.joinAlong(h, g);
    pieces.join(h / 3, g / 3);
  };
  std::vector<char> isAtSeparated(mesh.positions.size(), 0);
  auto next = separated.begin();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (next == separated.end() || next->first != e) {
      for (const std::uint32_t h : edges.at(e).subspan(1)) join(edges.at(e)[0], h);
      continue;
    }
    const HalfEdges& pairs = next->second;
    for (std::size_t i = 0; i < pairs.size(); i += 2) join(pairs[i], pairs[i + 1]);
    const Triangle& t = mesh.triangles[pairs[0] / 3];
    isAtSeparated[t[pairs[0] % 3]] = isAtSeparated[t[(pairs[0] + 1) % 3]] = 1;
    ++next;
  }
  splitVertices(mesh, [&](std::uint32_t corner, std::uint32_t vertex) {
    return isAtSeparated[vertex] ? fans.find(corner) : pieces.find(corner / 3) * 3;
  });
  return mesh.positions.size() - before;
}

}  // namespace qrelief
