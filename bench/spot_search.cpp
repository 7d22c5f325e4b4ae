// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how the time of the spot search grows with the model's triangles and with the views, and compares a view
// drawn by the processor with one drawn by the GPU and read back. Best of some runs, and ratios to the first row.
//
//     qrelief_spot_bench            a bumpy sphere of 20k to 1.3 M triangles, 41 mm squares
#include "pipeline/spot_search.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/clock.h"
#include "mesh/prepare.h"
#include "messages/sentences.h"
#include "native/egl_context.h"
#include "projection/view_raster.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr int kRuns = 3;
constexpr double kSizeMm = 30;

template <class Work>
double bestMs(int runs, const Work& work) {
  double best = 1e300;
  for (int run = 0; run < runs; ++run) {
    const auto start = Clock::now();
    work();
    best = std::min(best, millisecondsSince(start));
  }
  return best;
}

SizeMapOptions mapOptions(int views) {
  SizeMapOptions options;
  options.minMm = kSizeMm * 29 / 21;
  options.views = views;
  return options;
}

std::shared_ptr<const EngravableModel> modelOf(int level) {
  auto prepared = prepareModel(shapes::soupOf(shapes::bumpySphere(50, 2, 5, level)), {});
  return EngravableModel::upload(std::move(*prepared));
}

void growWithTriangles() {
  fmt::print("{:>10} {:>10} {:>10} {:>7} {:>10} {:>7}\n", "triangles", "drawn", "map ms", "ratio", "place ms", "ratio");
  double firstMap = 0, firstPlace = 0;
  for (const int level : {5, 6, 7, 8}) {
    const auto model = modelOf(level);
    std::size_t drawn = 0;
    const double map = bestMs(kRuns, [&] {
      drawn = makeSizeMap(model->prepared.mesh, model->prepared.normals, mapOptions(240)).mesh.triangles.size();
    });
    SpotSearchRequest request;
    request.placement.sizeMode = SizeMode::Fixed;
    request.placement.sizeMm = kSizeMm;
    const double whole = bestMs(kRuns, [&] { (void)findSpots(model, request); });
    if (firstMap == 0) firstMap = map, firstPlace = whole;
    fmt::print("{:>10} {:>10} {:>10.1f} {:>7.2f} {:>10.1f} {:>7.2f}\n", model->prepared.mesh.triangles.size(), drawn,
               map, map / firstMap, whole, whole / firstPlace);
  }
}

void growWithViews() {
  const Mesh mesh = shapes::bumpySphere(50, 2, 5, 6);
  const std::vector<Vec3f> normals = vertexNormals(mesh);
  fmt::print("\n{:>10} {:>10} {:>7}\n", "views", "map ms", "ratio");
  double first = 0;
  for (const int views : {200, 240, 500, 1000, 2000}) {
    const double map = bestMs(kRuns, [&] { (void)makeSizeMap(mesh, normals, mapOptions(views)); });
    if (first == 0) first = map;
    fmt::print("{:>10} {:>10.1f} {:>7.2f}\n", views, map, map / first);
  }
}

Status compareWithGpu() {
  const Mesh mesh =
      makeSizeMap(shapes::bumpySphere(50, 2, 5, 6), vertexNormals(shapes::bumpySphere(50, 2, 5, 6)), mapOptions(1))
          .mesh;
  const ProjectionFrame frame = makeFrame({0, 0, 0}, {1, 2, 3}, {0, 0, 1}, 300);
  const Adjacency adjacency = buildAdjacency(mesh.triangles);
  ViewRaster raster(mesh, adjacency);
  const double cpu = bestMs(20, [&] { raster.draw(frame, {110, 128}, 0.4); });

  const GpuMesh gpuMesh(mesh, vertexNormals(mesh));
  const auto pass = GeometryPass::create();
  QRELIEF_TRY(pass);
  const double gpu = bestMs(20, [&] {
    const auto maps = pass->render(gpuMesh, frame, {110, 128});
    if (maps) (void)maps->framebuffer.readRgba(1);
  });
  fmt::print(
      "\none view of {} triangles, 128² texels: processor {:.2f} ms (contours included), GL and read-back "
      "{:.2f} ms (without contours), ratio {:.2f}\n",
      mesh.triangles.size(), cpu, gpu, gpu / cpu);
  return {};
}

int run() {
  const auto context = EglContext::create();
  if (!context) {
    fmt::print(stderr, "qrelief_spot_bench: {}\n", sentence(context.error().message));
    return 1;
  }
  const auto gl = gl::queryCapabilities();
  if (gl) fmt::print("{}; best of {} runs\n", gl->renderer, kRuns);
  growWithTriangles();
  growWithViews();
  return compareWithGpu() ? 0 : 1;
}

}  // namespace
}  // namespace qrelief

int main() { return qrelief::run(); }
