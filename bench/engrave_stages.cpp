// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the time of an engraving stage by stage: the median of some runs in one process, and each stage's share.
//
//     qrelief_bench                                       a bumpy sphere of 82k triangles, version 3, 35 mm
//     qrelief_bench MODEL SCALE X,Y,Z [SIZE] [RUNS]       a model of your own, centre in file units
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <sys/resource.h>

#include "base/clock.h"
#include "io/read_model.h"
#include "io/write_stl.h"
#include "messages/sentences.h"
#include "native/egl_context.h"
#include "native/zxing_decoder.h"
#include "pipeline/engrave.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

struct Case {
  std::string name = "bumpy sphere (generated)";
  std::vector<std::uint8_t> bytes;
  double scale = 1;
  Vec3 centre{0, 0, 50};
  double sizeMm = 35;
  int runs = 5;
};

Case caseFrom(int argc, char** argv) {
  Case result;
  if (argc < 4) {
    result.bytes = writeStl(shapes::bumpySphere(50, 2, 5, 6));
    result.name += ".stl";
  } else {
    result.name = argv[1];
    std::ifstream stream(argv[1], std::ios::binary);
    result.bytes.assign(std::istreambuf_iterator<char>(stream), {});
    result.scale = std::atof(argv[2]);
    std::sscanf(argv[3], "%lf,%lf,%lf", &result.centre.x, &result.centre.y, &result.centre.z);
    result.centre *= result.scale;
  }
  if (argc > 4) result.sizeMm = std::atof(argv[4]);
  if (argc > 5) result.runs = std::max(1, std::atoi(argv[5]));
  return result;
}

int failed(const Error& error) {
  fmt::print(stderr, "qrelief_bench: {}\n", sentenceAndHint(error.message));
  return 1;
}

int measure(const Case& subject) {
  const auto context = EglContext::create();
  if (!context) return failed(context.error());
  const auto gl = gl::queryCapabilities();
  if (!gl) return failed(gl.error());

  std::map<std::string, std::vector<double>> times;
  EngraveResult last;
  std::size_t triangles = 0;
  for (int run = 0; run < subject.runs; ++run) {
    const auto start = Clock::now();
    const auto soup = readModel(subject.bytes, subject.name);
    if (!soup) return failed(soup.error());
    times["load"].push_back(millisecondsSince(start));
    const auto preparing = Clock::now();
    auto prepared = prepareModel(*soup, {.scaleToMm = subject.scale});
    if (!prepared) return failed(prepared.error());
    const auto model = EngravableModel::upload(std::move(*prepared));
    times["prepare"].push_back(millisecondsSince(preparing));
    triangles = model->prepared.mesh.triangles.size();

    EngraveRequest request;
    request.code.text = "https://qrelief.example/bench-000000001";
    request.code.symbol.version = 3;
    request.placement.centreMm = subject.centre;
    request.placement.sizeMode = subject.sizeMm > 0 ? SizeMode::Fixed : SizeMode::Free;
    request.placement.sizeMm = subject.sizeMm;
    auto result = engrave(model, request);
    if (!result) return failed(result.error());
    const auto reading = Clock::now();
    (void)readWithZxing(result->readerView);
    times["decode"].push_back(millisecondsSince(reading));
    for (const auto& [stage, ms] : result->timingsMs.all()) times[stage].push_back(ms);
    times["total"].push_back(millisecondsSince(start));
    last = std::move(*result);
  }

  const auto median = [&](const std::string& stage) {
    std::vector<double> sorted = times[stage];
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  };
  fmt::print("{}: {} triangles, {:.4g} mm, version {}, {} iterations, {} triangles out\n", subject.name, triangles,
             last.placement.symbolMm, last.symbol.version, last.searchIterations, last.solidity.triangles);
  fmt::print("{}, {}; median of {} runs\n", gl->renderer, gl->version, subject.runs);
  std::vector<std::string> order = {"load", "prepare"};
  for (const auto& [stage, ms] : last.timingsMs.all()) order.emplace_back(stage);
  order.insert(order.end(), {"decode", "total"});
  for (const std::string& stage : order)
    fmt::print("{:>12} {:9.1f} ms  {:5.1f} %\n", stage, median(stage), 100 * median(stage) / median("total"));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("{:>12} {:9.1f} MB\n", "peak memory", static_cast<double>(usage.ru_maxrss) / 1024);
  return 0;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::measure(qrelief::caseFrom(argc, argv)); }
