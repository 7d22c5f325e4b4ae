// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/mesh_luminance.h"

#include <algorithm>
#include <memory>
#include <numbers>

#include "light/height_light.h"
#include "verification/baked_light.h"

namespace qrelief {
namespace {

constexpr LightSampling kSampling{2, 8};  // height steps between submodules can be as small as a pixel's width
constexpr double kEveryPixel = 12;        // in pixels: nearer than this, a horizon looks at every pixel
constexpr int kPixelsPerPlace = 10;       // spacing of the far horizon's places

HeightMap drawn(const SurfaceRaster& raster, const ProjectionFrame& frame, const MapWindow& window) {
  return heightMapOf(raster.draw(frame, window), window.texels, window.texelMm(), frame.eyeDistance);
}

}  // namespace

BottomUp<float> meshLuminance(const Mesh& mesh, const ProjectionFrame& frame, const MeshLuminanceOptions& options) {
  Box3 box;
  for (const Vec3f& position : mesh.positions) box.add(Vec3(position));
  return meshLuminance(SurfaceRaster(mesh, std::make_shared<const ClusteredTriangles>(oneCluster(mesh))), box, frame,
                       options);
}

BottomUp<float> meshLuminance(const SurfaceRaster& raster, const Box3& box, const ProjectionFrame& frame,
                              const MeshLuminanceOptions& options) {
  const MapWindow window{options.pixelMm * options.pixels, options.pixels};
  const HeightMap map = drawn(raster, frame, window);
  const HeightMap around = drawn(raster, frame, surroundingsOf(window, frame, box));
  const HeightLight surface(map,
                            farHorizonOf(map, &around, options.nearMm, std::max(1, options.pixels / kPixelsPerPlace)));
  const LightOptions light{.sampling = kSampling,
                           .reachMm = window.extentMm * std::numbers::sqrt2,
                           .everyPatchMm = kEveryPixel * options.pixelMm,
                           .lamps = options.lamps,
                           .lampRadiusDeg = options.lampRadiusDeg};
  std::vector<Received> received;
  surface.measure(light, {}, received);
  std::vector<float> luminance = surface.luminance(light, received, options.albedo);
  for (std::size_t pixel = 0; pixel < luminance.size(); ++pixel)
    if (!map.isSurface(pixel)) luminance[pixel] = kBackground;
  return {options.pixels, options.pixels, std::move(luminance)};
}

}  // namespace qrelief
