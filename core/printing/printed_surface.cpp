// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/printed_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/parallel.h"
#include "base/random.h"
#include "printing/cross_sections.h"
#include "printing/laid_outline.h"

namespace qrelief {
namespace {

using Corners = std::array<Vec3, 3>;
using Polygon = std::vector<Vec3>;

constexpr double kNodesPerFinest = 6;
constexpr double kTexelsPerLayer = 4;     // grooves between layers are seen
constexpr double kNearestStepMm = 0.004;  // of a ray that grazes plastic
constexpr double kHitMm = 5e-4;
/// However large the code and fine the process: what memory allows. A code of 35 mm has 990 texels with layers of 0.2
/// mm.
constexpr double kMaxTexels = 1000, kMaxNodes = 4e7;

/// Axes of the printer's space, of which the third points up, in the model's.
struct BuildSpace {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  explicit BuildSpace(Vec3 up) {
    z = glm::normalize(up);
    x = glm::normalize(glm::cross(std::abs(z.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0), z));
    y = glm::cross(z, x);
  }
  Vec3 to(Vec3 p) const { return {glm::dot(x, p), glm::dot(y, p), glm::dot(z, p)}; }
};

ProjectionFrame inBuildSpace(const ProjectionFrame& frame, const BuildSpace& space) {
  return {space.to(frame.centre), space.to(frame.right), space.to(frame.up), space.to(frame.normal), frame.eyeDistance};
}

/// The part of a convex polygon on the side that a plane's normal points to [Sutherland, Hodgman 1974].
Polygon clipped(const Polygon& polygon, Vec3 origin, Vec3 normal) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double overA = glm::dot(a - origin, normal), overB = glm::dot(b - origin, normal);
    if (overA >= 0) kept.push_back(a);
    if ((overA >= 0) != (overB >= 0)) kept.push_back(a + (b - a) * (overA / (overA - overB)));
  }
  return kept;
}

/// What the eye sees of a triangle through the square, if it faces the eye; at first no hidden part is left out.
Polygon seenPart(const Corners& triangle, const ProjectionFrame& frame, double extentMm) {
  if (glm::dot(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]), frame.eye() - triangle[0]) <= 0)
    return {};
  Polygon part(triangle.begin(), triangle.end());
  for (const Vec3 side : {frame.right, -frame.right, frame.up, -frame.up}) {
    // The plane through the eye and the square's edge on that side.
    part = clipped(part, frame.eye(), frame.normal * -(extentMm / 2) - side * frame.eyeDistance);
    if (part.empty()) return part;
  }
  return part;
}

struct Rectangle {
  Vec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  bool empty() const { return low.x > high.x; }
  void add(Vec3 p) {
    low = glm::min(low, Vec2(p.x, p.y));
    high = glm::max(high, Vec2(p.x, p.y));
  }
};

/// The printed layers that the eye may see, and what of them.
class Layers {
 public:
  Layers(std::vector<Corners> triangles, const ProjectionFrame& frame, double extentMm, const PrintProcess& process)
      : process_(process), frame_(frame), triangles_(std::move(triangles)) {
    bedMm_ = std::numeric_limits<double>::infinity();
    for (const Corners& triangle : triangles_)
      for (const Vec3& corner : triangle) bedMm_ = std::min(bedMm_, corner.z);
    findWindows(extentMm);
    lay();
  }

  double nearestMm() const { return nearestMm_; }
  double farthestMm() const { return farthestMm_; }

  /// Along the ray, from one distance from the eye to another; 0: it meets nothing.
  double firstMeeting(Vec3 direction, double fromMm, double toMm) const {
    if (grids_.empty()) return 0;
    const Vec3 eye = frame_.eye();
    const double top = topOf(static_cast<int>(grids_.size()) - 1), bottom = topOf(-1);
    double begin = fromMm, end = toMm;
    if (direction.z != 0) {
      const double a = (top - eye.z) / direction.z, b = (bottom - eye.z) / direction.z;
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    } else if (eye.z >= top || eye.z < bottom) {
      return 0;
    }
    int layer = layerAt(eye.z + direction.z * (begin + 1e-9));
    while (begin < end && layer >= 0 && layer < static_cast<int>(grids_.size())) {
      double leaves = end;
      if (direction.z != 0) leaves = std::min(end, (topOf(direction.z > 0 ? layer : layer - 1) - eye.z) / direction.z);
      if (const double met = meetingInLayer(layer, direction, begin, leaves); met > 0) return met;
      begin = std::max(begin, leaves);
      if (direction.z == 0) break;
      layer += direction.z > 0 ? 1 : -1;
    }
    return 0;
  }

