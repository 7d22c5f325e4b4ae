// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/heat_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "viewer/display_mesh.h"
#include "viewer/two_values.h"

namespace qrelief {
namespace {

constexpr int kMostRounds = 12;

/// Replaces each vertex's value by the mean over the vertex and its neighbours.
void smooth(const Mesh& mesh, std::vector<float>& values, int rounds) {
  std::vector<float> sum(values.size()), count(values.size());
  for (int round = 0; round < rounds; ++round) {
    sum = values;
    std::fill(count.begin(), count.end(), 1.0f);
    for (const Triangle& t : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        sum[t[k]] += values[t[(k + 1) % 3]] + values[t[(k + 2) % 3]];
        count[t[k]] += 2;
      }
    }
    for (std::size_t v = 0; v < values.size(); ++v) values[v] = sum[v] / count[v];
  }
}

const Mesh& surfaceOf(const Mesh& model, const SizeMap& map) { return map.isCoarser ? model : map.mesh; }

/// Returns the smoothed sizes of the shown surface, mm.
/// @param leastMm  smaller sizes are 0
std::vector<float> smoothedSizes(const Mesh& model, const SizeMap& map, double leastMm) {
  const Mesh& surface = surfaceOf(model, map);
  std::vector<float> sizesMm(surface.positions.size());
  for (std::size_t v = 0; v < sizesMm.size(); ++v) {
    const float sizeMm = map.sizeMm[map.isCoarser ? map.vertexOf[v] : v];
    sizesMm[v] = static_cast<double>(sizeMm) < leastMm ? 0 : sizeMm;
  }
  // A round carries sizes over one edge of the shown mesh; this many of its edges make up one edge of the map.
  const double edges = std::sqrt(static_cast<double>(sizesMm.size()) / static_cast<double>(map.sizeMm.size()));
  smooth(surface, sizesMm, std::min(kMostRounds, 1 + static_cast<int>(std::ceil(edges))));

  // Smoothing lowers the peaks: the largest size stays the largest all the same.
  const float peak = *std::max_element(sizesMm.begin(), sizesMm.end());
  const float top = *std::max_element(map.sizeMm.begin(), map.sizeMm.end());
  if (peak > 0)
    for (float& sizeMm : sizesMm) sizeMm *= top / peak;
  return sizesMm;
}

/// Returns the values of the surface's vertices for the vertices of its display mesh.
std::vector<float> displayed(const DisplayMesh& display, const Mesh& surface, std::span<const float> values) {
  std::vector<float> own(display.mesh.positions.size(), 0.0f);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) own[display.mesh.triangles[t][k]] = values[surface.triangles[t][k]];
  return own;
}

}  // namespace

GpuMesh heatMesh(const Mesh& model, const SizeMap& map, double leastMm, double topMm) {
  const Mesh& surface = surfaceOf(model, map);
  std::vector<float> values = smoothedSizes(model, map, leastMm);
  for (float& value : values) value /= static_cast<float>(topMm);
  const DisplayMesh display = splitAtCreases(surface);
  GpuMesh mesh(display.mesh, display.normals);
  mesh.setValues(displayed(display, surface, values));
  return mesh;
}

GpuMesh fitMesh(const Mesh& model, const SizeMap& map, double sizeMm) {
  const Mesh& surface = surfaceOf(model, map);
  DisplayMesh display = splitAtCreases(surface);
  const std::vector<float> sizesMm = displayed(display, surface, smoothedSizes(model, map, 0));
  const TwoValues two = twoValues(std::move(display), sizesMm, static_cast<float>(sizeMm));
  GpuMesh mesh(two.display.mesh, two.display.normals);
  mesh.setValues(two.values);
  return mesh;
}

}  // namespace qrelief
