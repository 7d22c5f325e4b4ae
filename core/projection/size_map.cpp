// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/size_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/parallel.h"
#include "math/angle.h"
#include "mesh/cluster.h"
#include "mesh/refine.h"
#include "projection/distance_transform.h"
#include "projection/view_raster.h"

namespace qrelief {
namespace {

constexpr double kTexelsPerSquare = 16;
constexpr int kMinTexels = 128;
constexpr int kMaxTexels = 512;
constexpr double kBorderTexels = 2;  // background around the model, so that some texel is always blocked
// Greatest distance from the middle of a blocked texel to the contour through it.
constexpr double kBlockedTexels = 0.5;
constexpr int kViewsAtOnce = 4;    // each needs 9 bytes for each texel
constexpr double kSamples = 6000;  // approximate least number of vertices

double cosineOfDegrees(double degrees) { return std::cos(toRadians(degrees)); }

double surfaceArea(const Mesh& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 a = mesh.corner(t, 0);
    area += glm::length(glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a)) / 2;
  }
  return area;
}

/// Returns the smallest radius about the centre that encloses all vertices.
double radiusAbout(const Mesh& mesh, Vec3 centre) {
  double squared = 0;
  for (const Vec3f& p : mesh.positions) squared = std::max(squared, glm::dot(Vec3(p) - centre, Vec3(p) - centre));
  return std::sqrt(squared);
}

/// Computes the mean normal of the facets around each vertex, weighted by area; shorter than 1 where they differ.
std::vector<Vec3> meanNormals(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size(), Vec3(0));
  std::vector<double> area(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 a = mesh.corner(t, 0);
    const Vec3 across = glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a);
    for (const std::uint32_t v : mesh.triangles[t]) {
      normals[v] += across;
      area[v] += glm::length(across);
    }
  }
  for (std::size_t v = 0; v < normals.size(); ++v)
    if (area[v] > 0) normals[v] /= area[v];
  return normals;
}

/// Fills in mesh, normals, vertexOf.
SizeMap sampled(const Mesh& mesh, std::span<const Vec3f> normals, std::size_t facets) {
  SizeMap map;
  const double area = surfaceArea(mesh);
  if (mesh.triangles.size() > facets + facets / 2) {
    // A surface passes through about 1.5 cells of edge h for each h² of its area, and there are two facets per vertex.
    ClusteredMesh coarse = clusterVertices(mesh, normals, std::sqrt(3 * area / static_cast<double>(facets)));
    map.mesh = std::move(coarse.mesh);
    map.vertexOf = std::move(coarse.clusterOf);
    map.isCoarser = true;
  } else {
    map.mesh = mesh;
    map.vertexOf.resize(mesh.positions.size());
    std::iota(map.vertexOf.begin(), map.vertexOf.end(), 0u);
  }
  // Facets of edge e have an area of 0.87 e² per vertex; half that where edges have just been halved.
  map.mesh = refineEdges(std::move(map.mesh), 1.5 * std::sqrt(area / kSamples), 2 * facets);
  map.normals = vertexNormals(map.mesh);
  map.sizeMm.assign(map.mesh.positions.size(), 0.0f);
  map.direction.assign(map.mesh.positions.size(), Vec3f(0));
  return map;
}

}  // namespace

