// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/job_map.h"

namespace qrelief {

std::optional<JobMap> jobMap(const EngraveJob& job, std::string_view name) {
  const InspectorMaps maps = job.inspectorMaps();
  const gl::Texture* source = nullptr;
  const SurfaceMaps* const surface = name == "surface" ? job.surfaceMaps() : nullptr;
  if (surface) source = &surface->surface;
  if (name == "luminance") source = maps.luminance;
  if (name == "depths") source = maps.depths;
  if (!source) return std::nullopt;
  const gl::Texture* const colours[] = {source};
  const auto framebuffer = gl::Framebuffer::create(colours, false);
  if (!framebuffer) return std::nullopt;
  const bool isSurface = name == "surface";
  return JobMap{source->width(), source->height(), isSurface ? 4 : 1,
                isSurface ? framebuffer->readRgba() : framebuffer->readRed()};
}

}  // namespace qrelief
