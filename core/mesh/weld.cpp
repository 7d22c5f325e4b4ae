// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "mesh/topology.h"

namespace qrelief {

namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();

/// Number of points whose table slots are prefetched before the first is looked up, to hide memory latency.
constexpr std::size_t kAhead = 32;

/// Hashes three floats [Steele et al. 2014, SplitMix64's finaliser].
std::uint64_t hashOf(Vec3f p) {
  std::array<std::uint32_t, 3> bits;
  std::memcpy(bits.data(), &p, sizeof(bits));
  std::uint64_t h = bits[0] | std::uint64_t{bits[1]} << 32;
  for (const std::uint64_t more : {std::uint64_t{bits[2]}, std::uint64_t{0}}) {
    h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9u;
    h = (h ^ h >> 27) * 0x94d049bb133111ebu;
    h ^= h >> 31;
    h += more * 0x9e3779b97f4a7c15u;
  }
  return h;
}

}  // namespace

Welding weldEqual(std::span<const Vec3f> points, std::span<const std::uint32_t> groupOf) {
  std::size_t capacity = 16;
  while (capacity < 2 * points.size()) capacity *= 2;
  std::vector<std::uint32_t> table(capacity, kFree);
  Welding welding;
  welding.indexOf.reserve(points.size());
  std::vector<std::uint32_t> groups;  // of the positions
  const auto isOfGroup = [&](std::uint32_t position, std::size_t point) {
    return groupOf.empty() || groups[position] == groupOf[point];
  };
  std::array<std::size_t, kAhead> slots;
  for (std::size_t begin = 0; begin < points.size(); begin += kAhead) {
    const auto block = points.subspan(begin, std::min(kAhead, points.size() - begin));
    for (std::size_t i = 0; i < block.size(); ++i) {
      slots[i] = hashOf(block[i] + Vec3f(0)) & (capacity - 1);  // -0 becomes 0
      __builtin_prefetch(&table[slots[i]], 1);
    }
    for (std::size_t i = 0; i < block.size(); ++i) {
      const Vec3f p = block[i] + Vec3f(0);
      std::size_t slot = slots[i];
      while (table[slot] != kFree && (welding.positions[table[slot]] != p || !isOfGroup(table[slot], begin + i)))
        slot = (slot + 1) & (capacity - 1);
      if (table[slot] == kFree) {
        table[slot] = static_cast<std::uint32_t>(welding.positions.size());
        welding.positions.push_back(p);
        if (!groupOf.empty()) groups.push_back(groupOf[begin + i]);
      }
      welding.indexOf.push_back(table[slot]);
    }
  }
  return welding;
}

Mesh welded(std::span<const Vec3f> corners, std::vector<Triangle> triangles) {
  Welding welding = weldEqual(corners);
  for (Triangle& triangle : triangles)
    for (std::uint32_t& vertex : triangle) vertex = welding.indexOf[vertex];
  return {std::move(welding.positions), std::move(triangles)};
}

Mesh weldedByGroup(std::span<const Vec3f> corners, std::span<const std::uint32_t> groupOf) {
  std::vector<std::uint32_t> groupOfCorner;
  groupOfCorner.reserve(3 * groupOf.size());
  for (const std::uint32_t group : groupOf) groupOfCorner.insert(groupOfCorner.end(), 3, group);
  Welding welding = weldEqual(corners, groupOfCorner);
  Mesh mesh;
  mesh.positions = std::move(welding.positions);
  mesh.triangles.resize(corners.size() / 3);
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
    mesh.triangles[corner / 3][corner % 3] = welding.indexOf[corner];
  return mesh;
}

Mesh weldedByPiece(const Mesh& mesh) {
  const std::vector<std::uint32_t> pieceOf = piecesOf(mesh);
  std::vector<std::uint32_t> pointOf(mesh.positions.size(), kFree), pieceOfPoint;
  std::vector<Vec3f> points;
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) {
      if (pointOf[v] != kFree) continue;
      pointOf[v] = static_cast<std::uint32_t>(points.size());
      points.push_back(mesh.positions[v]);
      pieceOfPoint.push_back(pieceOf[v]);
    }
  Welding welding = weldEqual(points, pieceOfPoint);
  Mesh result;
  result.positions = std::move(welding.positions);
  result.triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    result.triangles.push_back({welding.indexOf[pointOf[a]], welding.indexOf[pointOf[b]], welding.indexOf[pointOf[c]]});
  result.bodyOf = mesh.bodyOf;
  return result;
}

void dropUnused(Mesh& mesh) {
  std::vector<std::uint32_t> newIndex(mesh.positions.size(), kFree);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) newIndex[v] = 0;
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < newIndex.size(); ++v) {
    if (newIndex[v] == kFree) continue;
    mesh.positions[count] = mesh.positions[v];
    newIndex[v] = count++;
  }
  mesh.positions.resize(count);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = newIndex[v];
}

Mesh meshOfSoup(const PolygonSoup& soup, double scaleToMm) {
  if (!soup.bodyOf.empty()) {
    std::vector<Vec3f> corners;
    corners.reserve(3 * soup.triangles.size());
    for (const Triangle& t : soup.triangles)
      for (const std::uint32_t v : t) corners.emplace_back(soup.positions[v] * scaleToMm);
    return weldedByGroup(corners, soup.bodyOf);
  }
  std::vector<char> used(soup.positions.size(), 0);
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  std::vector<Vec3f> points;
  std::vector<std::uint32_t> newIndex(used.size(), 0);
  points.reserve(used.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    newIndex[i] = static_cast<std::uint32_t>(points.size());
    points.emplace_back(soup.positions[i] * scaleToMm);
  }
  Welding welding = weldEqual(points);
  Mesh mesh;
  mesh.positions = std::move(welding.positions);
  mesh.triangles.reserve(soup.triangles.size());
  for (const auto& [a, b, c] : soup.triangles)
    mesh.triangles.push_back(
        {welding.indexOf[newIndex[a]], welding.indexOf[newIndex[b]], welding.indexOf[newIndex[c]]});
  return mesh;
}

}  // namespace qrelief
