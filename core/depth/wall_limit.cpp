// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/wall_limit.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "base/parallel.h"
#include "depth/facet_tree.h"
#include "math/orientation.h"
#include "math/tolerance.h"
#include "projection/facet_locator.h"

namespace qrelief {
namespace {

/// Sampled points along a submodule's edge, minus one.
constexpr int kStepsPerEdge = 2;

/// A point of the surface over the symbol.
struct Sample {
  Vec3 surface{0}, down{0};  // down: unit, along the ray
  Vec3 normal{0};            // of the facet, unit; zero where there is no surface
};

/// Returns the projected corners, counter-clockwise; empty if the facet is not seen from the front or not in front of
/// the eye.
std::optional<Triangle2> imageOf(const Mesh& mesh, const ProjectionFrame& frame, std::uint32_t t) {
  Triangle2 image;
  for (int k = 0; k < 3; ++k) {
    const Vec3 corner = mesh.corner(t, k);
    if (frame.distanceAlongAxis(corner) <= kNearPlaneFraction * frame.eyeDistance) return std::nullopt;
    image[k] = frame.project(corner);
  }
  if (cross2(image[1] - image[0], image[2] - image[0]) <= 0) return std::nullopt;
  return image;
}

/// The part of the patch over the symbol; finds the surface under a plane point.
class BaseSurface {
 public:
  BaseSurface(const Mesh& mesh, const VisiblePatch& patch, const ProjectionFrame& frame, double symbolMm)
      : mesh_(mesh), frame_(frame) {
    std::vector<Triangle2> images;
    for (const std::uint32_t t : patch.triangles) {
      const auto image = imageOf(mesh, frame, t);
      if (!image) continue;
      const Vec2 lo = glm::min(glm::min((*image)[0], (*image)[1]), (*image)[2]);
      const Vec2 hi = glm::max(glm::max((*image)[0], (*image)[1]), (*image)[2]);
      if (std::max(lo.x, lo.y) > symbolMm / 2 || std::min(hi.x, hi.y) < -symbolMm / 2) continue;
      facets_.push_back(t);
      images.push_back(*image);
    }
    if (!images.empty()) locator_.emplace(std::move(images));
  }

  Sample at(Vec2 point) {
    Sample sample;
    if (!locator_) return sample;
    const std::uint32_t facet = locator_->nearest(point);
    if (locator_->depthIn(facet, point) < -kCoveredMm) return sample;
    sample.normal = triangleNormal(mesh_, facets_[facet]);
    sample.down = frame_.rayDirection(point);
    const Vec3 eye = frame_.eye();
    const double along = glm::dot(sample.normal, mesh_.corner(facets_[facet], 0) - eye);
    sample.surface = eye + sample.down * (along / glm::dot(sample.normal, sample.down));
    return sample;
  }

