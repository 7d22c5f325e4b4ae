// SPDX-License-Identifier: GPL-3.0-or-later
// What the directions and sizes beyond the paper gain, centre by centre:
//
//     qrelief_placement_table FOLDER CENTRES.json [KIND...]
//
//     CENTRES.json: {"model.stl": {"scaleToMm": 1, "picks": {"KIND": {"pointFileUnits": [x, y, z]}}}}
//
// Every direction is judged in one square: that of the depth-balanced placement. Sizes without quiet zone, mm.
#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "io/read_model.h"
#include "native/egl_context.h"
#include "pipeline/engrave.h"

namespace qrelief {
namespace {

constexpr int kModules = 29;  // version 3
constexpr double kMostMm = 100;

using Json = nlohmann::json;

Result<Placement> place(const EngravableModel& model, const GeometryPass& pass, const PlacementRequest& request) {
  PlacementSearch search(model.prepared, model.gpu, pass, kModules, request);
  for (;;) {
    const Result<bool> done = search.step();
    if (!done) return tl::unexpected(done.error());
    if (*done) return search.placement();
  }
}

/// Judged in a square of a given size.
struct Judged {
  double measure = 0, worstAngleDeg = 0, guaranteedMm = 0;
};

Result<Judged> judge(const EngravableModel& model, const GeometryPass& pass, PlacementRequest request,
                     DirectionMethod method, double sizeMm) {
  request.directionMethod = method;
  const auto placed = place(model, pass, request);
  if (!placed) return tl::unexpected(placed.error());
  DirectionOptions options;
  options.sizeMm = sizeMm;
  const ProjectionFrame frame =
      makeFrame(placed->frame.centre, placed->frame.normal, request.upHint, request.eyeDistanceMm);
  const auto looked = lookFrom(pass, model.gpu, frame, options);
  if (!looked) return tl::unexpected(looked.error());
  return Judged{looked->measure, looked->worstAngle * 180 / std::numbers::pi, placed->guaranteedMm};
}

Status printRow(const EngravableModel& model, const GeometryPass& pass, Vec3 centre, const std::string& name) {
  PlacementRequest request;
  request.centreMm = centre;
  request.maxSizeMm = kMostMm;
  const auto balanced = place(model, pass, request);
  if (!balanced) return tl::unexpected(balanced.error());
  std::array<Judged, 4> judged;
  for (const DirectionMethod method :
       {DirectionMethod::MeanNormal, DirectionMethod::DepthBalanced, DirectionMethod::Pca, DirectionMethod::Optimal}) {
    const auto result = judge(model, pass, request, method, balanced->symbolMm);
    if (!result) return tl::unexpected(result.error());
    judged[static_cast<std::size_t>(method)] = *result;
  }
  request.direction = balanced->frame.normal;
  request.sizeMode = SizeMode::Oriented;
  const auto oriented = place(model, pass, request);
  request.sizeMode = SizeMode::Best;
  const auto best = place(model, pass, request);
  if (!oriented || !best) return tl::unexpected(oriented ? best.error() : oriented.error());

  fmt::print("| {} |", name);
  for (const Judged& j : judged) fmt::print(" {:.2f} |", 1000 * j.measure);
  for (const Judged& j : judged) fmt::print(" {:.1f} |", j.worstAngleDeg);
  for (const Judged& j : judged) fmt::print(" {:.1f} |", j.guaranteedMm);
  fmt::print(" {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", balanced->guaranteedMm, oriented->symbolMm, best->symbolMm,
             best->rotationDeg);
  return {};
}

Result<std::shared_ptr<const EngravableModel>> load(const std::string& path, double scaleToMm) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
  const auto soup = readModel(bytes, path);
  if (!soup) return tl::unexpected(soup.error());
  auto prepared = prepareModel(*soup, {.scaleToMm = scaleToMm});
  if (!prepared) return tl::unexpected(prepared.error());
  if (const Status engravable = prepared->engravable(); !engravable) return tl::unexpected(engravable.error());
  return EngravableModel::upload(std::move(*prepared));
}

int failed(const std::string& what, const Error& error) {
  fmt::print(stderr, "{}: {} ({})\n", what, error.message, error.hint);
  return 1;
}

int run(const std::string& folder, const std::string& centres, const std::set<std::string>& kinds) {
  const auto context = EglContext::create();
  if (!context) return failed("EGL", context.error());
  const auto pass = GeometryPass::create();
  if (!pass) return failed("shaders", pass.error());
  std::ifstream stream(centres);
  const Json models = Json::parse(stream, nullptr, false);
  if (!models.is_object()) return failed(centres, {ErrorCode::BadInput, "not a JSON object", ""});

  fmt::print(
      "| centre | measure·1000 of mean-normal | depth-balanced | pca | optimal "
      "| worst angle (°) of mean-normal | depth-balanced | pca | optimal "
      "| guaranteed (mm) with mean-normal | depth-balanced | pca | optimal "
      "| free | oriented | best | at (°) |\n|---|{}\n",
      "---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  int status = 0;
  for (const auto& [file, entry] : models.items()) {
    const double scale = entry["scaleToMm"].get<double>();
    const auto model = load(folder + "/" + file, scale);
    if (!model) {
      status = failed(file, model.error());
      continue;
    }
    for (const auto& [kind, pick] : entry["picks"].items()) {
      if (!kinds.empty() && !kinds.contains(kind)) continue;
      const auto point = pick["pointFileUnits"].get<std::array<double, 3>>();
      const std::string name = file.substr(0, file.find('.')) + " " + kind;
      const Status printed = printRow(**model, *pass, Vec3(point[0], point[1], point[2]) * scale, name);
      if (!printed) status = failed(name, printed.error());
    }
  }
  return status;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: {} FOLDER CENTRES.json [KIND...]\n", argv[0]);
    return 2;
  }
  return qrelief::run(argv[1], argv[2], std::set<std::string>(argv + 3, argv + argc));
}
