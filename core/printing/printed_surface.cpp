// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/printed_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "base/parallel.h"
#include "base/random.h"
#include "message_codes/printing.h"
#include "printing/printed_layers.h"
#include "render/surface_raster.h"

namespace qrelief {
namespace {

constexpr double kTexelsPerFinest = 6;
constexpr double kTexelsPerFinestSeen = 4;  // for the solid before it is printed
constexpr double kTexelsPerLayer = 4;       // enough to show grooves between layers
/// Memory limit, however large the code and fine the process. A code of 35 mm has 990 texels with layers of 0.2 mm.
constexpr double kMaxTexels = 1000;
constexpr int kRowsOfBand = 32;

/// Axes of the printer's space in the model's space; the third points up.
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

/// Returns, for every point, the greatest sum of a height within a ball's reach and the ball's height there [grey
/// dilation by a ball]. With a sign of −1, returns the least difference [erosion].
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
      const auto at = [&](int c, int r) { return distanceMm[r * texels + c]; };
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

/// Fills crevices that a ball cannot reach from the eye's side [grey closing], because plastic flows into them.
void fillCrevices(PrintedSurface& surface, double radiusMm) {
  surface.distanceMm = rolled(surface.distanceMm, surface.texels, surface.texelMm, radiusMm, 1);
  surface.distanceMm = rolled(surface.distanceMm, surface.texels, surface.texelMm, radiusMm, -1);
}

/// Returns the least of each value and its neighbours up to `reach` texels along a row, transposed; two calls cover a
/// square.
std::vector<float> leastAlongRows(const std::vector<float>& values, int texels, int reach) {
  std::vector<float> least(values.size());
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(row) * texels;
      least[column * texels + row] =
          *std::min_element(first + std::max(column - reach, 0), first + std::min(column + reach + 1, texels));
    }
  return least;
}

/// Lower bounds of the distance at which rays hit plastic. Layers end up to half their height above the solid, and thin
/// lines lie outside it.
class NearestMaterial {
 public:
  NearestMaterial(const Mesh& mesh, const PrintRequest& request) : extentMm_(request.extentMm) {
    const PrintProcess& process = request.process;
    const double beyondMm = process.layerMm + process.thinnestLineMm / 2 + process.grooveMm;
    texels_ = std::clamp(static_cast<int>(std::ceil(extentMm_ / (process.finestMm / kTexelsPerFinestSeen))), 3,
                         static_cast<int>(kMaxTexels));
    const MapWindow window{extentMm_, texels_};
    const double eye = request.frame.eyeDistance;
    const SurfaceRaster raster(mesh, std::make_shared<const ClusteredTriangles>(oneCluster(mesh)));
    const std::vector<float> surface = raster.draw(request.frame, window);
    std::vector<float> distance(surface.size() / 4, std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < distance.size(); ++i) {
      if (surface[4 * i] == 0 && surface[4 * i + 1] == 0 && surface[4 * i + 2] == 0) continue;
      const auto at = window.planePoint(static_cast<int>(i % static_cast<std::size_t>(texels_)),
                                        static_cast<int>(i / static_cast<std::size_t>(texels_)));
      const double depth = eye - static_cast<double>(surface[4 * i + 3]);
      distance[i] = static_cast<float>(depth / eye * std::sqrt(glm::dot(at, at) + eye * eye) - beyondMm);
    }
    const int reach = static_cast<int>(std::ceil(beyondMm / window.texelMm())) + 1;
    distance_ = leastAlongRows(leastAlongRows(distance, texels_, reach), texels_, reach);
  }

  /// Returns 0 where the distance is unknown.
  double distance(Vec2 at) const {
    const Vec2 place = (at / extentMm_ + 0.5) * static_cast<double>(texels_);
    const int column = std::clamp(static_cast<int>(place.x), 0, texels_ - 1);
    const int row = std::clamp(static_cast<int>(place.y), 0, texels_ - 1);
    const float value = distance_[row * texels_ + column];
    return std::isfinite(value) ? static_cast<double>(value) : 0;
  }

