// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_stars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "mesh/triangle_separation.h"

namespace qrelief {
namespace {

constexpr std::size_t kMostTriangles = 32;
constexpr std::size_t kVerticesAPiece = 1 << 13;  // of parallel work: about a millisecond

/// The corners of each vertex: 3 · triangle + k.
struct CornerList {
  std::vector<std::uint32_t> begin;  ///< per vertex, into `corners`; one more at the end
  std::vector<std::uint32_t> corners;

  /// @param isAsked  per vertex
  CornerList(const Mesh& mesh, const std::vector<std::uint8_t>& isAsked) : begin(mesh.positions.size() + 1, 0) {
    for (const Triangle& t : mesh.triangles)
      for (const std::uint32_t v : t) begin[v + 1] += isAsked[v];
    for (std::size_t v = 0; v + 1 < begin.size(); ++v) begin[v + 1] += begin[v];
    corners.resize(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (const std::uint32_t v = mesh.triangles[t][k]; isAsked[v]) corners[next[v]++] = 3 * t + k;
  }

  std::span<const std::uint32_t> of(std::size_t vertex) const {
    return std::span(corners).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

/// A triangle at a vertex: its other corners, anticlockwise, from the vertex.
struct Wedge {
  std::uint32_t from = 0, to = 0;
  Vec3 u{0}, v{0};
};

/// Returns true if every neighbour of the vertex begins one wedge and ends one.
bool formCycles(std::span<const Wedge> wedges) {
  return std::all_of(wedges.begin(), wedges.end(), [&](const Wedge& wedge) {
    const auto same = [&](std::uint32_t Wedge::*end) {
      return std::count_if(wedges.begin(), wedges.end(), [&](const Wedge& w) { return w.*end == wedge.from; });
    };
    return same(&Wedge::from) == 1 && same(&Wedge::to) == 1;
  });
}

bool isSimple(const Mesh& mesh, std::size_t vertex, std::span<const std::uint32_t> corners) {
  if (corners.empty() || corners.size() > kMostTriangles) return false;
  std::array<Wedge, kMostTriangles> all;
  const Vec3 apex(mesh.positions[vertex]);
  Vec3 normal(0);
  double largest = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Triangle& t = mesh.triangles[corners[i] / 3];
    const std::uint32_t k = corners[i] % 3;
    Wedge& wedge = all[i];
    wedge.from = t[(k + 1) % 3];
    wedge.to = t[(k + 2) % 3];
    wedge.u = Vec3(mesh.positions[wedge.from]) - apex;
    wedge.v = Vec3(mesh.positions[wedge.to]) - apex;
    normal += glm::cross(wedge.u, wedge.v);
    largest = std::max({largest, largestOf(wedge.u), largestOf(wedge.v)});
  }
  const std::span<const Wedge> wedges(all.data(), corners.size());
  const double error = kVolumeError * largest * largest * largestOf(normal);
  const auto turn = [&](Vec3 a, Vec3 b) { return glm::dot(glm::cross(a, b), normal); };
  const Vec3 first = wedges[0].u;
  for (const Wedge& wedge : wedges) {
    if (!(turn(wedge.u, wedge.v) > error)) return false;
    const bool isAtFirst = wedge.from == wedges[0].from || wedge.to == wedges[0].from;
    if (!isAtFirst && !(turn(wedge.u, first) < -error) && !(turn(first, wedge.v) < -error)) return false;
  }
  return formCycles(wedges);
}

}  // namespace

std::vector<std::uint8_t> simpleStars(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  std::vector<std::uint8_t> isAsked(mesh.positions.size(), triangles.empty());
  for (const std::uint32_t t : triangles)
    for (const std::uint32_t v : mesh.triangles[t]) isAsked[v] = 1;
  const CornerList corners(mesh, isAsked);
  parallelForPieces(isAsked.size(), kVerticesAPiece, [&](std::size_t v) {
    if (isAsked[v]) isAsked[v] = isSimple(mesh, v, corners.of(v));
  });
  return isAsked;
}

}  // namespace qrelief
