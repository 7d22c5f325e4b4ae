// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/rewritten_3mf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/box.h"

namespace qrelief {
namespace {

/// Returns true if `read` is `expected` after a transform and its inverse, up to the last digit of a 32-bit float.
/// @param sizes  of what is added up to `expected`
bool isEqual(Vec3 read, Vec3 expected, Vec3 sizes) {
  for (int axis = 0; axis < 3; ++axis) {
    const double largest = std::max({std::abs(expected[axis]), std::abs(sizes[axis]), 1e-30});
    if (!(std::abs(read[axis] - expected[axis]) <= std::numeric_limits<float>::epsilon() * largest)) return false;
  }
  return true;
}

}  // namespace

ItemPose turnedItem(const ThreeMfSource& source, std::span<const ChangedRun> changes, const PolygonSoup& before,
                    Vec3 up) {
  ItemPose turned;
  if (changes.empty()) return turned;
  turned = {source.runs[changes.front().run].item, turnedUp(up)};
  if (turned.pose == Affine()) return turned;
  Box3 standing, lying;
  for (const ThreeMfRun& run : source.runs) {
    if (run.item != turned.item) continue;
    for (std::size_t t = run.firstTriangle; t < run.firstTriangle + run.count; ++t)
      for (const std::uint32_t v : before.triangles[t]) {
        const Vec3 p = before.positions[v] * source.unitMm;
        standing.add(p);
        lying.add(turned.pose(p));
      }
  }
  turned.pose.origin = {standing.centre().x - lying.centre().x, standing.centre().y - lying.centre().y,
                        standing.min.z - lying.min.z};
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
