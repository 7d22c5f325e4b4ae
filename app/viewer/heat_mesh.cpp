// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/heat_mesh.h"

#include <algorithm>
#include <cmath>

#include "viewer/display_mesh.h"

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

}  // namespace

GpuMesh heatMesh(const Mesh& model, const SizeMap& map, double leastMm, double topMm) {
  const Mesh& surface = map.isCoarser ? model : map.mesh;
  std::vector<float> values(surface.positions.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    const float sizeMm = map.sizeMm[map.isCoarser ? map.vertexOf[v] : v];
    values[v] = static_cast<double>(sizeMm) < leastMm ? 0 : sizeMm / static_cast<float>(topMm);
  }
  // A round carries values over one edge of the shown mesh; this many of its edges make up one edge of the map.
  const double edges = std::sqrt(static_cast<double>(values.size()) / static_cast<double>(map.sizeMm.size()));
  smooth(surface, values, std::min(kMostRounds, 1 + static_cast<int>(std::ceil(edges))));

  // Smoothing lowers the peaks: the largest size has the last colour all the same.
  const float peak = *std::max_element(values.begin(), values.end());
  const float top = *std::max_element(map.sizeMm.begin(), map.sizeMm.end()) / static_cast<float>(topMm);
  if (peak > 0)
    for (float& value : values) value *= top / peak;

  const DisplayMesh display = splitAtCreases(surface);
  std::vector<float> displayed(display.mesh.positions.size(), 0.0f);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) displayed[display.mesh.triangles[t][k]] = values[surface.triangles[t][k]];
  GpuMesh mesh(display.mesh, display.normals);
  mesh.setValues(displayed);
  return mesh;
}

}  // namespace qrelief
