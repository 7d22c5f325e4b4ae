// SPDX-License-Identifier: GPL-3.0-or-later
// Compares codes that are lit by shaders (on llvmpipe without a GPU) and by the processor, under one lamp and under two
// in turn: mean depth, deepest pocket, and the error of the light against path tracing.
//
//     qrelief_light_of_devices FOLDER CENTRES.json [CELLS] [PATHS]
//
//     CENTRES.json: see bench/centres.h
//
// Traces CELLS submodules of each engraved mesh, written to a file and read again, drawn at random from symbol and
// quiet zone.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <string>

#include "base/random.h"
#include "bench/centres.h"
#include "gl/objects.h"
#include "mesh/ray_tree.h"
#include "native/egl_context.h"
#include "study/path_tracer.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr int kMargin = kN * kQuietZoneModules;

/// One lamp or two, from another side and height for each case.
std::vector<DirectionalLight> lampsOf(int number) {
  const double turnDeg = 37 * number % 360;
  const DirectionalLight first{.azimuthDeg = turnDeg, .elevationDeg = 25.0 + 10 * (number % 4), .strength = 1};
  if (number % 2 == 0) return {first};
  return {first, {.azimuthDeg = turnDeg - 120, .elevationDeg = 35, .strength = 0.5}};
}

EngraveRequest requestFor(const bench::Centre& centre, int number) {
  EngraveRequest request;
  request.code.text = "https://example.com/qrelief";
  request.code.symbol.version = 3;
  request.placement.centreMm = centre.positionMm;
  request.placement.maxSizeMm = centre.widthWithQuietZoneMm.value_or(35) * 29 / 37;
  request.depth.lights = lampsOf(number);
  return request;
}

Result<EngraveResult> engraveBy(Device device, const std::shared_ptr<const EngravableModel>& model,
                                const EngraveRequest& request) {
  auto job = CarveJob::create(model, request, {.device = device});
  QRELIEF_TRY(job);
  return runToEnd(**job);
}

/// Difference between computed and path-traced luminance. Includes the noise of the traced values.
struct LightError {
  double mean = 0, absolute = 0;  ///< mean of the differences, and of their sizes
};

LightError lightError(const EngraveResult& engraved, int count, int paths) {
  const RayTree tree(engraved.mesh);
  const double edge = engraved.depths.submoduleMm();
  const auto rows = static_cast<std::uint64_t>(kN * engraved.symbol.size + 2 * kMargin);
  Random random(7);
  std::vector<study::SeenCell> cells;
  std::vector<double> ours;
  for (int k = 0; k < count; ++k) {
    const int row = static_cast<int>(random.below(rows)), column = static_cast<int>(random.below(rows));
    const Vec2 corner = engraved.depths.corner(row - kMargin, column - kMargin);
    cells.push_back({{corner.x, corner.y - edge}, {corner.x + edge, corner.y}});
    ours.push_back(engraved.luminance.at(row, column));
  }
  const auto traced = study::traceCells(
      tree, engraved.placement.frame, cells,
      {.paths = paths, .albedo = engraved.request.marking.surfaceAlbedo(), .lights = engraved.request.lamps()});
  LightError error;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double difference = ours[i] - traced[i].luminance.mean;
    error.mean += difference / count;
    error.absolute += std::abs(difference) / count;
  }
  return error;
}

/// Depths by shaders, in percent more than the processor's, and the errors of both kinds of light.
struct Comparison {
  double meanPercent = 0, deepestPercent = 0;
  LightError shaders, processor;
};

double percent(double value, double of) { return 100 * (value - of) / of; }

Comparison compare(const EngraveResult& shaders, const EngraveResult& processor, int cells, int paths) {
  const DepthSummary s = summarise(shaders.depths), p = summarise(processor.depths);
  return {percent(s.meanMm, p.meanMm), percent(s.maxMm, p.maxMm), lightError(shaders, cells, paths),
          lightError(processor, cells, paths)};
}

std::string inWords(const LightError& error) { return fmt::format("{:+.3f} ({:.3f})", error.mean, error.absolute); }

void printWorst(const std::vector<Comparison>& all) {
  Comparison worst;
  for (const Comparison& one : all) {
    worst.meanPercent = std::max(worst.meanPercent, std::abs(one.meanPercent));
    worst.deepestPercent = std::max(worst.deepestPercent, std::abs(one.deepestPercent));
    for (const auto error : {&Comparison::shaders, &Comparison::processor}) {
      (worst.*error).mean = std::max((worst.*error).mean, std::abs((one.*error).mean));
      (worst.*error).absolute = std::max((worst.*error).absolute, (one.*error).absolute);
    }
  }
  fmt::print("| worst of {} | | | {:.1f} % | | {:.1f} % | {} | {} |\n", all.size(), worst.meanPercent,
             worst.deepestPercent, inWords(worst.shaders), inWords(worst.processor));
}

int run(const std::string& folder, const std::string& centres, int cells, int paths) {
  const auto context = EglContext::create();
  if (!context) return bench::failed("EGL", context.error());
  fmt::print("Shaders on {}, compared with the processor; light of {} submodules, {} paths each\n\n",
             gl::rendererName(), cells, paths);
  fmt::print(
      "| code | lamps | mean depth | shaders | deepest | shaders | light, shaders: mean error (of sizes) | processor "
      "|\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|---:|\n");
  std::vector<Comparison> all;
  const auto visit = [&](const std::shared_ptr<const EngravableModel>& model, const bench::Centre& centre) -> Status {
    const EngraveRequest request = requestFor(centre, static_cast<int>(all.size()));
    const auto processor = engraveBy(Device::Processor, model, request);
    QRELIEF_TRY(processor);
    const auto shaders = engraveBy(Device::Gpu, model, request);
    QRELIEF_TRY(shaders);
    const Comparison one = all.emplace_back(compare(*shaders, *processor, cells, paths));
    const DepthSummary depth = summarise(processor->depths);
    fmt::print("| {} | {} | {:.3f} mm | {:+.1f} % | {:.2f} mm | {:+.1f} % | {} | {} |\n", centre.name,
               request.depth.lights.size(), depth.meanMm, one.meanPercent, depth.maxMm, one.deepestPercent,
               inWords(one.shaders), inWords(one.processor));
    std::fflush(stdout);
    return {};
  };
  const int status = bench::forEachCentre(folder, centres, {"flat", "curved", "edge"}, visit);
  printWorst(all);
  return status;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: {} FOLDER CENTRES.json [CELLS] [PATHS]\n", argv[0]);
    return 2;
  }
  return qrelief::run(argv[1], argv[2], argc > 3 ? std::atoi(argv[3]) : 200, argc > 4 ? std::atoi(argv[4]) : 1024);
}
