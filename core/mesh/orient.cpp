// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/orient.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/shell_nesting.h"

namespace qrelief {
namespace {

void turn(Triangle& triangle, std::array<std::uint32_t, 3>& neighbours) {
  std::swap(triangle[1], triangle[2]);
  std::swap(neighbours[0], neighbours[2]);  // edge 0 (corners 0, 1) becomes edge 2, edge 1 keeps its place
}

/// Returns true if `other` runs along edge k of `triangle` in the same direction: the two then face opposite ways.
bool runsAlong(const Triangle& triangle, std::size_t k, const Triangle& other) {
  for (std::size_t j = 0; j < 3; ++j)
    if (other[j] == triangle[k] && other[(j + 1) % 3] == triangle[(k + 1) % 3]) return true;
  return false;
}

/// Floods the shell of `seed` and returns its triangles. Sets `opposite` for each that faces the other way than the
/// seed.
std::vector<std::uint32_t> floodShell(std::span<const Triangle> triangles, const Adjacency& adjacency,
                                      std::uint32_t seed, std::vector<char>& opposite, Consistency& result) {
  const auto shell = static_cast<std::uint32_t>(result.shells.count++);
  std::vector<std::uint32_t> members{seed};
  result.shells.of[seed] = shell;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::uint32_t t = members[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t n = adjacency[t][k];
      if (n == kNoTriangle) continue;
      const auto isOpposite =
          static_cast<char>(opposite[t] ^ static_cast<char>(runsAlong(triangles[t], k, triangles[n])));
      if (result.shells.of[n] == kNoTriangle) {
        result.shells.of[n] = shell;
        opposite[n] = isOpposite;
        members.push_back(n);
      } else if (opposite[n] != isOpposite && !result.oneSided) {
        result.oneSided = t;
      }
    }
  }
  return members;
}

std::vector<double> sixfoldVolumes(const Mesh& mesh, const Shells& shells) {
  const Vec3 origin = boundingBox(mesh).centre();
  std::vector<double> volumes(shells.count, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    volumes[shells.of[t]] +=
        glm::dot(mesh.corner(t, 0) - origin, glm::cross(mesh.corner(t, 1) - origin, mesh.corner(t, 2) - origin));
  return volumes;
}

std::vector<char> closedShells(const Adjacency& adjacency, const Shells& shells) {
  std::vector<char> closed(shells.count, 1);
  for (std::size_t t = 0; t < adjacency.size(); ++t)
    for (const std::uint32_t n : adjacency[t])
      if (n == kNoTriangle) closed[shells.of[t]] = 0;
  return closed;
}

/// Leaves out the shells of other bodies.
void keepWithinBodies(const Shells& shells, std::span<const std::uint32_t> bodyOfTriangle,
                      std::vector<std::vector<std::uint32_t>>& enclosing) {
  std::vector<std::uint32_t> bodyOf(shells.count, 0);
  for (std::size_t t = 0; t < bodyOfTriangle.size(); ++t) bodyOf[shells.of[t]] = bodyOfTriangle[t];
  for (std::uint32_t s = 0; s < shells.count; ++s)
    std::erase_if(enclosing[s], [&](std::uint32_t outer) { return bodyOf[outer] != bodyOf[s]; });
}

}  // namespace

Consistency makeConsistent(std::vector<Triangle>& triangles, Adjacency& adjacency) {
  Consistency result;
  result.shells.of.assign(triangles.size(), kNoTriangle);
  std::vector<char> opposite(triangles.size(), 0);
  for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
    if (result.shells.of[seed] != kNoTriangle) continue;
    const std::vector<std::uint32_t> members = floodShell(triangles, adjacency, seed, opposite, result);
    std::size_t others = 0;
    for (const std::uint32_t t : members) others += static_cast<std::size_t>(opposite[t]);
    result.wasMixed.push_back(others > 0);
    const char turned = 2 * others > members.size() ? 0 : 1;
    if (others == 0) continue;
    for (const std::uint32_t t : members) {
      if (opposite[t] != turned) continue;
      turn(triangles[t], adjacency[t]);
      ++result.turned;
      if (!result.turnedExample) result.turnedExample = t;
    }
  }
  return result;
}

Outwardness orientOutwards(Mesh& mesh, Adjacency& adjacency, const Consistency& consistency,
                           std::span<const std::uint32_t> bodyOfTriangle) {
  const Shells& shells = consistency.shells;
  const std::vector<char> closed = closedShells(adjacency, shells);
  const std::vector<double> volumes = sixfoldVolumes(mesh, shells);
  ShellNesting nesting = enclosingShells(mesh, shells, closed);
  std::vector<std::vector<std::uint32_t>>& enclosing = nesting.enclosing;
  if (!bodyOfTriangle.empty()) keepWithinBodies(shells, bodyOfTriangle, enclosing);

  std::vector<char> wrong(shells.count, 0);  // judged by the number of shells around it
  for (std::size_t s = 0; s < shells.count; ++s)
    wrong[s] = closed[s] && (enclosing[s].size() % 2 == 0 ? volumes[s] < 0 : volumes[s] > 0);
  std::vector<char> turned(shells.count, 0);
  for (std::size_t s = 0; s < shells.count; ++s) {
    const bool allAroundWrong =
        std::all_of(enclosing[s].begin(), enclosing[s].end(), [&](std::uint32_t outer) { return wrong[outer] != 0; });
    turned[s] = wrong[s] && (allAroundWrong || consistency.wasMixed[s]);  // no shells around: true, too
  }

  Outwardness result;
  result.nestingKnown = nesting.known;
  result.solidOf.resize(shells.count);
  std::iota(result.solidOf.begin(), result.solidOf.end(), 0u);
  std::vector<char> seen(shells.count, 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t s = shells.of[t];
    if (turned[s]) turn(mesh.triangles[t], adjacency[t]);
    if (std::exchange(seen[s], 1)) continue;
    if (turned[s] && result.insideOut++ == 0) result.insideOutExample = t;
    const bool inwards = (volumes[s] < 0) != (turned[s] != 0);
    if (enclosing[s].empty()) continue;
    if (inwards) {
      result.solidOf[s] = *std::max_element(
          enclosing[s].begin(), enclosing[s].end(),
          [&](std::uint32_t a, std::uint32_t b) { return enclosing[a].size() < enclosing[b].size(); });
      if (result.cavities++ == 0) result.cavityExample = t;
    }
    if (!inwards && enclosing[s].size() % 2 == 1 && result.nestedSolids++ == 0) result.nestedExample = t;
  }
  return result;
}

}  // namespace qrelief