 private:
  double topOf(int layer) const { return bedMm_ + (firstLayer_ + layer + 1) * process_.layerMm; }
  int layerAt(double z) const {
    return std::clamp(static_cast<int>(std::floor((z - bedMm_) / process_.layerMm)) - firstLayer_, 0,
                      static_cast<int>(grids_.size()) - 1);
  }

  void findWindows(double extentMm) {
    std::vector<Polygon> parts;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    nearestMm_ = least;
    farthestMm_ = 0;
    for (const Corners& triangle : triangles_) {
      Polygon part = seenPart(triangle, frame_, extentMm);
      if (part.empty()) continue;
      for (const Vec3& corner : part) {
        least = std::min(least, corner.z);
        most = std::max(most, corner.z);
        nearestMm_ = std::min(nearestMm_, frame_.distanceAlongAxis(corner));  // a corner need not be the nearest point
        farthestMm_ = std::max(farthestMm_, glm::distance(corner, frame_.eye()));
      }
      parts.push_back(std::move(part));
    }
    if (parts.empty()) return;
    const double h = process_.layerMm;
    firstLayer_ = std::max(0, static_cast<int>(std::floor((least - bedMm_) / h)) - 2);
    const int lastLayer = static_cast<int>(std::floor((most - bedMm_) / h)) + 2;
    windows_.resize(static_cast<std::size_t>(lastLayer - firstLayer_ + 1));
    for (const Polygon& part : parts) addToWindows(part);
    const double margin = 2 * process_.cornerRadiusMm + h;
    nearestMm_ -= 2 * margin;
    farthestMm_ += 2 * margin;
    for (Rectangle& window : windows_) {
      if (window.empty()) continue;
      window.low -= margin;
      window.high += margin;
    }
  }

  /// A layer is shaped by what lies up to one and a half layers from it.
  void addToWindows(const Polygon& part) {
    const double h = process_.layerMm;
    double least = part.front().z, most = part.front().z;
    for (const Vec3& corner : part) {
      least = std::min(least, corner.z);
      most = std::max(most, corner.z);
    }
    const int begin = std::max(0, static_cast<int>(std::floor((least - bedMm_) / h - 1.5)) - firstLayer_);
    const int end = std::min(static_cast<int>(windows_.size()),
                             static_cast<int>(std::floor((most - bedMm_) / h + 1.5)) - firstLayer_ + 1);
    for (int layer = begin; layer < end; ++layer) {
      Polygon within = clipped(part, Vec3(0, 0, topOf(layer) - 2.5 * h), Vec3(0, 0, 1));
      if (!within.empty()) within = clipped(within, Vec3(0, 0, topOf(layer) + 1.5 * h), Vec3(0, 0, -1));
      for (const Vec3& corner : within) windows_[static_cast<std::size_t>(layer)].add(corner);
    }
  }

  void lay() {
    grids_.resize(windows_.size());
    Rectangle all;
    for (const Rectangle& window : windows_) {
      if (window.empty()) continue;
      all.add(Vec3(window.low, 0));
      all.add(Vec3(window.high, 0));
    }
    if (all.empty()) return;
    double areaMm2 = 0;
    for (const Rectangle& window : windows_)
      if (!window.empty()) areaMm2 += (window.high.x - window.low.x) * (window.high.y - window.low.y);
    const double step = std::max(process_.finestMm / kNodesPerFinest, std::sqrt(areaMm2 / kMaxNodes));
    // Off every grid that a model may have been drawn on: no vertex stands straight above the corner.
    const Vec2 corner = all.low - step * Vec2(0.38196601125, 0.41421356237);
    const CuttingPlanes planes{bedMm_ + (firstLayer_ + 0.5) * process_.layerMm, process_.layerMm,
                               static_cast<int>(windows_.size())};
    const CrossSections sections = cutByPlanes(triangles_, planes, corner, all.high + step);
    parallelFor(windows_.size(), [&](std::size_t k) {
      const Rectangle& window = windows_[k];
      if (window.empty()) return;
      const Vec2 nodes = glm::ceil((window.high - window.low) / step) + 1.0;
      grids_[k] =
          layOutline(sections.outlines[k], {window.low, step, static_cast<int>(nodes.x), static_cast<int>(nodes.y)},
                     corner, sections.windings[k], process_);
    });
  }

