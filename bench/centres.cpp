// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/centres.h"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/read_model.h"
#include "messages/sentences.h"
#include "native/egl_context.h"

namespace qrelief::bench {
namespace {

using Json = nlohmann::json;

Result<std::shared_ptr<const EngravableModel>> load(const std::string& path, double scaleToMm) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
  const auto soup = readModel(bytes, path);
  QRELIEF_TRY(soup);
  auto prepared = prepareModel(*soup, {.scaleToMm = scaleToMm});
  QRELIEF_TRY(prepared);
  QRELIEF_TRY(prepared->engravable());
  return EngravableModel::upload(std::move(*prepared));
}

std::vector<std::string> kindsOf(const Json& picks, const std::vector<std::string>& requested) {
  std::vector<std::string> kinds;
  if (requested.empty())
    for (const auto& [kind, pick] : picks.items()) kinds.push_back(kind);
  for (const std::string& kind : requested)
    if (picks.contains(kind)) kinds.push_back(kind);
  return kinds;
}

}  // namespace

int failed(const std::string& what, const Error& error) {
  fmt::print(stderr, "{}: {}\n", what, sentenceAndHint(error.message));
  return 1;
}

int runTable(int argc, char** argv, const std::function<int(const TableArguments&)>& run) {
  if (argc < 3) {
    fmt::print(stderr, "usage: {} FOLDER CENTRES.json [KIND...]\n", argv[0]);
    return 2;
  }
  const auto context = EglContext::create();
  if (!context) return failed("EGL", context.error());
  return run({argv[1], argv[2], std::vector<std::string>(argv + 3, argv + argc)});
}

int forEachCentre(const std::string& folder, const std::string& centresFile, const std::vector<std::string>& kinds,
                  const AtCentre& visit) {
  std::ifstream stream(centresFile);
  const Json models = Json::parse(stream, nullptr, false);
  if (!models.is_object()) {
    fmt::print(stderr, "{}: not a JSON object\n", centresFile);
    return 1;
  }
  int status = 0, number = 0;
  for (const auto& [file, entry] : models.items()) {
    const double scale = entry["scaleToMm"].get<double>();
    const auto model = load(fmt::format("{}/{}", folder, file), scale);
    if (!model) {
      status = failed(file, model.error());
      continue;
    }
    for (const std::string& kind : kindsOf(entry["picks"], kinds)) {
      const Json& pick = entry["picks"][kind];
      const auto point = pick["pointFileUnits"].get<std::array<double, 3>>();
      Centre centre{
          file.substr(0, file.find('.')) + " " + kind, number, Vec3(point[0], point[1], point[2]) * scale, {}};
      if (pick.contains("widthWithQuietZoneMm"))
        centre.widthWithQuietZoneMm = pick["widthWithQuietZoneMm"].get<double>();
      if (const Status visited = visit(*model, centre); !visited) status = failed(centre.name, visited.error());
    }
    ++number;
  }
  return status;
}

Result<Placement> place(const EngravableModel& model, int modules, const PlacementRequest& request) {
  PlacementSearch search(model.prepared, *model.renderer, modules, request);
  for (;;) {
    const Result<bool> done = search.step();
    QRELIEF_TRY(done);
    if (*done) return search.placement();
  }
}

}  // namespace qrelief::bench
