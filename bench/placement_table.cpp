// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the gain of the directions and sizes beyond the paper, centre by centre:
//
//     qrelief_placement_table FOLDER CENTRES.json [KIND...]
//
// Every direction is judged in the same square, the depth-balanced placement's. Sizes without quiet zone, mm.
#include <algorithm>
#include <fmt/format.h>

#include "bench/centres.h"
#include "math/angle.h"

namespace qrelief {
namespace {

constexpr int kModules = 29;  // version 3
constexpr double kMostMm = 100;

/// Judges a direction in a square of a given size.
struct Judged {
  double measure = 0, worstAngleDeg = 0, guaranteedMm = 0;
};

Result<Judged> judge(const EngravableModel& model, PlacementRequest request, DirectionMethod method, double sizeMm) {
  request.directionMethod = method;
  const auto placed = bench::place(model, kModules, request);
  QRELIEF_TRY(placed);
  DirectionOptions options;
  options.sizeMm = sizeMm;
  const ProjectionFrame frame =
      makeFrame(placed->frame.centre, placed->frame.normal, request.upHint, request.eyeDistanceMm);
  const auto looked = lookFrom(*model.renderer, frame, options);
  QRELIEF_TRY(looked);
  return Judged{looked->measure, toDegrees(looked->worstAngle), placed->guaranteedMm};
}

Status printRow(const EngravableModel& model, const bench::Centre& centre) {
  PlacementRequest request;
  request.centreMm = centre.positionMm;
  request.sizeMode = SizeMode::Free;
  request.maxSizeMm = kMostMm;
  const auto balanced = bench::place(model, kModules, request);
  QRELIEF_TRY(balanced);
  std::array<Judged, 4> judged;
  for (const DirectionMethod method :
       {DirectionMethod::MeanNormal, DirectionMethod::DepthBalanced, DirectionMethod::Pca, DirectionMethod::Optimal}) {
    const auto result = judge(model, request, method, balanced->symbolMm);
    QRELIEF_TRY(result);
    judged[static_cast<std::size_t>(method)] = *result;
  }
  request.direction = balanced->frame.normal;
  request.sizeMode = SizeMode::Oriented;
  const auto oriented = bench::place(model, kModules, request);
  request.sizeMode = SizeMode::Best;
  const auto best = bench::place(model, kModules, request);
  if (!oriented || !best) return tl::unexpected(oriented ? best.error() : oriented.error());

  fmt::print("| {} |", centre.name);
  for (const Judged& j : judged) fmt::print(" {:.2f} |", 1000 * j.measure);
  for (const Judged& j : judged) fmt::print(" {:.1f} |", j.worstAngleDeg);
  for (const Judged& j : judged) fmt::print(" {:.1f} |", j.guaranteedMm);
  fmt::print(" {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", balanced->guaranteedMm, oriented->symbolMm, best->symbolMm,
             best->rotationDeg);
  return {};
}

int run(const bench::TableArguments& arguments) {
  fmt::print(
      "| centre | measure·1000 of mean-normal | depth-balanced | pca | optimal "
      "| worst angle (°) of mean-normal | depth-balanced | pca | optimal "
      "| guaranteed (mm) with mean-normal | depth-balanced | pca | optimal "
      "| free | oriented | best | at (°) |\n|---|{}\n",
      "---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  return bench::forEachCentre(arguments.folder, arguments.centresFile, arguments.kinds,
                              [&](const auto& model, const bench::Centre& centre) { return printRow(*model, centre); });
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::bench::runTable(argc, argv, qrelief::run); }