  /// Distance from the plastic of a layer, no greater than it is.
  double distanceAt(const LayerGrid& grid, int layer, Vec3 p) const {
    const double h = process_.layerMm;
    const double v = (p.z - (topOf(layer) - h / 2)) / (h / 2);
    return grid.at(Vec2(p.x, p.y)) + process_.grooveMm * (1 - std::sqrt(std::max(0.0, 1 - v * v)));
  }

  double meetingInLayer(int layer, Vec3 direction, double begin, double end) const {
    const LayerGrid& grid = grids_[static_cast<std::size_t>(layer)];
    if (grid.empty()) return 0;
    const Vec3 eye = frame_.eye();
    const Vec2 high = grid.node(grid.columns - 1, grid.rows - 1);
    for (int axis = 0; axis < 2; ++axis) {
      if (direction[axis] == 0) {
        if (eye[axis] < grid.origin[axis] || eye[axis] > high[axis]) return 0;
        continue;
      }
      const double a = (grid.origin[axis] - eye[axis]) / direction[axis],
                   b = (high[axis] - eye[axis]) / direction[axis];
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
    if (begin >= end) return 0;
    // How fast the distance may fall along the ray; the flanks are steeper only where they are all but met.
    const double fall = std::hypot(direction.x, direction.y) + std::abs(direction.z);
    double before = begin;
    for (double t = begin;;) {
      const double distance = distanceAt(grid, layer, eye + direction * t);
      if (distance < kHitMm) return t == begin ? t : refined(grid, layer, direction, before, t);
      if (t >= end) return 0;
      before = t;
      t = std::min(end, t + std::max(distance / fall, kNearestStepMm));
    }
  }

  double refined(const LayerGrid& grid, int layer, Vec3 direction, double outside, double inside) const {
    for (int k = 0; k < 6; ++k) {
      const double middle = (outside + inside) / 2;
      (distanceAt(grid, layer, frame_.eye() + direction * middle) < kHitMm ? inside : outside) = middle;
    }
    return inside;
  }

  PrintProcess process_;
  ProjectionFrame frame_;
  std::vector<Corners> triangles_;
  double bedMm_ = 0, nearestMm_ = 0, farthestMm_ = 0;
  int firstLayer_ = 0;
  std::vector<Rectangle> windows_;
  std::vector<LayerGrid> grids_;
};

/// Greatest height within a ball's reach of every point, the ball's height there added [grey dilation by a ball]; with
/// a sign of −1 least heights, lessened [erosion].
std::vector<float> rolled(const std::vector<float>& distanceMm, int texels, double texelMm, double radiusMm,
                          float sign) {
  const int reach = static_cast<int>(radiusMm / texelMm);
  struct Step {
    int column, row;
    float height;
  };
  std::vector<Step> steps;
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column) {
      const double under = radiusMm * radiusMm - texelMm * texelMm * (row * row + column * column);
      if (under >= 0) steps.push_back({column, row, static_cast<float>(std::sqrt(under))});
    }
  std::vector<float> result(distanceMm.size(), 0);
  parallelFor(static_cast<std::size_t>(texels), [&](std::size_t y) {
    const int row = static_cast<int>(y);
    for (int column = 0; column < texels; ++column) {
      const auto at = [&](int c, int r) { return distanceMm[static_cast<std::size_t>(r * texels + c)]; };
      if (at(column, row) <= 0) continue;
      float highest = -std::numeric_limits<float>::infinity();
      for (const Step& step : steps) {
        const int c = column + step.column, r = row + step.row;
        if (c < 0 || r < 0 || c >= texels || r >= texels || at(c, r) <= 0) continue;
        highest = std::max(highest, -sign * at(c, r) + step.height);
      }
      result[y * static_cast<std::size_t>(texels) + static_cast<std::size_t>(column)] = -sign * highest;
    }
  });
  return result;
}

