// SPDX-License-Identifier: GPL-3.0-or-later
// Measures our simulated print of an engraved model: its time, whether it decodes, and its difference from a print
// surface of another origin (from a slicer's toolpaths, or scanned).
#include "printing/printed_surface.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/clock.h"
#include "bench/engraved_file.h"
#include "io/write_stl.h"
#include "mesh/ray_tree.h"
#include "native/zxing_decoder.h"
#include "verdict/verdict.h"
#include "verification/baked_light.h"
#include "verification/frontal_reading.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;
using bench::loadEngraved, bench::moduleMeans, bench::vectorOf;

constexpr int kMarginModules = kPictureMarginModules, kTexelsAModule = kBakedPixels;
constexpr int kPaths = 16;

/// View of a mesh from the eye: heights at the middles of texels, light of the modules, and the decoded tries.
struct Seen {
  std::vector<double> heightMm;  // NaN: nothing
  std::vector<double> modules;   // mean luminance
  ReadingEvidence reading;
  double treeMs = 0, lightMs = 0, readMs = 0;
};

Seen look(const Mesh& mesh, const ProjectionFrame& frame, int modules, double symbolMm, const std::string& text) {
  Seen seen;
  Clock::time_point start = Clock::now();
  const RayTree tree(mesh);
  seen.treeMs = millisecondsSince(start);
  const int texels = kTexelsAModule * (modules + 2 * kMarginModules);
  const double texelMm = symbolMm / modules / kTexelsAModule;
  BakedLight light(tree, frame, {.texelMm = texelMm, .texels = texels, .paths = kPaths});
  start = Clock::now();
  light.bakeRows(texels);
  light.smooth();
  seen.lightMs = millisecondsSince(start);
  BottomUp<float> picture(texels, texels, 0.35f);
  for (std::size_t i = 0; i < picture.size(); ++i)
    if (light.light()[i].sky >= 0) picture[i] = static_cast<float>(light.light()[i].sky);
  seen.modules = moduleMeans(picture, modules);
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column) {
      const Vec2 at((column + 0.5 - texels / 2.0) * texelMm, (row + 0.5 - texels / 2.0) * texelMm);
      const auto hit = tree.firstHit(frame.eye(), frame.rayDirection(at));
      seen.heightMm.push_back(hit ? glm::dot(hit->position - frame.centre, frame.normal) : std::nan(""));
    }
  start = Clock::now();
  std::vector<std::string> texts;
  for (const GreyImage& image : frontalPictures(picture, kTexelsAModule))
    for (const Decoder& read : zxingDecoders()) {
      const auto decoded = read(image);
      texts.push_back(decoded && !decoded->mirrored ? decoded->text : "");
    }
  seen.reading = evidenceOf(texts, text, true);
  seen.readMs = millisecondsSince(start);
  return seen;
}

/// Adds a sliver of a triangle below the mesh's lowest point.
Mesh onFoot(Mesh mesh, Vec3 up, double footMm) {
  up = glm::normalize(up);
  const auto lower = [&](Vec3f a, Vec3f b) { return glm::dot(Vec3(a), up) < glm::dot(Vec3(b), up); };
  const Vec3f lowest = *std::min_element(mesh.positions.begin(), mesh.positions.end(), lower);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int k = 0; k < 3; ++k) mesh.positions.push_back(lowest - Vec3f(up * footMm));
  mesh.triangles.push_back({first, first + 1, first + 2});
  return mesh;
}

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return std::nan("");
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void tell(const char* name, const Seen& seen) {
  const ReadingCount& count = seen.reading.count;
  fmt::print("{}: {} of {} tries, {}; tree {:.0f} ms, light {:.0f} ms, reading {:.0f} ms\n", name, count.reads,
             count.tries, count.enough() ? "reads" : "does not read", seen.treeMs, seen.lightMs, seen.readMs);
}

void compare(const Seen& ours, const Seen& other) {
  std::vector<double> heights, light;
  for (std::size_t i = 0; i < ours.heightMm.size(); ++i)
    if (!std::isnan(ours.heightMm[i] + other.heightMm[i]))
      heights.push_back(std::abs(ours.heightMm[i] - other.heightMm[i]));
  double sum = 0, signedSum = 0;
  for (std::size_t i = 0; i < ours.modules.size(); ++i) {
    light.push_back(std::abs(ours.modules[i] - other.modules[i]));
    sum += light.back();
    signedSum += ours.modules[i] - other.modules[i];
  }
  const double modules = static_cast<double>(light.size());
  fmt::print(
      "heights apart: median {:.3f}, 95 % {:.3f} mm; modules' luminance apart: mean {:.3f} (signed {:+.3f}), 95 % "
      "{:.3f}, over 0.08 {} of {}\n",
      quantile(heights, 0.5), quantile(heights, 0.95), sum / modules, signedSum / modules, quantile(light, 0.95),
      std::count_if(light.begin(), light.end(), [](double apart) { return apart > 0.08; }), light.size());
}

int run(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "usage: {} REPORT.json MESH up|side|slant PROCESS [OTHER [OUT.stl [FOOT_MM]]]\n", argv[0]);
    return 2;
  }
  // Place it on a foot of the requested height, so that layers lie as in a print that stands on it.
  const double footMm = argc > 7 ? std::stod(argv[7]) : 0;
  const Json report = Json::parse(std::ifstream(argv[1]), nullptr, false);
  const auto mesh = loadEngraved(argv[2]);
  if (!report.is_object() || !mesh) {
    fmt::print(stderr, "{} or {} cannot be read\n", argv[1], argv[2]);
    return 1;
  }
  const Json& placed = report["projection"];
  const ProjectionFrame frame = makeFrame(vectorOf(placed["centre"]), vectorOf(placed["normal"]),
                                          vectorOf(placed["up"]), placed["eyeDistanceMm"].get<double>());
  const double symbolMm = report["size"]["symbolMm"].get<double>();
  const int modules = report["symbol"]["modules"].get<int>();
  const std::string text = report["text"].get<std::string>(), facing = argv[3];
  PrintRequest request;
  request.frame = frame;
  request.extentMm = symbolMm * (modules + 2 * kMarginModules) / modules;
  request.buildUp = facing == "up" ? frame.normal : facing == "side" ? frame.up : frame.normal + frame.up;
  for (const NamedPrinter& known : namedPrinters())
    if (known.name == argv[4]) request.process = *processOf(known.printer);
  const Clock::time_point start = Clock::now();
  const auto printed = printSurface(footMm > 0 ? onFoot(*mesh, request.buildUp, footMm) : *mesh, request);
  if (!printed) {
    fmt::print(stderr, "{}\n", printed.error().message.code);
    return 1;
  }
  const double surfaceMs = millisecondsSince(start);
  const Mesh surface = printed->mesh();
  fmt::print("surface: {} texels along the edge, {} triangles; {:.0f} ms, as a mesh {:.0f} ms\n", printed->texels,
             surface.triangles.size(), surfaceMs, millisecondsSince(start) - surfaceMs);
  const Seen designed = look(*mesh, frame, modules, symbolMm, text);
  tell("designed", designed);
  const Seen ours = look(surface, frame, modules, symbolMm, text);
  tell("printed", ours);
  if (argc > 5) {
    if (const auto reference = loadEngraved(argv[5])) {
      const Seen other = look(*reference, frame, modules, symbolMm, text);
      tell("other", other);
      compare(ours, other);
    }
  }
  if (argc > 6 && argv[6][0] != '-') {
    const std::vector<std::uint8_t> bytes = writeStl(surface);
    std::ofstream(argv[6], std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  return 0;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::run(argc, argv); }