 private:
  const Mesh& mesh_;
  const ProjectionFrame& frame_;
  std::vector<std::uint32_t> facets_;
  std::optional<FacetLocator> locator_;
};

/// Returns coordinates along the frame's axes, in which the carved region is flat.
Vec3 alongAxes(const ProjectionFrame& frame, Vec3 p) {
  return {glm::dot(p - frame.centre, frame.right), glm::dot(p - frame.centre, frame.up),
          glm::dot(p - frame.centre, frame.normal)};
}

/// Returns true for a facet that is front-facing and wholly outside the patch's radius: untested, perhaps visible
/// surface.
bool isUnknown(const FacetTree::Facet& facet, const VisiblePatch& patch, const ProjectionFrame& frame) {
  const auto inFront = [&](Vec3 p) { return frame.distanceAlongAxis(p) > kNearPlaneFraction * frame.eyeDistance; };
  if (sideOfPlane(facet[0], facet[1], facet[2], frame.eye()) <= 0) return false;
  if (!std::all_of(facet.begin(), facet.end(), inFront)) return false;
  const Triangle2 image{frame.project(facet[0]), frame.project(facet[1]), frame.project(facet[2])};
  return distanceToTriangle(Vec2(0), image) > patch.radiusMm;
}

/// Returns true if the eye sees a facet of the patch nearly edge-on. A facet may be far larger than the code, so its
/// middle is moved to the carved region: the eye is as far from the facet's plane there as anywhere.
/// @param region  along the frame's axes
bool isGrazing(const FacetTree::Facet& facet, const ProjectionFrame& frame, const Box3& region) {
  const Vec3 normal = glm::cross(facet[1] - facet[0], facet[2] - facet[0]);
  const Vec3 middle = glm::clamp(alongAxes(frame, (facet[0] + facet[1] + facet[2]) / 3.0), region.min, region.max);
  const double distance = glm::length(alongAxes(frame, frame.eye()) - middle);
  return glm::dot(normal, frame.eye() - facet[0]) < kGrazingCosine * glm::length(normal) * distance;
}

struct Sides {
  FacetTree walls;    ///< other sides of the material wherever a pocket is
  FacetTree surface;  ///< facets of the patch: other sides for facets that face away from them
  FacetTree others;   ///< facets of other bodies, which pockets may touch but not enter
};

/// Returns a flag for each body, 1 if pockets in `body` must keep a wall before it: for `body` itself, and for every
/// body within its bounding box, which may be a cavity that is not turned inside out.
std::vector<std::uint8_t> boundingBodies(const Mesh& mesh, std::uint32_t body) {
  if (mesh.bodyOf.empty()) return {1};
  std::vector<Box3> boxes(*std::max_element(mesh.bodyOf.begin(), mesh.bodyOf.end()) + std::size_t{1});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) boxes[mesh.bodyOf[t]].add(Vec3(mesh.positions[v]));
  const Box3& own = boxes[body];
  std::vector<std::uint8_t> bounds;
  for (const Box3& box : boxes)
    bounds.push_back(glm::all(glm::greaterThan(box.min, own.min)) && glm::all(glm::lessThan(box.max, own.max)));
  bounds[body] = 1;
  return bounds;
}

Sides sidesNear(const Mesh& mesh, const VisiblePatch& patch, const ProjectionFrame& frame, const Box3& region) {
  std::vector<Vec3> positions;
  positions.reserve(mesh.positions.size());
  for (const Vec3f& p : mesh.positions) positions.push_back(alongAxes(frame, Vec3(p)));
  std::vector<std::uint8_t> inPatch(mesh.triangles.size(), 0);
  for (const std::uint32_t t : patch.triangles) inPatch[t] = 1;
  std::vector<FacetTree::Facet> walls, surface, others;
  const std::uint32_t carved = patch.triangles.empty() ? 0 : mesh.body(patch.triangles.front());
  const std::vector<std::uint8_t> bounds = boundingBodies(mesh, carved);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Box3 box;
    for (const std::uint32_t v : mesh.triangles[t]) box.add(positions[v]);
    const bool apart = glm::any(glm::lessThan(box.max, region.min)) || glm::any(glm::greaterThan(box.min, region.max));
    if (apart) continue;
    const FacetTree::Facet facet{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    if (bounds[mesh.body(t)] == 0)
      others.push_back(facet);
    else if (inPatch[t] != 0 && !isGrazing(facet, frame, region))
      surface.push_back(facet);
    else if (inPatch[t] != 0 || mesh.body(t) != carved || !isUnknown(facet, patch, frame))
      walls.push_back(facet);
  }
  return {FacetTree(walls), FacetTree(surface), FacetTree(others)};
}

struct Hints {
  FacetTree::Hint walls, surface, others;
};

/// Returns how much farther the floor may go, at least, until it comes too near to another side of the material.
/// Negative where it has.
/// @param reach  limit of the distances that are measured
double spareBeforeWalls(const Sides& sides, const Sample& sample, Vec3 point, double minWallMm, double reach,
                        Hints& hints) {
  return sides.surface.distanceOfTurned(point, sides.walls.distance(point, reach, hints.walls), sample.normal,
                                        kOppositeCosine, hints.surface) -
         minWallMm;
}

double limitOf(const Sides& sides, const Sample& sample, const WallLimitOptions& options, Hints& hints) {
  constexpr double kContactMm = kDepthQuantumMm / 2;
  // Where another body has its surface in the same place, no depth helps; the caller says so (hasTwinSurface).
  const bool isTwin = sides.others.distance(sample.surface, kDepthQuantumMm, hints.others) < kContactMm;
  double depth = 0;
  for (;;) {
    const double reach = options.minWallMm + options.maxDepthMm - depth;
    const Vec3 point = sample.surface + sample.down * depth;
    double spare = spareBeforeWalls(sides, sample, point, options.minWallMm, reach, hints);
    if (!isTwin) spare = std::min(spare, sides.others.distance(point, reach, hints.others) - kContactMm);
    if (spare < 0) return std::max(0.0, depth - kDepthQuantumMm / 2);
    depth += std::max(spare, kDepthQuantumMm / 2);
    if (depth >= options.maxDepthMm) return options.maxDepthMm;
  }
}

/// The sampled points of the carved submodules, each once.
class SampleGrid {
 public:
  SampleGrid(const SubmoduleMask& carved, double symbolMm)
      : carved_(carved), symbolMm_(symbolMm), side_(kStepsPerEdge * carved.rows() + 1) {
    used_.assign(static_cast<std::size_t>(side_ * side_), 0);
    forEachCarved([&](std::size_t, std::size_t point) { used_[point] = 1; });
  }