/// Fills what a ball cannot reach from the eye's side [grey closing]: plastic flows into what is narrower.
void fillCrevices(PrintedSurface& surface, double radiusMm) {
  surface.distanceMm = rolled(surface.distanceMm, surface.texels, surface.texelMm, radiusMm, 1);
  surface.distanceMm = rolled(surface.distanceMm, surface.texels, surface.texelMm, radiusMm, -1);
}

/// Moves every point along its ray by a little, the same on every run.
void roughen(PrintedSurface& surface, double deviationMm) {
  Random random(1);
  for (float& distance : surface.distanceMm)
    if (distance > 0) distance += static_cast<float>(deviationMm * random.normal());
}

}  // namespace

Mesh PrintedSurface::mesh() const {
  Mesh mesh;
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> vertices(distanceMm.size(), kNone);
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column) {
      const std::size_t i = static_cast<std::size_t>(row * texels + column);
      if (distanceMm[i] <= 0) continue;
      vertices[i] = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.emplace_back(frame.eye() +
                                  frame.rayDirection(planePoint(column, row)) * static_cast<double>(distanceMm[i]));
    }
  for (int row = 0; row + 1 < texels; ++row)
    for (int column = 0; column + 1 < texels; ++column) {
      const std::size_t i = static_cast<std::size_t>(row * texels + column),
                        above = i + static_cast<std::size_t>(texels);
      const std::array<std::uint32_t, 4> quad = {vertices[i], vertices[i + 1], vertices[above + 1], vertices[above]};
      if (std::find(quad.begin(), quad.end(), kNone) != quad.end()) continue;
      // Along the diagonal whose ends are nearer to one height.
      if (std::abs(distanceMm[i] - distanceMm[above + 1]) <= std::abs(distanceMm[i + 1] - distanceMm[above])) {
        mesh.triangles.push_back({quad[0], quad[1], quad[2]});
        mesh.triangles.push_back({quad[0], quad[2], quad[3]});
      } else {
        mesh.triangles.push_back({quad[0], quad[1], quad[3]});
        mesh.triangles.push_back({quad[1], quad[2], quad[3]});
      }
    }
  return mesh;
}

Result<PrintedSurface> printSurface(const Mesh& mesh, const PrintRequest& request) {
  const double length = glm::length(request.buildUp);
  if (!(std::isfinite(length) && length > 0)) return fail(ErrorKind::BadUsage, message("no-build-direction"));
  const BuildSpace space(request.buildUp);
  std::vector<Corners> triangles(mesh.triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) triangles[t][static_cast<std::size_t>(k)] = space.to(mesh.corner(t, k));
  const ProjectionFrame frame = inBuildSpace(request.frame, space);
  const Layers layers(std::move(triangles), frame, request.extentMm, request.process);

  PrintedSurface surface;
  surface.frame = request.frame;
  const PrintProcess& process = request.process;
  double texelMm = process.finestMm / kNodesPerFinest;
  if (process.grooveMm > 0) texelMm = std::min(texelMm, process.layerMm / kTexelsPerLayer);
  surface.texels = static_cast<int>(std::min(kMaxTexels, std::ceil(request.extentMm / texelMm)));
  surface.texelMm = request.extentMm / surface.texels;
  surface.distanceMm.assign(static_cast<std::size_t>(surface.texels) * static_cast<std::size_t>(surface.texels), 0);
  parallelFor(static_cast<std::size_t>(surface.texels), [&](std::size_t row) {
    for (int column = 0; column < surface.texels; ++column) {
      const Vec3 direction = frame.rayDirection(surface.planePoint(column, static_cast<int>(row)));
      surface.distanceMm[row * static_cast<std::size_t>(surface.texels) + static_cast<std::size_t>(column)] =
          static_cast<float>(layers.firstMeeting(direction, layers.nearestMm(), layers.farthestMm()));
    }
  });
  if (process.grooveMm > 0) fillCrevices(surface, process.grooveMm);
  if (process.grainMm > 0) roughen(surface, process.grainMm);
  return surface;
}

}  // namespace qrelief
