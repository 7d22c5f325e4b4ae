// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the depth search with the schemes of earlier work, in one run, with the same goal: no carved submodule
// brighter than (1 − c) of its surroundings.
//
//     qrelief_search_bench                                            a bumpy sphere of 82k triangles, 35 mm
//     qrelief_search_bench MODEL SCALE X,Y,Z [SIZE [RAYS]]            a model of your own, centre in file units
//
// map           depths on a map that is drawn once: ours, with both solvers
// redraw        the same rule and steps as paper-steps, but every iteration carves the mesh, uploads and redraws it
//               [Papp 2022, §7]
// ray tracing   every iteration carves the mesh and traces RAYS paths from each dark submodule (their code: 50,000, in
//               previews 5,000); a submodule that is too bright gets a layer deeper [in the manner of Peng 2019]. RAYS
//               is 50 by default; the table has the standard error of a submodule's luminance. For the error of maps,
//               see script/bench light
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <iterator>

#include "base/clock.h"
#include "carving/embed.h"
#include "depth/light_neighbours.h"
#include "depth/paper_step_search.h"
#include "depth/wall_limit.h"
#include "io/read_model.h"
#include "io/write_stl.h"
#include "mesh/ray_tree.h"
#include "messages/sentences.h"
#include "native/egl_context.h"
#include "pipeline/engrave.h"
#include "render/luminance_pass.h"
#include "study/path_tracer.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr double kLayerMm = 0.1;

struct Row {
  std::string name;
  int iterations = 0;
  double meanMm = 0, milliseconds = 0;
};

/// A placed code and the limits of its depths.
struct Spot {
  std::shared_ptr<const EngravableModel> model;
  EngraveRequest request;
  Placement placement;
  Symbol symbol;
  SubmoduleMask mask;
  std::vector<double> limitMm;

  CarvingTarget target() const { return {&symbol, &mask, placement.symbolMm, limitMm}; }
  int edge() const { return kN * (symbol.size + 2 * kQuietZoneModules); }
};

Result<Mesh> carved(const Spot& spot, const DepthField& depths) {
  auto embedded =
      embedDepthField(spot.model->prepared.mesh, spot.placement.frame, spot.placement.patch.triangles, depths, {});
  QRELIEF_TRY(embedded);
  return std::move(embedded->mesh);
}

Result<Row> runOnMap(const Spot& spot, ContrastSolver solver, const char* name) {
  EngraveRequest request = spot.request;
  request.depth.solver = solver;
  const auto result = engrave(spot.model, request);
  QRELIEF_TRY(result);
  return Row{name, result->searchIterations, summarise(result->depths).meanMm, result->timingsMs.depthSearch};
}

/// Searches as in the paper: carve, redraw, light, compare.
Result<Row> runRedrawing(const Spot& spot) {
  const auto pass = GeometryPass::create();
  QRELIEF_TRY(pass);
  const int cells = spot.edge() + 2 * kN * kOcclusionMarginModules, cellTexels = 4,
            border = kN * kOcclusionMarginModules;
  const MapWindow window{spot.placement.moduleMm * cells / kN, cellTexels * cells};
  DepthSearchOptions options;
  options.contrast = spot.request.depth.contrastAsked();
  const auto start = Clock::now();
  PaperStepSearch search(spot.target(), options);
  while (!search.finished()) {
    const auto mesh = carved(spot, search.depths());
    QRELIEF_TRY(mesh);
    const GpuMesh gpu(*mesh, vertexNormals(*mesh));
    const auto maps = pass->render(gpu, spot.placement.frame, window);
    QRELIEF_TRY(maps);
    LuminanceOptions light;
    light.cellTexels = cellTexels;
    light.sampling = {4, 2};
    light.albedo = static_cast<float>(spot.request.marking.surfaceAlbedo());
    light.radiusMm = static_cast<float>(3 * spot.placement.moduleMm);
    light.reliefMm = static_cast<float>(summarise(search.depths()).maxMm);
    light.horizonSamples = 1;
    light.horizonStartMm = light.radiusMm;
    auto lightPass = LuminancePass::create(*maps, nullptr, spot.placement.frame.eyeDistance, light);
    QRELIEF_TRY(lightPass);
    lightPass->run();
    const std::vector<float> means = lightPass->readLuminance();
    Grid<double> luminance(spot.edge(), spot.edge());
    for (int row = 0; row < spot.edge(); ++row)
      for (int column = 0; column < spot.edge(); ++column)
        luminance.at(row, column) = means[(cells - 1 - row - border) * cells + column + border];
    search.update(luminance);
  }
  return Row{"redraw", search.iterations(), summarise(search.depths()).meanMm, millisecondsSince(start)};
}

