// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/map_channels.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"

namespace qrelief {
namespace {

/// Returns the angle, accurate for small angles, too; the arc cosine is not.
float angleDeg(const float* normal) {
  return std::atan2(std::hypot(normal[0], normal[1]), normal[2]) * static_cast<float>(toDegrees(1));
}

}  // namespace

ValueMap surfaceMap(const SurfaceMaps& maps, const BackDistanceMap* back, double edgeMm, MapChannel channel) {
  const int texels = maps.window.texels;
  const int edge = std::min(texels, static_cast<int>(std::lround(edgeMm / maps.window.texelMm())));
  const int margin = (texels - edge) / 2;
  const bool isNormal = channel == MapChannel::FacetNormal || channel == MapChannel::SmoothNormal;
  const bool isOfFacets = channel == MapChannel::FacetNormal || channel == MapChannel::Height;
  const std::vector<float> front = maps.framebuffer.readRgba(isOfFacets ? 0 : 1);
  const bool needsBack = channel == MapChannel::BackDistance || channel == MapChannel::Thickness;
  const std::vector<float> behind = needsBack ? back->framebuffer.readRed() : std::vector<float>();

  ValueMap map{edge, edge, {}, {}};
  for (int row = 0; row < edge; ++row) {
    for (int column = 0; column < edge; ++column) {
      const auto texel = static_cast<std::size_t>((texels - 1 - margin - row) * texels + margin + column);
      const float* const at = &front[4 * texel];
      const bool isSurface = at[0] * at[0] + at[1] * at[1] + at[2] * at[2] > 0.25f;
      const float behindHere = needsBack ? behind[texel] : 0;
      float value = ValueMap::kNothing;
      if (isSurface && isNormal)
        value = angleDeg(at);
      else if (isSurface && !needsBack)
        value = at[3];
      else if (isSurface && behindHere > 0)
        value = channel == MapChannel::Thickness ? behindHere - at[3] : behindHere;
      map.values.push_back(value);
      if (isNormal) map.directions.emplace_back(at[0], at[1], at[2]);
    }
  }
  return map;
}

ValueMap lightMap(const Grid<Received>& received, MapChannel channel) {
  ValueMap map{received.columns(), received.rows(), {}, {}};
  for (const Received& light : received)
    map.values.push_back(channel == MapChannel::Sky         ? light.sky
                         : channel == MapChannel::PastWalls ? light.pastWalls
                                                            : light.lamps);
  return map;
}

}  // namespace qrelief
