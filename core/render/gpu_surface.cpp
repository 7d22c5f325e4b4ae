// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu_surface.h"

namespace qrelief {

Result<std::vector<float>> GpuSurface::render(const ProjectionFrame& frame, const MapWindow& window) const {
  const auto drawn = maps(frame, window);
  QRELIEF_TRY(drawn);
  return drawn->framebuffer.readRgba(0);
}

Result<std::vector<float>> GpuSurface::renderBack(const ProjectionFrame& frame, const MapWindow& window) const {
  const auto drawn = backMap(frame, window);
  QRELIEF_TRY(drawn);
  return drawn->framebuffer.readRed();
}

}  // namespace qrelief
