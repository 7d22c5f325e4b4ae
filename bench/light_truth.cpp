// SPDX-License-Identifier: GPL-3.0-or-later
// Compares light on height maps (light/height_light.h) with path tracing: mean luminance of every module of a carved
// code, as designed and as printed.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/clock.h"
#include "bench/engraved_file.h"
#include "light/height_light.h"
#include "mesh/ray_tree.h"
#include "render/surface_raster.h"
#include "study/path_tracer.h"
#include "study/printed_rays.h"
#include "verification/reading_sweep.h"
#include "verification/resample.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;
using bench::loadEngraved, bench::moduleMeans, bench::vectorOf;

constexpr int kPaths = 1024;
constexpr double kAlbedo = 0.7;

struct Code {
  ProjectionFrame frame;
  int modules = 0;
  double symbolMm = 0;
};

void compare(const char* name, const Code& code, const HeightMap& map, const RaySurface& surface) {
  const auto start = Clock::now();
  std::vector<Received> received;
  // As in verification/mesh_luminance.cpp and pipeline/printed_view.cpp.
  const LightOptions options{.sampling = map.isContinuous ? LightSampling{1, 12} : LightSampling{2, 8},
                             .reachMm = map.size * map.patchMm * std::numbers::sqrt2,
                             .everyPatchMm = (map.isContinuous ? 20 : 12) * map.patchMm};
  const HeightLight light(map);
  light.measure(options, {}, received);
  const double skyMs = millisecondsSince(start);
  const std::vector<float> luminance = light.luminance(options, received, kAlbedo);
  const PictureGrid grid{code.symbolMm / code.modules / kBakedPixels,
                         kBakedPixels * (code.modules + 2 * kPictureMarginModules)};
  const std::vector<double> ours = moduleMeans(litPicture(map, luminance, grid, 1), code.modules);
  const double ms = millisecondsSince(start);
  std::vector<float> visible;
  for (const Received& r : received) visible.push_back(r.sky);
  const std::vector<double> sky = moduleMeans(litPicture(map, visible, grid, 1), code.modules);
  std::vector<study::SeenCell> cells;
  const double module = code.symbolMm / code.modules;
  for (int row = 0; row < code.modules; ++row)
    for (int column = 0; column < code.modules; ++column) {
      const Vec2 low((column - code.modules / 2.0) * module, (code.modules / 2.0 - row - 1) * module);
      cells.push_back({low, low + module});
    }
  const auto traced = study::traceCells(surface, code.frame, cells, {.paths = kPaths, .albedo = kAlbedo});
  std::vector<double> apart;
  double sum = 0, biased = 0, skySum = 0, noise = 0, skyBias = 0;
  for (std::size_t i = 0; i < traced.size(); ++i) {
    apart.push_back(std::abs(ours[i] - traced[i].luminance.mean));
    sum += apart.back();
    biased += ours[i] - traced[i].luminance.mean;
    skySum += std::abs(sky[i] - traced[i].visibility.mean);
    skyBias += sky[i] - traced[i].visibility.mean;
    noise += traced[i].luminance.standardError;
  }
  std::sort(apart.begin(), apart.end());
  const auto n = static_cast<double>(apart.size());
  fmt::print(
      "{:9} modules' luminance apart: mean {:.4f} (signed {:+.4f}), 99 % {:.4f}, worst {:.4f}; sky {:.4f} ({:+.4f}); "
      "noise of the traced {:.4f}; {:.0f} + {:.0f} ms\n",
      name, sum / n, biased / n, apart[static_cast<std::size_t>(0.99 * (n - 1))], apart.back(), skySum / n, skyBias / n,
      noise / n, skyMs, ms - skyMs);
}

int run(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "usage: {} REPORT.json MESH design|up|side|slant...\n", argv[0]);
    return 2;
  }
  const Json report = Json::parse(std::ifstream(argv[1]), nullptr, false);
  const auto mesh = loadEngraved(argv[2]);
  if (!report.is_object() || !mesh) {
    fmt::print(stderr, "{} or {} cannot be read\n", argv[1], argv[2]);
    return 1;
  }
  const Json& placed = report["projection"];
  const Code code{makeFrame(vectorOf(placed["centre"]), vectorOf(placed["normal"]), vectorOf(placed["up"]),
                            placed["eyeDistanceMm"].get<double>()),
                  report["symbol"]["modules"].get<int>(), report["size"]["symbolMm"].get<double>()};
  const double extentMm = code.symbolMm * (code.modules + 2 * kPictureMarginModules) / code.modules;
  for (int k = 3; k < argc; ++k) {
    const std::string facing = argv[k];
    if (facing == "design") {
      const int texels = kBakedPixels * (code.modules + 2 * kPictureMarginModules);
      const MapWindow window{extentMm, texels};
      const HeightMap map =
          heightMapOf(SurfaceRaster(*mesh).draw(code.frame, window), texels, window.texelMm(), code.frame.eyeDistance);
      compare("designed", code, map, RayTree(*mesh));
      continue;
    }
    PrintRequest request;
    request.frame = code.frame;
    request.extentMm = extentMm;
    const ProjectionFrame& frame = code.frame;
    request.buildUp = facing == "up" ? frame.normal : facing == "side" ? frame.up : frame.normal + frame.up;
    request.process = *processOf({});
    const auto printed = printSurface(*mesh, request);
    if (!printed) return 1;
    compare(facing.c_str(), code, printed->heightMap(), study::PrintedRays(*printed));
  }
  return 0;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::run(argc, argv); }