/// Searches as in Peng 2019: rays from every dark submodule, one layer deeper where it is too bright.
Result<Row> runTracing(const Spot& spot, int rays) {
  const auto start = Clock::now();
  DepthField depths{spot.mask.rows(), spot.placement.symbolMm, std::vector<double>(spot.mask.size(), 0)};
  std::vector<std::uint32_t> dark;
  std::vector<study::SeenCell> cells;
  for (std::uint32_t i = 0; i < spot.mask.size(); ++i) {
    if (!spot.mask[i]) continue;
    dark.push_back(i);
    depths.depthMm[i] = quantisedDepth(kLayerMm, spot.limitMm[i]);
    const Vec2 corner = depths.corner(static_cast<int>(i) / spot.mask.rows(), static_cast<int>(i) % spot.mask.rows());
    const double h = depths.submoduleMm();
    cells.push_back({{corner.x, corner.y - h}, {corner.x + h, corner.y}});
  }
  int iterations = 0;
  double noise = 0;
  for (bool deepened = true; deepened; ++iterations) {
    const auto mesh = carved(spot, depths);
    QRELIEF_TRY(mesh);
    const RayTree tree(*mesh);
    const auto light = study::traceCells(tree, spot.placement.frame, cells,
                                         {.paths = rays, .albedo = spot.request.marking.surfaceAlbedo()});
    deepened = false;
    noise = 0;
    for (const study::CellLight& cell : light)
      noise += cell.luminance.standardError / static_cast<double>(light.size());
    for (std::size_t k = 0; k < dark.size(); ++k) {
      if (light[k].luminance.mean <= 1 - spot.request.depth.contrastAsked()) continue;
      double& depth = depths.depthMm[dark[k]];
      const double deeper = quantisedDepth(depth + kLayerMm, spot.limitMm[dark[k]]);
      deepened = deepened || deeper > depth;
      depth = std::max(depth, deeper);
    }
  }
  return Row{fmt::format("ray tracing, {} rays ±{:.3f}", rays, noise), iterations, summarise(depths).meanMm,
             millisecondsSince(start)};
}

Result<Spot> placedSpot(const std::vector<std::uint8_t>& bytes, const std::string& name, double scale, Vec3 centre,
                        double sizeMm) {
  const auto soup = readModel(bytes, name);
  QRELIEF_TRY(soup);
  auto prepared = prepareModel(*soup, {.scaleToMm = scale});
  QRELIEF_TRY(prepared);
  Spot spot;
  spot.model = EngravableModel::upload(std::move(*prepared));
  EngraveRequest& request = spot.request;
  request.code.text = "https://qrelief.example/bench-000000001";
  request.code.symbol.version = 3;
  request.placement.centreMm = centre;
  request.placement.sizeMode = sizeMm > 0 ? SizeMode::Fixed : SizeMode::Free;
  request.placement.sizeMm = sizeMm;
  auto result = engrave(spot.model, request);
  QRELIEF_TRY(result);
  request = std::move(result->request);  // with the settings that it left open
  spot.placement = std::move(result->placement);
  spot.symbol = std::move(result->symbol);
  spot.mask = submodulesToCarve(spot.symbol, *request.code.modulePattern, *request.code.finderPattern);
  spot.limitMm = wallLimits(spot.model->prepared.mesh, spot.placement.patch, spot.placement.frame, spot.mask,
                            {spot.placement.symbolMm, *request.depth.maxDepthMm, request.depth.minWallMm});
  return spot;
}

int failed(const Error& error) {
  fmt::print(stderr, "qrelief_search_bench: {}\n", sentenceAndHint(error.message));
  return 1;
}

int run(int argc, char** argv) {
  const auto context = EglContext::create();
  if (!context) return failed(context.error());
  std::vector<std::uint8_t> bytes;
  std::string name = "bumpy sphere (generated).stl";
  double scale = 1;
  Vec3 centre(0, 0, 50);
  if (argc < 4) {
    bytes = writeStl(shapes::bumpySphere(50, 2, 5, 6));
  } else {
    name = argv[1];
    std::ifstream stream(argv[1], std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
    scale = std::atof(argv[2]);
    std::sscanf(argv[3], "%lf,%lf,%lf", &centre.x, &centre.y, &centre.z);
    centre *= scale;
  }
  const double sizeMm = argc > 4 ? std::atof(argv[4]) : 35;
  const int rays = argc > 5 ? std::atoi(argv[5]) : 50;
  const auto spot = placedSpot(bytes, name, scale, centre, sizeMm);
  if (!spot) return failed(spot.error());
  fmt::print("{}, {:.4g} mm, {} dark submodules, contrast {:g}\n", name, spot->placement.symbolMm,
             std::count(spot->mask.begin(), spot->mask.end(), 1), spot->request.depth.contrastAsked());

  double fastMs = 0;
  const std::function<Result<Row>()> schemes[] = {
      [&] { return runOnMap(*spot, ContrastSolver::Fast, "map, fast"); },
      [&] { return runOnMap(*spot, ContrastSolver::PaperSteps, "map, paper-steps"); },
      [&] { return runRedrawing(*spot); },
      [&] { return runTracing(*spot, rays); },
  };
  for (const auto& scheme : schemes) {
    const Result<Row> row = scheme();
    if (!row) return failed(row.error());
    if (fastMs == 0) fastMs = row->milliseconds;
    fmt::print("{:<32} {:3} iterations  mean depth {:.3f} mm  {:10.0f} ms  {:8.1f} times\n", row->name, row->iterations,
               row->meanMm, row->milliseconds, row->milliseconds / fastMs);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::run(argc, argv); }
