// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/job_map.h"

#include "depth/depth_solver.h"
#include "pipeline/engrave.h"
#include "qr/module_pattern.h"
#include "render/geometry_pass.h"

namespace qrelief {
namespace {

JobMap mapOf(const Grid<float>& grid) { return {grid.columns(), grid.rows(), 1, bottomUp(grid).values()}; }

/// @param name  "search-luminance" or "search-depths"
std::optional<JobMap> searchMap(const SearchRecord& search, int modules, std::string_view name) {
  if (search.passes.empty()) return std::nullopt;
  if (name == "search-luminance") return mapOf(search.luminance);
  const int edge = kSubmodulesPerModule * modules;
  Grid<float> depths(edge, edge);
  for (std::size_t k = 0; k < search.carved.size(); ++k) depths[search.carved[k]] = search.passes.back().depthMm[k];
  return mapOf(depths);
}

}  // namespace

std::optional<JobMap> jobMap(const CarveJob& job, std::string_view name) {
  const InspectorMaps maps = job.inspectorMaps();
  if (name.starts_with("search-"))
    return maps.search && maps.symbol ? searchMap(*maps.search, maps.symbol->size, name) : std::nullopt;
  const gl::Texture* source = nullptr;
  const SurfaceMaps* const surface = name == "surface" ? job.surfaceMaps() : nullptr;
  if (surface) source = &surface->surface;
  if (name == "luminance" && maps.light) source = &maps.light->luminanceTexture();
  if (name == "depths" && maps.light) source = &maps.light->depthTexture();
  if (!source) return std::nullopt;
  const gl::Texture* const colours[] = {source};
  const auto framebuffer = gl::Framebuffer::create(colours, false);
  if (!framebuffer) return std::nullopt;
  const bool isSurface = name == "surface";
  return JobMap{source->width(), source->height(), isSurface ? 4 : 1,
                isSurface ? framebuffer->readRgba() : framebuffer->readRed()};
}

}  // namespace qrelief