Vec3 latticeDirection(int index, int count) {
  assert(index >= 0 && index < count);
  const double z = 1 - (2 * index + 1.0) / count;
  const double angle = index * std::numbers::pi * (3 - std::sqrt(5.0));
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

struct SizeMapSearch::State {
  /// A square about a vertex that fits at every rotation in one view.
  struct Seen {
    std::uint32_t vertex = 0;
    double sizeMm = 0, score = 0;
    Vec3f direction{0};
  };
  /// One view and the raster that draws it.
  struct View {
    ViewRaster raster;
    bool isDropped = false;
    std::vector<Seen> seen = {};  // only those that are better than all earlier ones
  };

  SizeMapOptions options;
  SizeMap map;
  Adjacency adjacency;
  Vec3 centre{0};
  double radius = 0;
  RasterWindow window;
  std::vector<View> views;  // drawn at the same time
  std::vector<Vec3> meanNormal;
  std::vector<double> score;  // per vertex: score of its best view
  int viewsDone = 0;

  void lookFrom(Vec3 direction, View& view) const;
  double radiusAround(const ViewRaster& raster, std::span<const std::int32_t> squared, std::uint32_t vertex) const;
  void add(const View& view);
};

/// Returns the distance in texels from the nearest blocked texel, interpolated between the four texels around the
/// vertex.
double SizeMapSearch::State::radiusAround(const ViewRaster& raster, std::span<const std::int32_t> squared,
                                          std::uint32_t vertex) const {
  const Vec2 at = raster.at(vertex) - 0.5;
  const int column = std::clamp(static_cast<int>(at.x), 0, window.texels - 2);
  const int row = std::clamp(static_cast<int>(at.y), 0, window.texels - 2);
  const auto distance = [&](int dx, int dy) {
    return std::sqrt(static_cast<double>(squared[(row + dy) * window.texels + column + dx]));
  };
  const Vec2 fraction = at - Vec2(column, row);
  return (1 - fraction.y) * ((1 - fraction.x) * distance(0, 0) + fraction.x * distance(1, 0)) +
         fraction.y * ((1 - fraction.x) * distance(0, 1) + fraction.x * distance(1, 1));
}

void SizeMapSearch::State::lookFrom(Vec3 direction, View& view) const {
  const ProjectionFrame frame = makeFrame(centre, direction, {0, 0, 1}, radius + options.eyeDistanceMm);
  ViewRaster& raster = view.raster;
  raster.draw(frame, window, cosineOfDegrees(kMaxTiltDeg));
  view.seen.clear();
  // The isoptic test. Parts behind the middle look smaller than they are, and so would a code there.
  const double shrink = frame.eyeDistance / (frame.eyeDistance + radius);
  view.isDropped = raster.coveredMm2() < std::pow(options.minMm * shrink, 2);
  if (view.isDropped) return;
  const std::vector<std::int32_t> squared = squaredDistances(raster.blocked(), window.texels);
  const Vec3 eye = frame.eye();
  const double leastCentreCosine = cosineOfDegrees(kMaxCentreTiltDeg);
  for (std::uint32_t v = 0; v < map.mesh.positions.size(); ++v) {
    const Vec3 fromVertex = eye - Vec3(map.mesh.positions[v]);
    const double distance = glm::length(fromVertex);
    const Vec3 toEye = fromVertex / distance;
    const double facing = glm::dot(meanNormal[v], toEye);
    if (facing < leastCentreCosine) continue;
    const double texels = radiusAround(raster, squared, v) - kBlockedTexels;
    if (texels < 2) continue;
    // At an angle α off the axis a disc of radius r at distance ρ, facing the eye, reaches r·F / (ρ·cos²α) on the
    // plane at distance F.
    const double cosine = glm::dot(toEye, frame.normal);
    const double sizeMm =
        std::numbers::sqrt2 * texels * window.texelMm() * distance * cosine * cosine / frame.eyeDistance;
    if (sizeMm * facing <= score[v] || !raster.sees(v)) continue;
    view.seen.push_back({v, sizeMm, sizeMm * facing, Vec3f(toEye)});
  }
}

void SizeMapSearch::State::add(const View& view) {
  if (view.isDropped) ++map.viewsDropped;
  for (const Seen& seen : view.seen) {
    if (seen.score <= score[seen.vertex]) continue;
    score[seen.vertex] = seen.score;
    map.sizeMm[seen.vertex] = static_cast<float>(seen.sizeMm);
    map.direction[seen.vertex] = seen.direction;
  }
}

SizeMapSearch::SizeMapSearch(const Mesh& mesh, std::span<const Vec3f> normals, const SizeMapOptions& options)
    : state_(std::make_unique<State>()) {
  assert(options.eyeDistanceMm > 0 && options.minMm > 0 && options.views > 0 && options.facets >= 100);
  State& s = *state_;
  s.options = options;
  if (options.onlyFrom) s.options.views = 1;
  s.map = sampled(mesh, normals, options.facets);
  s.map.options = options;
  s.adjacency = buildAdjacency(s.map.mesh.triangles);
  s.centre = boundingBox(s.map.mesh).centre();
  s.radius = radiusAbout(s.map.mesh, s.centre);
  const double eyeDistance = s.radius + options.eyeDistanceMm;
  // The sphere's outline on the plane through its middle.
  const double outline = s.radius * eyeDistance / std::sqrt(eyeDistance * eyeDistance - s.radius * s.radius);
  s.window.texels =
      std::clamp(static_cast<int>(std::ceil(2 * outline * kTexelsPerSquare / options.minMm)), kMinTexels, kMaxTexels);
  s.window.extentMm = 2 * outline * s.window.texels / (s.window.texels - 2 * kBorderTexels);
  s.views.assign(static_cast<std::size_t>(std::min(s.options.views, kViewsAtOnce)),
                 {ViewRaster(s.map.mesh, s.adjacency)});

  s.meanNormal = meanNormals(s.map.mesh);
  s.score.assign(s.meanNormal.size(), 0);
}

SizeMapSearch::~SizeMapSearch() = default;

bool SizeMapSearch::step() {
  State& s = *state_;
  assert(s.viewsDone < s.options.views);
  const auto left = static_cast<std::size_t>(s.options.views - s.viewsDone);
  const std::size_t count = std::min(s.views.size(), left);
  parallelFor(count, [&s](std::size_t i) {
    const int index = s.viewsDone + static_cast<int>(i);
    s.lookFrom(s.options.onlyFrom.value_or(latticeDirection(index, s.options.views)), s.views[i]);
  });
  for (std::size_t i = 0; i < count; ++i) s.add(s.views[i]);
  s.viewsDone += static_cast<int>(count);
  return s.viewsDone == s.options.views;
}

double SizeMapSearch::doneFraction() const { return static_cast<double>(state_->viewsDone) / state_->options.views; }

SizeMap SizeMapSearch::takeMap() { return std::move(state_->map); }

SizeMap makeSizeMap(const Mesh& mesh, std::span<const Vec3f> normals, const SizeMapOptions& options) {
  SizeMapSearch search(mesh, normals, options);
  while (!search.step()) {
  }
  return search.takeMap();
}

}  // namespace qrelief
