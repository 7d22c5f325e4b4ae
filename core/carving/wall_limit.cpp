// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/wall_limit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "carving/depth_field.h"
#include "carving/facet_tree.h"
#include "math/tolerance.h"
#include "projection/orientation.h"

namespace qrelief {
namespace {

/// The floor of one submodule is followed at its centre and its corners.
constexpr std::size_t kPoints = 5;

struct Column {
  std::array<Vec3, kPoints> surface;  // centre first
  std::array<Vec3, kPoints> down;     // unit, along the rays
  double spread = 0;                  // distance of the farthest corner from the centre
};

/// The surface over the submodules, as far as it is known.
class BaseSurface {
 public:
  BaseSurface(const ProjectionFrame& frame, int size, std::span<const float> distances, double symbolMm)
      : frame_(frame), grid_{.size = size, .symbolMm = symbolMm, .depthMm = {}} {
    // Depths below the eye, not distances from it: on a plane they change linearly from submodule to submodule.
    depths_.reserve(distances.size());
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        depths_.push_back(static_cast<double>(distances[depths_.size()]) *
                          -glm::dot(frame.rayDirection(middle(row, column)), frame.normal));
  }

  bool known(int row, int column) const { return std::isfinite(depth(row, column)); }

  /// Precondition: known(row, column).
  Column columnAt(int row, int column) const {
    Column result;
    place(result, 0, middle(row, column), depth(row, column));
    for (int k = 0; k < 4; ++k) {
      const std::size_t corner = static_cast<std::size_t>(k + 1);
      place(result, corner, grid_.corner(row + k / 2, column + k % 2), depthAtCorner(row + k / 2, column + k % 2));
      result.spread = std::max(result.spread, glm::distance(result.surface[0], result.surface[corner]));
    }
    return result;
  }

 private:
  Vec2 middle(int row, int column) const {
    return grid_.corner(row, column) + Vec2(grid_.submoduleMm(), -grid_.submoduleMm()) * 0.5;
  }

  /// NaN where unknown; outside the symbol carried on in a straight line.
  double depth(int row, int column) const {
    const int innerRow = std::clamp(row, 0, grid_.size - 1);
    const int innerColumn = std::clamp(column, 0, grid_.size - 1);
    const double inner = depths_[static_cast<std::size_t>(innerRow * grid_.size + innerColumn)];
    if ((innerRow == row && innerColumn == column) || grid_.size == 1) return inner;
    return 2 * inner - depth(2 * innerRow - row, 2 * innerColumn - column);
  }

  /// Mean of the four around it, or of those that are known: at least the submodule that the corner is asked for.
  double depthAtCorner(int row, int column) const {
    double sum = 0;
    int count = 0;
    for (const int r : {row - 1, row}) {
      for (const int c : {column - 1, column}) {
        if (!known(r, c)) continue;
        sum += depth(r, c);
        ++count;
      }
    }
    return sum / count;
  }

  void place(Column& column, std::size_t k, Vec2 planePoint, double depthMm) const {
    column.down[k] = frame_.rayDirection(planePoint);
    column.surface[k] = frame_.eye() + column.down[k] * (depthMm / -glm::dot(column.down[k], frame_.normal));
  }

