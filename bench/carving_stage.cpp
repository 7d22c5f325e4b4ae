// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the carving stage alone, and writes its input for a peer that does the same by boolean subtraction: the
// model, and the pockets as a body that sticks out of the surface a little. Started by script/bench carving.
//
//     qrelief_carving_bench FOLDER {MODEL SCALE X,Y,Z}...       centres in file units
//
// For each model and two patterns, writes the median time of some runs, triangles and volume to FOLDER/cases.json, and
// model and pockets as 32-bit floats and indices to FOLDER/NAME.{model,pockets}.{xyz,tri}.
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/clock.h"
#include "carving/embed.h"
#include "carving_spot.h"
#include "io/read_model.h"
#include "messages/sentences.h"

namespace qrelief {
namespace {

constexpr int kRuns = 7;
constexpr double kDepthMm = 0.5;
constexpr double kSticksOutMm = 0.05;

/// Returns the inlay with its surface vertices moved towards the eye: the vertices of facets that face the eye, because
/// walls run along the rays and floors face away.
Mesh stickingOut(const Mesh& inlay, const ProjectionFrame& frame) {
  Mesh pockets = inlay;
  std::vector<char> onSurface(inlay.positions.size(), 0);
  for (std::size_t t = 0; t < inlay.triangles.size(); ++t) {
    const Vec3 toEye = glm::normalize(frame.eye() - inlay.corner(t, 0));
    if (glm::dot(triangleNormal(inlay, t), toEye) < 0.02) continue;
    for (const std::uint32_t v : inlay.triangles[t]) onSurface[v] = 1;
  }
  for (std::size_t v = 0; v < onSurface.size(); ++v) {
    if (!onSurface[v]) continue;
    const Vec3 p(inlay.positions[v]);
    pockets.positions[v] = Vec3f(p + glm::normalize(frame.eye() - p) * kSticksOutMm);
  }
  return pockets;
}

void write(const std::string& path, const void* data, std::size_t bytes) {
  std::ofstream(path, std::ios::binary).write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
}

void write(const std::string& path, const Mesh& mesh) {
  write(path + ".xyz", mesh.positions.data(), mesh.positions.size() * sizeof(Vec3f));
  write(path + ".tri", mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
}

Result<nlohmann::ordered_json> measure(const PreparedModel& model, const bench::Spot& spot, const Symbol& symbol,
                                       bool square, const std::string& path) {
  const SubmoduleMask mask = submodulesToCarve(symbol, square ? ModulePattern::Square : ModulePattern::None,
                                               square ? FinderPattern::ThickPlus : FinderPattern::None);
  const DepthField depths = bench::carveEvenly(model, spot, mask, kDepthMm);
  nlohmann::ordered_json json;
  for (const SurfaceMode surface : {SurfaceMode::Preserved, SurfaceMode::Resampled}) {
    std::vector<double> times;
    EmbedResult last;
    for (int run = 0; run < kRuns; ++run) {
      const auto start = Clock::now();
      auto result = embedDepthField(model.mesh, spot.frame, spot.patch.triangles, depths, {.surface = surface});
      times.push_back(millisecondsSince(start));
      QRELIEF_TRY(result);
      last = std::move(*result);
    }
    std::nth_element(times.begin(), times.begin() + kRuns / 2, times.end());
    json[std::string(surfaceModeName(surface))] = {
        {"ms", times[kRuns / 2]}, {"triangles", last.mesh.triangles.size()}, {"volumeMm3", signedVolume(last.mesh)}};
  }
  const auto carved = embedDepthField(model.mesh, spot.frame, spot.patch.triangles, depths, {.inlay = true});
  QRELIEF_TRY(carved);
  write(path + ".pockets", stickingOut(carved->inlay, spot.frame));
  return json;
}

int failed(const std::string& model, const Error& error) {
  fmt::print(stderr, "qrelief_carving_bench: {}: {}\n", model, sentenceAndHint(error.message));
  return 1;
}

int measureAll(int argc, char** argv) {
  if (argc < 5 || (argc - 2) % 3 != 0) {
    fmt::print(stderr, "usage: qrelief_carving_bench FOLDER {{MODEL SCALE X,Y,Z}}...\n");
    return 2;
  }
  const std::string folder = argv[1];
  const auto symbol = encodeSymbol("https://qrelief.example/bench-000000001", {.version = 3});
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  for (int k = 2; k < argc; k += 3) {
    std::ifstream stream(argv[k], std::ios::binary);
    const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
    Vec3 centre(0);
    std::sscanf(argv[k + 2], "%lf,%lf,%lf", &centre.x, &centre.y, &centre.z);
    const double scale = std::atof(argv[k + 1]);
    const auto soup = readModel(bytes, argv[k]);
    if (!soup) return failed(argv[k], soup.error());
    const auto model = prepareModel(*soup, {.scaleToMm = scale});
    if (!model) return failed(argv[k], model.error());
    const auto spot = bench::findSpot(*model, centre * scale, symbol->size);
    if (!spot) return failed(argv[k], spot.error());
    for (const bool square : {false, true}) {
      const std::string name = fmt::format("case{}", cases.size()), path = fmt::format("{}/{}", folder, name);
      auto measured = measure(*model, *spot, *symbol, square, path);
      if (!measured) return failed(argv[k], measured.error());
      write(path + ".model", model->mesh);
      cases.push_back({{"name", name},
                       {"model", argv[k]},
                       {"pattern", square ? "square" : "none"},
                       {"symbolMm", spot->symbolMm},
                       {"triangles", model->mesh.triangles.size()},
                       {"volumeMm3", signedVolume(model->mesh)},
                       {"ours", *measured}});
    }
  }
  const std::string text = cases.dump(2);
  write(folder + "/cases.json", text.data(), text.size());
  return 0;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::measureAll(argc, argv); }
