// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/spot_light.h"

#include <algorithm>
#include <cassert>

#include "verification/mesh_luminance.h"

namespace qrelief {
namespace {

constexpr int kPixels = 3;      // along a module's edge
constexpr int kNeighbours = 4;  // radius of the neighbourhood, in modules
constexpr double kPercentile = 0.98;

}  // namespace

double unevenLight(const SurfaceRaster& raster, const Box3& box, const ProjectionFrame& frame, double symbolMm,
                   int modules, std::span<const DirectionalLight> lamps, int ring) {
  assert(modules > 0 && ring >= 0);
  const int edge = modules + 2 * (ring + kNeighbours), pixels = kPixels * edge;
  const BottomUp<float> picture = meshLuminance(raster, box, frame,
                                                {.pixels = pixels,
                                                 .pixelMm = symbolMm / modules / kPixels,
                                                 .nearMm = symbolMm,
                                                 .lamps = {lamps.begin(), lamps.end()}});
  BottomUp<float> means(edge, edge);
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) means.at(y / kPixels, x / kPixels) += picture.at(y, x) / (kPixels * kPixels);
  std::vector<float> darker;
  for (int row = kNeighbours; row < edge - kNeighbours; ++row)
    for (int column = kNeighbours; column < edge - kNeighbours; ++column) {
      float brightest = 0;
      for (int r = row - kNeighbours; r <= row + kNeighbours; ++r)
        for (int c = column - kNeighbours; c <= column + kNeighbours; ++c)
          brightest = std::max(brightest, means.at(r, c));
      darker.push_back(1 - means.at(row, column) / brightest);
    }
  const auto at = darker.begin() + static_cast<std::ptrdiff_t>(kPercentile * static_cast<double>(darker.size() - 1));
  std::nth_element(darker.begin(), at, darker.end());
  return static_cast<double>(*at);
}

std::optional<DirectionalLight> evenLamp(const SurfaceRaster& raster, const Box3& box, const ProjectionFrame& frame,
                                         double symbolMm, int modules, const DirectionalLight& lamp, int ring) {
  std::optional<DirectionalLight> even;
  double least = kMostUnevenLight;
  for (const double elevationDeg : {lamp.elevationDeg, 45.0, 60.0})
    for (double azimuthDeg = 0; azimuthDeg < 360; azimuthDeg += 45) {
      const DirectionalLight there{azimuthDeg, elevationDeg, lamp.strength};
      const double uneven = unevenLight(raster, box, frame, symbolMm, modules, std::span(&there, 1), ring);
      if (uneven > least) continue;
      least = uneven;
      even = there;
    }
  return even;
}

}  // namespace qrelief