  const ProjectionFrame& frame_;
  DepthField grid_;  // only its geometry is used
  std::vector<double> depths_;
};

/// Coordinates along the frame's axes: the carved region is flat in these.
Vec3 alongAxes(const ProjectionFrame& frame, Vec3 p) {
  return {glm::dot(p - frame.centre, frame.right), glm::dot(p - frame.centre, frame.up),
          glm::dot(p - frame.centre, frame.normal)};
}

/// Front-facing and wholly outside the patch's radius: not looked at, perhaps visible surface.
bool isUnknown(const FacetTree::Facet& facet, const VisiblePatch& patch, const ProjectionFrame& frame) {
  const auto inFront = [&](Vec3 p) { return frame.distanceAlongAxis(p) > kNearPlaneShare * frame.eyeDistance; };
  if (sideOfPlane(facet[0], facet[1], facet[2], frame.eye()) <= 0) return false;
  if (!std::all_of(facet.begin(), facet.end(), inFront)) return false;
  const Triangle2 image{frame.project(facet[0]), frame.project(facet[1]), frame.project(facet[2])};
  return distanceToTriangle(Vec2(0), image) > patch.radiusMm;
}

FacetTree wallsNear(const Mesh& mesh, const VisiblePatch& patch, const ProjectionFrame& frame, const Box3& region) {
  std::vector<Vec3> positions;
  positions.reserve(mesh.positions.size());
  for (const Vec3f& p : mesh.positions) positions.push_back(alongAxes(frame, Vec3(p)));
  std::vector<std::uint8_t> inPatch(mesh.triangles.size(), 0);
  for (const std::uint32_t t : patch.triangles) inPatch[t] = 1;
  std::vector<FacetTree::Facet> facets;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (inPatch[t] != 0) continue;
    Box3 box;
    for (const std::uint32_t v : mesh.triangles[t]) box.add(positions[v]);
    const bool apart = glm::any(glm::lessThan(box.max, region.min)) || glm::any(glm::greaterThan(box.min, region.max));
    if (apart) continue;
    const FacetTree::Facet facet{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    if (!isUnknown(facet, patch, frame)) facets.push_back(facet);
  }
  return FacetTree(std::move(facets));
}

/// Least distance of the floor at `depth` from the walls; `reach` if that is less.
double clearance(const FacetTree& walls, const Column& column, double depth, double reach) {
  double least = reach;
  for (std::size_t k = 0; k < kPoints; ++k) least = walls.distance(column.surface[k] + column.down[k] * depth, least);
  return least;
}

double limitOf(const FacetTree& walls, const Column& column, const WallLimitOptions& options) {
  const double enough = options.maxDepthMm + column.spread + options.minWallMm;
  if (walls.distance(column.surface[0], enough) >= enough) return options.maxDepthMm;

  double depth = 0;
  for (;;) {
    const double reach = options.minWallMm + options.maxDepthMm - depth;
    const double spare = clearance(walls, column, depth, reach) - options.minWallMm;
    if (spare < 0) return std::max(0.0, depth - kDepthQuantumMm / 2);
    depth += std::max(spare, kDepthQuantumMm / 2);
    if (depth >= options.maxDepthMm) return options.maxDepthMm;
  }
}

}  // namespace

std::vector<double> wallLimits(const Mesh& mesh, const VisiblePatch& patch, const ProjectionFrame& frame,
                               const SubmoduleMask& carved, std::span<const float> baseDistanceMm,
                               const WallLimitOptions& options) {
  assert(carved.size > 0 && carved.carved.size() == static_cast<std::size_t>(carved.size) * carved.size);
  assert(baseDistanceMm.size() == carved.carved.size() && options.symbolMm > 0);
  std::vector<double> limits(carved.carved.size(), 0);
  if (options.maxDepthMm <= 0) return limits;

  std::vector<std::uint32_t> indices;
  std::vector<Column> columns;
  Box3 region;
  const BaseSurface surface(frame, carved.size, baseDistanceMm, options.symbolMm);
  for (int row = 0; row < carved.size; ++row) {
    for (int column = 0; column < carved.size; ++column) {
      if (!carved.isCarved(row, column) || !surface.known(row, column)) continue;
      indices.push_back(static_cast<std::uint32_t>(row * carved.size + column));
      columns.push_back(surface.columnAt(row, column));
      for (const Vec3 p : columns.back().surface) region.add(alongAxes(frame, p));
    }
  }
  if (columns.empty()) return limits;
  const double reach = options.maxDepthMm + options.minWallMm;
  region.min -= Vec3(reach);
  region.max += Vec3(reach);

  const FacetTree walls = wallsNear(mesh, patch, frame, region);
  for (std::size_t k = 0; k < columns.size(); ++k) limits[indices[k]] = limitOf(walls, columns[k], options);
  return limits;
}

}  // namespace qrelief
