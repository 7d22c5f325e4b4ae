// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/inlay.h"

#include <utility>

namespace qrelief {

Mesh inlayMesh(const Arrangement& arrangement, const LiftedSurface& surface) {
  constexpr std::uint32_t kUnused = 0xffffffffu, kUsed = 0;
  Mesh inlay;
  const auto addTurned = [&](const Triangle& t) { inlay.triangles.push_back({t[0], t[2], t[1]}); };
  for (std::size_t t = 0; t < arrangement.triangles.size(); ++t) {
    if (arrangement.levels[t] == 0) continue;
    const Triangle& corners = arrangement.triangles[t];
    inlay.triangles.push_back(
        {surface.surfaceVertex[corners[0]], surface.surfaceVertex[corners[1]], surface.surfaceVertex[corners[2]]});
    addTurned(surface.triangles[t]);
  }
  for (std::size_t t = surface.firstWall; t < surface.triangles.size(); ++t) addTurned(surface.triangles[t]);

  std::vector<std::uint32_t> place(surface.vertices.size(), kUnused);
  for (const Triangle& t : inlay.triangles)
    for (const std::uint32_t v : t) place[v] = kUsed;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] == kUnused) continue;
    place[v] = static_cast<std::uint32_t>(inlay.positions.size());
    inlay.positions.push_back(surface.positions[v]);
  }
  for (Triangle& t : inlay.triangles)
    for (std::uint32_t& v : t) v = place[v];
  return inlay;
}

}  // namespace qrelief
