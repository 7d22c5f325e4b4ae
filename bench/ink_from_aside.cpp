// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the angles from which a code on a curved surface can decode at all, however it is made: painted with black
// ink on the uncarved model, by the same projection. Where ink does not decode, no carving can.
//
//     qrelief_ink_bench FOLDER CENTRES.json [KIND...]       CENTRES.json: see bench/centres.h
//
// Version 3, as wide as the centre's width or the largest that fits, whichever is less; the phone at the reader's
// distance, from eight sides; blur and noise as in the verification; ZXing-C++ in all its reading variants. Surface
// hidden from the front counts as painted, too, so the counts are, if anything, too high.
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "bench/centres.h"
#include "native/zxing_decoder.h"
#include "projection/flatness.h"
#include "verification/baked_light.h"

namespace qrelief {
namespace {

constexpr int kModules = 29;
constexpr int kModulesAcross = kModules + 12;
constexpr int kPixelsPerModule = 14;
constexpr float kInk = 0.05f, kPaper = 1, kBackground = 0.35f;  // linear luminance
constexpr std::array<double, 8> kTiltsDeg = {0, 3, 6, 10, 15, 20, 25, 30};
constexpr int kSides = 8;

bool isDark(const Symbol& symbol, const Placement& placement, Vec3 point) {
  const Vec2 modules = placement.frame.project(point) / placement.moduleMm;
  const int column = static_cast<int>(std::floor(modules.x + kModules / 2.0));
  const int row = static_cast<int>(std::floor(kModules / 2.0 - modules.y));
  return row >= 0 && column >= 0 && row < kModules && column < kModules && symbol.isDark(row, column);
}

Result<bool> reads(const EngravableModel& model, const Symbol& symbol, const Placement& placement,
                   const std::string& text, double tiltDeg, double azimuthDeg) {
  const ProjectionFrame camera = tilted(placement.frame, tiltDeg, azimuthDeg);
  const int texels = kModulesAcross * kPixelsPerModule;
  const MapWindow window{kModulesAcross * placement.moduleMm, texels};
  const auto surface = model.renderer->render(camera, window);
  QRELIEF_TRY(surface);
  const std::vector<float> distances = rayDistances(*surface, camera, window);
  BottomUp<float> luminance(texels, texels);
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column) {
      const double distance = static_cast<double>(distances[static_cast<std::size_t>(row * texels + column)]);
      const Vec3 point = camera.eye() + camera.rayDirection(window.planePoint(column, row)) * distance;
      luminance.at(row, column) = distance <= 0 ? kBackground : isDark(symbol, placement, point) ? kInk : kPaper;
    }
  ReaderView view;
  const ReaderViewOptions phone;
  view.picture = photograph(
      luminance, {.blurPx = phone.blurPx * texels / 700, .noise = phone.noise, .strayLight = phone.strayLight});
  view.pixelsPerModule = kPixelsPerModule;
  return readWithZxing(view) == text;
}

/// Counts the sides from which the code decodes, by tilt.
using Counts = std::array<int, kTiltsDeg.size()>;

Result<Counts> countSides(const EngravableModel& model, const Placement& placement) {
  const std::string text = "https://example.com/qrelief";
  const auto symbol = encodeSymbol(text, {.version = 3});
  QRELIEF_TRY(symbol);
  Counts counts{};
  for (std::size_t t = 0; t < kTiltsDeg.size(); ++t) {
    for (int side = 0; side < kSides; ++side) {
      const auto read = reads(model, *symbol, placement, text, kTiltsDeg[t], side * 360.0 / kSides);
      QRELIEF_TRY(read);
      counts[t] += *read;
    }
    if (counts[t] == 0) break;  // nothing decodes at larger tilts, either
  }
  return counts;
}

int run(const bench::TableArguments& arguments) {
  fmt::print("| centre | width (mm) | bend (modules) | foretold (°) | sides of {} at {}° |\n|---|---|---|---|{}\n",
             kSides, fmt::join(kTiltsDeg, "° | "), "---|---|---|---|---|---|---|---|");
  int visited = 0;
  Counts anySide{}, everySide{};
  const auto visit = [&](const std::shared_ptr<const EngravableModel>& model, const bench::Centre& centre) -> Status {
    PlacementRequest request;
    request.sizeMode = SizeMode::Free;
    request.centreMm = centre.positionMm;
    if (centre.widthWithQuietZoneMm)
      request.maxSizeMm = *centre.widthWithQuietZoneMm * kModules / (kModules + 2 * kQuietZoneModules);
    const auto placement = bench::place(*model, kModules, request);
    QRELIEF_TRY(placement);
    const auto counts = countSides(*model, *placement);
    QRELIEF_TRY(counts);
    fmt::print("| {} | {:.1f} | {:.2f} | {:.0f} | {} |\n", centre.name, placement->symbolMm,
               placement->bendMm / placement->moduleMm,
               std::floor(aimToleranceDeg(placement->bendMm, placement->moduleMm)), fmt::join(*counts, " | "));
    std::fflush(stdout);
    ++visited;
    for (std::size_t t = 0; t < kTiltsDeg.size(); ++t) {
      anySide[t] += (*counts)[t] > 0;
      everySide[t] += (*counts)[t] == kSides;
    }
    return {};
  };
  const int status = bench::forEachCentre(arguments.folder, arguments.centresFile, arguments.kinds, visit);
  fmt::print("| of {}, from any side | | | | {} |\n| from every side | | | | {} |\n", visited,
             fmt::join(anySide, " | "), fmt::join(everySide, " | "));
  return status;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::bench::runTable(argc, argv, qrelief::run); }
