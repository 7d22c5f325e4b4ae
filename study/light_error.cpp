// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/light_error.h"

#include <cmath>

#include "study/carved_surface.h"
#include "study/path_tracer.h"

namespace qrelief::study {
namespace {

constexpr int kPaths = 64;

}  // namespace

Result<std::vector<double>> tracedLuminance(const StudyPlacement& spot, const CarvedCode& code) {
  const auto surface = CarvedSurface::make(spot, code.depths);
  QRELIEF_TRY(surface);
  std::vector<SeenCell> cells;
  for (const std::uint32_t i : carvedOf(code.mask)) {
    const Vec2 corner =
        code.depths.corner(static_cast<int>(i) / code.mask.rows(), static_cast<int>(i) % code.mask.rows());
    const double h = code.depths.submoduleMm();
    cells.push_back({{corner.x, corner.y - h}, {corner.x + h, corner.y}});
  }
  PathTraceOptions options{.paths = kPaths, .albedo = spot.request.marking.surfaceAlbedo(), .seed = 1};
  if (code.readUnder) options.lights = {*code.readUnder};
  std::vector<double> luminance;
  for (const CellLight& cell : traceCells(surface->tree(), spot.placement.frame, cells, options))
    luminance.push_back(cell.luminance.mean);
  return luminance;
}

LightError lightErrorOf(std::span<const double> own, std::span<const double> traced) {
  LightError error;
  for (std::size_t k = 0; k < traced.size(); ++k) {
    error.mean += (own[k] - traced[k]) / static_cast<double>(traced.size());
    error.meanSize += std::abs(own[k] - traced[k]) / static_cast<double>(traced.size());
  }
  return error;
}

}  // namespace qrelief::study
