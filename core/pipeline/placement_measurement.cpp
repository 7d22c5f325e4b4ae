// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/placement_measurement.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "depth/wall_limit.h"
#include "pipeline/engrave.h"

namespace qrelief {
namespace {

constexpr int kN = CellLayout::kN;
constexpr int kMaxMapTexels = 2048;
constexpr int kTexelsPerCell = 4;       // of the shaders' maps, unless they become too large
constexpr int kDrawnTexelsPerCell = 2;  // drawn by the CPU: enough for a cell's facets and thin spots behind it

/// Returns the means over blocks of texels.
HeightMap coarser(const HeightMap& fine, int texels) {
  const int size = fine.size / texels;
  const auto count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  HeightMap map{size,
                fine.patchMm * texels,
                fine.eyeDistance,
                std::vector<float>(count, HeightMap::kNothing),
                std::vector<float>(count, 0.0f),
                std::vector<float>(count, 0.0f)};
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      float height = 0, slopeX = 0, slopeY = 0, seen = 0;
      for (int k = 0; k < texels * texels; ++k) {
        const auto texel =
            static_cast<std::size_t>((row * texels + k / texels) * fine.size + column * texels + k % texels);
        if (!fine.isSurface(texel)) continue;
        height += fine.height[texel];
        slopeX += fine.slopeX[texel];
        slopeY += fine.slopeY[texel];
        seen += 1;
      }
      if (seen == 0) continue;
      const auto patch = static_cast<std::size_t>(row * size + column);
      map.height[patch] = height / seen;
      map.slopeX[patch] = slopeX / seen;
      map.slopeY[patch] = slopeY / seen;
    }
  return map;
}

}  // namespace

Result<std::shared_ptr<PlacementMeasurement>> PlacementMeasurement::create(
    std::shared_ptr<const EngravableModel> model, std::shared_ptr<const LuminancePrograms> programs,
    const Request& request) {
  auto place = std::make_shared<PlacementMeasurement>();
  place->request_ = request;
  place->model_ = std::move(model);
  if (!request.withLight || !place->model_->usesShaders(request.device))
    place->measureByProcessor();
  else
    QRELIEF_TRY(place->measureByShaders(std::move(programs)));
  return place;
}

MapWindow PlacementMeasurement::window(int texelsPerCell) const {
  const int cells = request_.layout.cells();
  return {request_.moduleMm * cells / kN, std::clamp(kMaxMapTexels / cells, 1, texelsPerCell) * cells};
}

PlacementLightOptions PlacementMeasurement::lightOptions() const {
  return {request_.layout.cells() / kN, request_.moduleMm, request_.albedo, request_.lights};
}

const SurfaceMaps* PlacementMeasurement::maps() const {
  if (!model_->gpu) return nullptr;
  if (!maps_) {
    auto drawn = model_->gpu->maps(request_.frame, window(kTexelsPerCell));
    if (!drawn) return nullptr;
    maps_ = std::move(*drawn);
  }
  return &*maps_;
}

Status PlacementMeasurement::measureByShaders(std::shared_ptr<const LuminancePrograms> programs) {
  const MapWindow map = window(kTexelsPerCell);
  const GpuSurface& surface = *model_->gpu;
  auto maps = surface.maps(request_.frame, map);
  QRELIEF_TRY(maps);
  maps_ = std::move(*maps);
  const auto around = surface.maps(request_.frame, surroundingsOf(map, request_.frame, model_->box));
  QRELIEF_TRY(around);
  auto light = lightByShaders(*maps_, *around, request_.frame.eyeDistance, lightOptions(), std::move(programs));
  QRELIEF_TRY(light);
  light_ = std::move(*light);
  const auto back = surface.renderBack(request_.frame, map);
  QRELIEF_TRY(back);
  const std::vector<float> smooth = maps_->framebuffer.readRgba(1);
  std::vector<float> front;
  for (std::size_t texel = 0; texel < smooth.size() / 4; ++texel) front.push_back(smooth[4 * texel + 3]);
  measureThickness(front, *back, map.texels / request_.layout.cells());
  return {};
}

void PlacementMeasurement::measureByProcessor() {
  const ProjectionFrame& frame = request_.frame;
  const SurfaceRaster& raster = *model_->raster;
  const auto heights = [&](const std::vector<float>& drawn, const MapWindow& seen) {
    return heightMapOf(drawn, seen.texels, seen.texelMm(), frame.eyeDistance);
  };
  const MapWindow map = window(kDrawnTexelsPerCell), around = surroundingsOf(map, frame, model_->box);
  const int texelsPerCell = map.texels / request_.layout.cells();
  std::vector<float> surface, back, surroundings;
  parallelFor(request_.withLight ? 3 : 2, [&](int k) {
    if (k == 0) surface = raster.draw(frame, map);
    if (k == 1) back = raster.drawBack(frame, map);
    if (k == 2) surroundings = raster.draw(frame, around);
  });
  measureThickness(rayDistances(surface, frame, map), back, texelsPerCell);
  if (!request_.withLight) return;
  std::optional<HeightMap> fine = heights(surface, map);
  const HeightMap cells = coarser(*fine, texelsPerCell);
  // A cell may lie across an edge of the model. A lamp then lights its facets differently from its mean plane.
  if (request_.lights.empty() || texelsPerCell != 2) fine.reset();
  light_ = lightByProcessor(cells, heights(surroundings, around), lightOptions(), fine);
}

void PlacementMeasurement::measureThickness(std::span<const float> front, std::span<const float> back,
                                            int texelsPerCell) {
  const int cells = request_.layout.cells(), texels = texelsPerCell * cells;
  const int edge = kN * request_.layout.modules;
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column) {
      const auto cell = static_cast<int>(request_.layout.ofSymbol(row, column));
      double least = std::numeric_limits<double>::infinity();
      for (int t = 0; t < texelsPerCell * texelsPerCell; ++t) {
        const int y = cell / cells * texelsPerCell + t / texelsPerCell;
        const int x = cell % cells * texelsPerCell + t % texelsPerCell;
        const auto texel = static_cast<std::size_t>(y * texels + x);
        if (front[texel] > 0 && back[texel] > 0)
          least = std::min(least, static_cast<double>(back[texel] - front[texel]));
      }
      thicknessMm_.push_back(least);
    }
}

std::vector<double> depthLimits(const Mesh& mesh, const Placement& placement, const SubmoduleMask& mask,
                                std::span<const double> thicknessMm, const DepthLimitOptions& options) {
  std::vector<double> limits = wallLimits(mesh, placement.patch, placement.frame, mask,
                                          {placement.symbolMm, options.maxDepthMm, options.minWallMm});
  for (std::size_t i = 0; i < limits.size(); ++i)
    limits[i] = std::max(0.0, std::min(limits[i], thicknessMm[i] - options.minWallMm));
  return limits;
}

}  // namespace qrelief
