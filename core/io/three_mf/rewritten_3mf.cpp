// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/rewritten_3mf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/box.h"

namespace qrelief {
namespace {

constexpr double kClearMm = 5;  // between a turned item and its neighbours

/// Returns true if `read` is `expected` after a transform and its inverse, up to the last digit of a 32-bit float.
/// @param sizes  of what is added up to `expected`
bool isEqual(Vec3 read, Vec3 expected, Vec3 sizes) {
  for (int axis = 0; axis < 3; ++axis) {
    const double largest = std::max({std::abs(expected[axis]), std::abs(sizes[axis]), 1e-30});
    if (!(std::abs(read[axis] - expected[axis]) <= std::numeric_limits<float>::epsilon() * largest)) return false;
  }
  return true;
}

/// Returns true if two boxes share a place on the plate, seen from above. An empty box shares none.
bool overlapOnPlate(const Box3& a, const Box3& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

}  // namespace

ItemPose turnedItem(const ThreeMfSource& source, std::span<const ChangedRun> changes, const PolygonSoup& before,
                    Vec3 up) {
  ItemPose turned;
  if (changes.empty()) return turned;
  turned = {source.runs[changes.front().run].item, turnedUp(up)};
  if (turned.pose == Affine()) return turned;
  Box3 standing, lying;
  std::vector<Box3> others;
  for (const ThreeMfRun& run : source.runs) {
    const bool isOther = run.item != turned.item;
    if (isOther && others.size() <= run.item) others.resize(run.item + 1);
    for (std::size_t t = run.firstTriangle; t < run.firstTriangle + run.count; ++t)
      for (const std::uint32_t v : before.triangles[t]) {
        const Vec3 p = before.positions[v] * source.unitMm;
        (isOther ? others[run.item] : standing).add(p);
        if (!isOther) lying.add(turned.pose(p));
      }
  }
  Vec3& move = turned.pose.origin;
  move = {standing.centre().x - lying.centre().x, standing.centre().y - lying.centre().y, standing.min.z - lying.min.z};
  for (bool isClear = false; !isClear;) {
    isClear = true;
    for (const Box3& other : others) {
      if (!overlapOnPlate({lying.min + move, lying.max + move}, other) || overlapOnPlate(standing, other)) continue;
      move.x = other.max.x + kClearMm - lying.min.x;  // ever farther to the right
      isClear = false;
    }
  }
  return turned;
}

bool holdsChanges(const PolygonSoup& read, const PolygonSoup& before, const ThreeMfSource& source,
                  std::span<const ChangedRun> changes, const ItemPose& turned) {
  std::size_t at = 0;
  const auto isPosed = [&](Vec3 point, Vec3 expected, const ThreeMfRun& run) {
    const Affine pose = turned.of(run);
    const double size = pose == Affine() ? 0 : glm::length(expected) + glm::length(pose.origin);
    return isEqual(point, pose(expected), glm::abs(run.toFile.origin) * source.unitMm + size);
  };
  const auto isNext = [&](const Mesh& mesh, const ThreeMfRun& run) {
    if (read.triangles.size() - at < mesh.triangles.size()) return false;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t, ++at)
      for (std::size_t k = 0; k < 3; ++k)
        if (!isPosed(read.positions[read.triangles[at][k]] * source.unitMm, Vec3(mesh.corner(t, static_cast<int>(k))),
                     run))
          return false;
    return true;
  };
  for (std::size_t r = 0; r < source.runs.size(); ++r) {
    const ThreeMfRun& run = source.runs[r];
    const auto change = std::find_if(changes.begin(), changes.end(), [&](const ChangedRun& c) { return c.run == r; });
    if (change != changes.end()) {
      if (!isNext(change->mesh, run)) return false;
    } else {
      if (read.triangles.size() - at < run.count) return false;
      for (std::size_t t = run.firstTriangle; t < run.firstTriangle + run.count; ++t, ++at)
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3 now = read.positions[read.triangles[at][k]], then = before.positions[before.triangles[t][k]];
          if (turned.of(run) == Affine() ? now != then : !isPosed(now * source.unitMm, then * source.unitMm, run))
            return false;
        }
    }
    // An inlay follows the mesh that it belongs to.
    const bool endsMesh = r + 1 == source.runs.size() || source.runs[r + 1].object != run.object ||
                          source.runs[r + 1].part != run.part || source.runs[r + 1].item != run.item;
    if (!endsMesh) continue;
    for (const ChangedRun& c : changes)
      if (c.inlay && source.runs[c.run].object == run.object && source.runs[c.run].part == run.part)
        if (!isNext(c.inlay->mesh, run)) return false;
  }
  return at == read.triangles.size();
}

}  // namespace qrelief
