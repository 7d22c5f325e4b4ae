// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment of Papp 2022, §8 (figures 21 and 22) in simulation: a code engraved under the sky and one lamp, read
// under the sky and a lamp that stands elsewhere.
//
//     qrelief_lamp_bench [STRENGTH]       of the lamp, 1 = the whole sky
//
// The paper's angles are between the light's direction of travel and the code's normal: 98° is a lamp 8° over the code,
// 123° one 33° over it. A flat plate, version 3, modules of 1.2 mm, the paper's contrast rule.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "messages/sentences.h"
#include "native/egl_context.h"
#include "native/zxing_reader.h"
#include "pipeline/engrave.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kAzimuthDeg = 90;  // at the symbol's top
constexpr std::array<double, 10> kReadingElevationsDeg = {4, 8, 15, 23, 33, 38, 48, 63, 78, 88};

int failed(const std::string& what, const Error& error) {
  fmt::print(stderr, "{}: {}\n", what, sentenceAndHint(error.message));
  return 1;
}

Result<bool> readsUnder(const GeometryPass& pass, const EngraveRequest& request, const EngraveResult& engraved,
                        double elevationDeg, double strength) {
  const GpuMesh carved(engraved.mesh, vertexNormals(engraved.mesh));
  const int modulesAcross = engraved.symbol.size + 12;
  ReaderViewOptions options;
  options.extentMm = engraved.placement.moduleMm * modulesAcross;
  options.texels = 8 * modulesAcross;
  options.reliefMm = static_cast<float>(summarise(engraved.depths).maxMm);
  options.radiusMm = 8 * options.reliefMm;
  options.lights = {{.azimuthDeg = kAzimuthDeg, .elevationDeg = elevationDeg, .strength = strength}};
  auto view = renderReaderView(pass, carved, engraved.placement.frame, options);
  if (!view) return tl::unexpected(view.error());
  view->pixelsPerModule = 8;
  return readWithZxing(*view) == request.text;
}

Status printRow(const GeometryPass& pass, const std::shared_ptr<const EngravableModel>& model, bool withPatterns,
                std::optional<double> elevationDeg, double strength) {
  EngraveRequest request;
  request.text = "https://example.com/qrelief";
  request.symbol.version = 3;
  request.placement.centreMm = {0, 0, 0};
  request.placement.upHint = {0, 1, 0};
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 29 * 1.2;
  request.modulePattern = withPatterns ? ModulePattern::Square : ModulePattern::None;
  request.finderPattern = withPatterns ? FinderPattern::ThickPlus : FinderPattern::None;
  if (elevationDeg) request.lights = {{.azimuthDeg = kAzimuthDeg, .elevationDeg = *elevationDeg, .strength = strength}};
  const auto engraved = engrave(model, request);
  if (!engraved) return tl::unexpected(engraved.error());
  fmt::print("| {} | {} | {:.2f} | {} |", withPatterns ? "square, thick-plus" : "none",
             elevationDeg ? fmt::format("{:g}°", *elevationDeg) : "sky alone", summarise(engraved->depths).meanMm,
             engraved->limitedSubmodules);
  for (const double reading : kReadingElevationsDeg) {
    const auto reads = readsUnder(pass, request, *engraved, reading, strength);
    if (!reads) return tl::unexpected(reads.error());
    fmt::print(" {} |", *reads ? "reads" : "–");
    std::fflush(stdout);
  }
  fmt::print("\n");
  return {};
}

int run(double strength) {
  const auto context = EglContext::create();
  if (!context) return failed("EGL", context.error());
  const auto pass = GeometryPass::create();
  if (!pass) return failed("shaders", pass.error());
  auto prepared = prepareModel(shapes::soupOf(shapes::plate({60, 60}, 10, 4, 4)), {});
  if (!prepared) return failed("plate", prepared.error());
  const auto model = EngravableModel::upload(std::move(*prepared));

  fmt::print(
      "Lamp {:g} times as strong as the sky\n\n| patterns | lamp when engraved | mean depth (mm) "
      "| submodules at a limit |",
      strength);
  for (const double reading : kReadingElevationsDeg) fmt::print(" read at {:g}° |", reading);
  fmt::print("\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const bool withPatterns : {false, true})
    for (const std::optional<double> elevation : {std::optional<double>(), std::optional(8.0), std::optional(33.0)})
      if (const Status printed = printRow(*pass, model, withPatterns, elevation, strength); !printed)
        return failed("plate", printed.error());
  return 0;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::run(argc > 1 ? std::atof(argv[1]) : 1); }