  /// Calls `visit(submodule, point)` for each pair of a carved submodule and a point of it.
  template <class Visit>
  void forEachCarved(const Visit& visit) const {
    for (int row = 0; row < carved_.rows(); ++row)
      for (int column = 0; column < carved_.columns(); ++column)
        for (int k = 0; carved_.at(row, column) && k < (kStepsPerEdge + 1) * (kStepsPerEdge + 1); ++k)
          visit(carved_.index(row, column),
                static_cast<std::size_t>((kStepsPerEdge * row + k / (kStepsPerEdge + 1)) * side_ +
                                         kStepsPerEdge * column + k % (kStepsPerEdge + 1)));
  }

  int side() const { return side_; }
  std::size_t size() const { return used_.size(); }
  bool isUsed(std::size_t point) const { return used_[point] != 0; }
  Vec2 at(std::size_t point) const {
    const double step = symbolMm_ / (side_ - 1);
    const std::size_t row = point / static_cast<std::size_t>(side_), column = point % static_cast<std::size_t>(side_);
    return {-symbolMm_ / 2 + static_cast<double>(column) * step, symbolMm_ / 2 - static_cast<double>(row) * step};
  }

 private:
  const SubmoduleMask& carved_;
  const double symbolMm_;
  const int side_;
  std::vector<std::uint8_t> used_;
};

}  // namespace

std::vector<double> wallLimits(const Mesh& mesh, const VisiblePatch& patch, const ProjectionFrame& frame,
                               const SubmoduleMask& carved, const WallLimitOptions& options) {
  assert(carved.rows() == carved.columns());
  assert(options.symbolMm > 0);
  std::vector<double> limits(carved.size(), 0);
  if (options.maxDepthMm <= 0) return limits;

  const SampleGrid grid(carved, options.symbolMm);
  BaseSurface surface(mesh, patch, frame, options.symbolMm);
  std::vector<Sample> samples(grid.size());
  Box3 region;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!grid.isUsed(k)) continue;
    samples[k] = surface.at(grid.at(k));
    if (samples[k].normal != Vec3(0)) region.add(alongAxes(frame, samples[k].surface));
  }
  const double reach = options.maxDepthMm + options.minWallMm;
  region.min -= Vec3(reach);
  region.max += Vec3(reach);

  const Sides sides = sidesNear(mesh, patch, frame, region);
  std::vector<double> sampleLimits(samples.size(), 0);
  const auto side = static_cast<std::size_t>(grid.side());
  parallelFor(side, [&](std::size_t row) {
    Hints hints;
    for (std::size_t k = row * side; k < (row + 1) * side; ++k)
      if (samples[k].normal != Vec3(0)) sampleLimits[k] = limitOf(sides, samples[k], options, hints);
  });
  grid.forEachCarved([&](std::size_t submodule, std::size_t) { limits[submodule] = options.maxDepthMm; });
  grid.forEachCarved([&](std::size_t submodule, std::size_t point) {
    limits[submodule] = std::min(limits[submodule], sampleLimits[point]);
  });
  return limits;
}

}  // namespace qrelief