 private:
  double extentMm_ = 0;
  int texels_ = 0;
  std::vector<float> distance_;
};

PrintedLayers layersOf(const Mesh& mesh, const PrintRequest& request) {
  const BuildSpace space(request.buildUp);
  std::vector<Vec3> positions;
  positions.reserve(mesh.positions.size());
  for (const Vec3f p : mesh.positions) positions.push_back(space.to(Vec3(p)));
  return {{positions, mesh.triangles},
          inBuildSpace(request.frame, space),
          request.extentMm,
          request.process,
          request.roughness};
}

/// Moves every point slightly along its ray, the same on every run.
void roughen(PrintedSurface& surface, double deviationMm) {
  Random random(1);
  for (float& distance : surface.distanceMm)
    if (distance > 0) distance += static_cast<float>(deviationMm * random.normal());
}

}  // namespace

float PrintedSurface::height(int column, int row) const {
  const double distance = static_cast<double>(
      distanceMm[static_cast<std::size_t>(row) * static_cast<std::size_t>(texels) + static_cast<std::size_t>(column)]);
  if (distance <= 0) return -std::numeric_limits<float>::infinity();
  const Vec2 at = planePoint(column, row);
  const double eye = frame.eyeDistance, way = std::sqrt(at.x * at.x + at.y * at.y + eye * eye);  // to the QR plane
  return static_cast<float>(eye * way / distance - eye);
}

HeightMap PrintedSurface::heightMap() const {
  std::vector<float> heights;
  heights.reserve(distanceMm.size());
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column) heights.push_back(height(column, row));
  const int size = texels + 1;
  const auto count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  HeightMap map{size,
                texelMm,
                frame.eyeDistance,
                std::vector<float>(count, HeightMap::kNothing),
                std::vector<float>(count, 0.0f),
                std::vector<float>(count, 0.0f),
                true};
  const auto perMm = static_cast<float>(0.5 / texelMm);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const int left = std::max(column - 1, 0), right = std::min(column, texels - 1);
      const float* const below = &heights[static_cast<std::size_t>(std::max(row - 1, 0) * texels)];
      const float* const above = &heights[static_cast<std::size_t>(std::min(row, texels - 1) * texels)];
      const float sum = below[left] + below[right] + above[left] + above[right];
      if (!std::isfinite(sum)) continue;
      const auto patch = static_cast<std::size_t>(row * size + column);
      map.height[patch] = sum / 4;
      map.slopeX[patch] = (below[right] - below[left] + above[right] - above[left]) * perMm;
      map.slopeY[patch] = (above[left] - below[left] + above[right] - below[right]) * perMm;
    }
  return map;
}

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
      if (std::abs(height(column, row) - height(column + 1, row + 1)) <=
          std::abs(height(column + 1, row) - height(column, row + 1))) {
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
  if (!(std::isfinite(length) && length > 0)) return fail(ErrorKind::BadUsage, message<"no-build-direction">());
  const PrintedLayers layers = layersOf(mesh, request);
  PrintedSurface surface;
  surface.frame = request.frame;
  const PrintProcess& process = request.process;
  double texelMm = process.finestMm / kTexelsPerFinest;
  if (process.grooveMm > 0) texelMm = std::min(texelMm, process.layerMm / kTexelsPerLayer);
  texelMm *= request.roughness;
  surface.texels = static_cast<int>(std::min(kMaxTexels, std::ceil(request.extentMm / texelMm)));
  surface.texelMm = request.extentMm / surface.texels;
  surface.distanceMm.assign(static_cast<std::size_t>(surface.texels) * static_cast<std::size_t>(surface.texels), 0);
  const NearestMaterial nearest(mesh, request);
  // In bands, so that two threads seldom need the same tile of a layer at the same time.
  parallelFor((surface.texels + kRowsOfBand - 1) / kRowsOfBand, [&](int band) {
    for (int row = band * kRowsOfBand; row < std::min(surface.texels, (band + 1) * kRowsOfBand); ++row)
      for (int column = 0; column < surface.texels; ++column) {
        const Vec2 at = surface.planePoint(column, row);
        surface.distanceMm[static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.texels) +
                           static_cast<std::size_t>(column)] =
            static_cast<float>(layers.firstHit(at, nearest.distance(at)));
      }
  });
  if (process.grooveMm > 0) fillCrevices(surface, process.grooveMm);
  if (process.grainMm > 0) roughen(surface, process.grainMm);
  return surface;
}

}  // namespace qrelief
