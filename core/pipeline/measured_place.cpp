// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/measured_place.h"

#include <algorithm>
#include <limits>

namespace qrelief {
namespace {

constexpr int kN = CellLayout::kN;
constexpr int kMaxMapTexels = 2048;
constexpr int kHorizonsPerModule = 2;
constexpr double kFirstReachModules = 3;
constexpr LuminanceSampling kUncarvedSampling{1, 4};  // smooth, but for the model's own edges

}  // namespace

Result<std::shared_ptr<MeasuredPlace>> MeasuredPlace::create(const GpuMesh& model, const GeometryPass& pass,
                                                             std::shared_ptr<const LuminancePrograms> programs,
                                                             const Request& request) {
  auto place = std::make_shared<MeasuredPlace>();
  place->request_ = request;
  const int cells = request.layout.cells();
  const MapWindow window{request.moduleMm * cells / kN, std::clamp(kMaxMapTexels / cells, 1, 4) * cells};
  auto maps = pass.render(model, request.frame, window);
  if (!maps) return tl::unexpected(maps.error());
  place->maps_ = std::move(*maps);
  const auto around = pass.render(model, request.frame, surroundingsOf(window, request.frame, model.box()));
  if (!around) return tl::unexpected(around.error());
  if (const Status lit = place->measureLight(*around, std::move(programs)); !lit) return tl::unexpected(lit.error());
  const auto back = pass.renderBack(model, request.frame, window);
  if (!back) return tl::unexpected(back.error());
  place->measureThickness(*back);
  return place;
}

/// The surroundings are lit once: pockets lie below the light modules and take no sky from them.
Status MeasuredPlace::measureLight(const SurfaceMaps& around, std::shared_ptr<const LuminancePrograms> programs) {
  LuminanceOptions options;
  options.cellTexels = maps_.window.texels / request_.layout.cells();
  options.albedo = request_.albedo;
  options.lights = request_.lights;
  options.horizonSamples = kHorizonsPerModule * request_.layout.cells() / kN;
  options.horizonStartMm = static_cast<float>(request_.moduleMm);
  options.radiusMm = static_cast<float>(kFirstReachModules * request_.moduleMm);
  auto made = LuminancePass::create(maps_, &around, request_.frame.eyeDistance, options, std::move(programs));
  if (!made) return tl::unexpected(made.error());
  light_.emplace(std::move(*made));
  light_->setSampling(kUncarvedSampling);
  light_->setRadius(options.horizonStartMm);  // what lies farther is in the horizon
  light_->run();
  light_->setSampling({});
  uncarved_ = light_->readReceived();
  return {};
}

void MeasuredPlace::measureThickness(const BackDistanceMap& back) {
  const std::vector<float> behind = back.framebuffer.readRed();
  const std::vector<float> ahead = maps_.framebuffer.readRgba(1);
  const int texels = maps_.window.texels, cells = request_.layout.cells(), perCell = texels / cells;
  const int edge = kN * request_.layout.modules;
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column) {
      const auto cell = static_cast<int>(request_.layout.ofSymbol(row, column));
      double least = std::numeric_limits<double>::infinity();
      for (int t = 0; t < perCell * perCell; ++t) {
        const int y = cell / cells * perCell + t / perCell, x = cell % cells * perCell + t % perCell;
        const auto texel = static_cast<std::size_t>(y * texels + x);
        const float front = ahead[4 * texel + 3];
        if (front > 0 && behind[texel] > 0) least = std::min<double>(least, behind[texel] - front);
      }
      thicknessMm_.push_back(least);
    }
}

void MeasuredPlace::uncarve() { light_->setReceived(uncarved_); }

}  // namespace qrelief
