// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/path_tracer.h"

#include <array>
#include <cassert>
#include <cmath>

#include "base/halton.h"
#include "base/parallel.h"
#include "base/random.h"
#include "verification/light_path.h"

namespace qrelief::study {
namespace {

constexpr int kEstimates = 8;

struct Sums {
  double sky = 0, direct = 0, irradiance = 0;
};

/// Averages over one set of Halton points with one random shift.
Sums estimate(const RaySurface& surface, const ProjectionFrame& frame, const SeenCell& cell,
              std::span<const Lamp> lamps, double open, int paths, double albedo, Random& random) {
  const std::array<double, 4> shift{random.uniform(), random.uniform(), random.uniform(), random.uniform()};
  Sums sums;
  for (int i = 1; i <= paths; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const std::array<double, 2> place = halton23(index);
    const Vec2 at = cell.min + (cell.max - cell.min) * Vec2(wrapped(place[0] + shift[0]), wrapped(place[1] + shift[1]));
    const Vec3 ray = frame.rayDirection(at);
    const auto hit = surface.firstHit(frame.eye(), ray);
    LightPath path{true, 1, open - 1, open - 1};
    if (hit)
      path = traceLight(surface, *hit, ray,
                        {wrapped(radicalInverse(index, 5) + shift[2]), wrapped(radicalInverse(index, 7) + shift[3])},
                        albedo, lamps, random);
    sums.sky += path.seesSky;
    sums.direct += path.lampDirect;
    sums.irradiance += path.sky + path.lamp;
  }
  return {sums.sky / paths, sums.direct / paths, sums.irradiance / paths};
}

Traced summarised(const std::array<double, kEstimates>& values) {
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / kEstimates;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / (kEstimates * (kEstimates - 1)))};
}

CellLight traceCell(const RaySurface& surface, const ProjectionFrame& frame, const SeenCell& cell,
                    std::span<const Lamp> lamps, double open, const PathTraceOptions& options, std::uint64_t seed) {
  Random random(seed);
  std::array<double, kEstimates> sky{}, direct{}, luminance{};
  for (std::size_t k = 0; k < kEstimates; ++k) {
    const Sums sums = estimate(surface, frame, cell, lamps, open, options.paths / kEstimates, options.albedo, random);
    sky[k] = sums.sky;
    direct[k] = sums.direct;
    luminance[k] = sums.irradiance / open;
  }
  return {summarised(sky), summarised(direct), summarised(luminance)};
}

}  // namespace

std::vector<CellLight> traceCells(const RaySurface& surface, const ProjectionFrame& frame,
                                  std::span<const SeenCell> cells, const PathTraceOptions& options) {
  assert(options.paths >= kEstimates);
  std::vector<Lamp> lamps;
  for (const DirectionalLight& light : options.lights) lamps.push_back(lampOf(light, frame, 0));
  std::vector<std::uint64_t> seeds(cells.size());
  Random random(options.seed);
  for (std::uint64_t& seed : seeds) seed = random.next();
  std::vector<CellLight> light(cells.size());
  const double open = openIrradiance(options.lights);
  parallelFor(cells.size(),
              [&](std::size_t i) { light[i] = traceCell(surface, frame, cells[i], lamps, open, options, seeds[i]); });
  return light;
}

}  // namespace qrelief::study
