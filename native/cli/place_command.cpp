// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/clock.h"
#include "base/version.h"
#include "cli/command_settings.h"
#include "cli/commands.h"
#include "cli/model_input.h"
#include "cli/output_files.h"
#include "cli/progress_bar.h"
#include "cli/setting_flags.h"
#include "messages/sentences.h"
#include "native/files.h"
#include "native/graphics.h"
#include "pipeline/default_patterns.h"
#include "pipeline/label_pockets.h"
#include "pipeline/requested_symbol.h"
#include "pipeline/spot_search.h"
#include "settings/setting_text.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDirectionDecimals = 4;

struct PlaceOptions {
  ModelFlags model;
  std::string json;
  SettingFlags flags;
  bool quiet = false;
  SpotSearchRequest request;
  std::optional<double> capitalModules;  // of a text alone: height of its capitals

  /// Returns the height of the capitals of a text of this size, mm.
  std::optional<double> capitalMm(double sizeMm) const {
    return capitalModules ? std::optional(*capitalModules * sizeMm / request.modules) : std::nullopt;
  }
};

std::string joined(Vec3 v, int decimals) {
  return fmt::format("{:.{}f},{:.{}f},{:.{}f}", v.x, decimals, v.y, decimals, v.z, decimals);
}

Json triple(Vec3 v) { return Json::array({v.x, v.y, v.z}); }

Status completeRequest(PlaceOptions& options) {
  auto engraving = options.flags.request();
  QRELIEF_TRY(engraving);
  SpotSearchRequest& request = options.request;
  CodeRequest& code = engraving->code;
  if (code.text.empty() && !code.isText()) {
    if (!code.symbol.version) code.symbol.version = 1;
    code.text = "1";  // if only the version is known
  }
  const auto symbol = requestedSymbol(code);
  QRELIEF_TRY(symbol);
  QRELIEF_TRY(processOf(engraving->print.printer));
  SpotSearchRequest search = spotSearchFor(*engraving, *symbol);
  search.count = request.count;
  search.views = request.views;
  request = search;
  if (code.isText()) options.capitalModules = labelCapitalMm(code.lettering(), symbol->size, 1);
  return {};
}

Json describe(const PlaceOptions& options, const ModelInput& input, std::size_t triangles, std::span<const Body> bodies,
              const SpotSearchResult& result) {
  const SpotSearchRequest& request = options.request;
  const bool isFixed = request.placement.sizeMode == SizeMode::Fixed;
  Json json;
  json["qrelief"] = kVersion;
  json["input"] = {{"file", fileNameOf(options.model.path)},
                   {"format", input.format},
                   {"triangles", triangles},
                   {"scaleToMm", input.scaleToMm}};
  json["parameters"] = {{"sizeMm", isFixed ? Json(request.placement.sizeMm) : Json(nullptr)},
                        {"maxSizeMm", request.placement.maxSizeMm},
                        {"modules", options.capitalModules ? Json() : Json(request.modules)},
                        {"quietZone", request.placement.quietZone},
                        {"direction", valueText(*options.flags.value("direction"))},
                        {"eyeDistanceMm", request.placement.eyeDistanceMm},
                        {"up", triple(request.placement.upHint)},
                        {"rotateDeg", request.placement.rotateDeg},
                        {"minWallMm", request.minWallMm},
                        {"leastDepthMm", request.leastDepthMm},
                        {"leastPrintableMm", request.leastPrintableMm},
                        {"views", request.views},
                        {"count", request.count}};
  json["map"] = {{"vertices", result.map->mesh.positions.size()},
                 {"triangles", result.map->mesh.triangles.size()},
                 {"viewsDropped", result.map->viewsDropped},
                 {"spotsTested", result.tried}};
  json["spots"] = Json::array();
  for (const Spot& spot : result.spots)
    json["spots"].push_back({{"centre", triple(spot.centreFileUnits)},
                             {"centreMm", triple(spot.centreMm)},
                             {"body", spot.body + 1},
                             {"bodyName", bodies[spot.body].name},
                             {"direction", triple(spot.direction)},
                             {"needsDirection", spot.needsDirection},
                             {"facesDown", spot.facesDown},
                             {"unevenLight", spot.unevenLight},
                             {"colourLayers", spot.colourLayers > 0 ? Json(spot.colourLayers) : Json(nullptr)},
                             {"symbolMm", spot.symbolMm},
                             {"largestMm", spot.largestMm},
                             {"guaranteedMm", spot.guaranteedMm},
                             {"prints", spot.prints},
                             {"capitalMm", options.capitalModules ? Json(*options.capitalMm(spot.symbolMm)) : Json()},
                             {"aimToleranceDeg", options.capitalModules ? Json() : Json(spot.aimToleranceDeg)},
                             {"distanceVarianceMm2", spot.quality.varianceMm2},
                             {"worstAngleDeg", spot.quality.worstAngleDeg}});
  return json;
}

/// Returns the name of a body, to follow its number; empty if it has none.
std::string quotedName(const Body& body) { return body.name.empty() ? "" : fmt::format(" (\"{}\")", body.name); }

void printSpots(const PlaceOptions& options, const SpotSearchResult& result, std::span<const Body> bodies,
                double scaleToMm) {
  for (std::size_t i = 0; i < result.spots.size(); ++i) {
    const Spot& spot = result.spots[i];
    const double largestMm = std::floor(spot.largestMm * 100) / 100;
    const auto capitalMm = options.capitalMm(largestMm);
    fmt::print("{}: --at {}{} {}  up to {:.4g} mm ({:.4g} mm at every rotation), worst angle {:.0f}°, {}\n", i + 1,
               joined(spot.centreFileUnits, centreDecimals(scaleToMm)),
               spot.needsDirection ? " --direction" : "  direction", joined(spot.direction, kDirectionDecimals),
               largestMm, std::floor(spot.guaranteedMm * 100) / 100, spot.quality.worstAngleDeg,
               capitalMm ? fmt::format("capitals up to {:.3g} mm high", *capitalMm)
                         : fmt::format("decodes from up to {:.0f}° off axis", std::floor(spot.aimToleranceDeg)));
    if (bodies.size() > 1)
      fmt::print("   on body {} of {}{}\n", spot.body + 1, bodies.size(), quotedName(bodies[spot.body]));
    if (spot.colourLayers > 0)
      fmt::print("   about {} with both colours\n",
                 counted(static_cast<std::size_t>(spot.colourLayers), "layer", "layers"));
    for (const Message& concern : spot.concerns) fmt::print("   {}\n", sentenceAndHint(concern));
  }
}

int findSpots(PlaceOptions& options) {
  const auto start = Clock::now();
  const JsonOutput output(options.json);
  if (const Status completed = completeRequest(options); !completed) return printError(completed.error());
  if (const Status good = checkJson(options.json, options.model.path); !good) return printError(good.error());
  const std::string file = fileNameOf(options.model.path);
  auto input = loadEngravable(options.model);
  if (!input) return printError(input.error(), file);
  options.request.scaleToMm = input->scaleToMm;
  const Graphics graphics = Graphics::open();
  const auto model = EngravableModel::create(std::move(input->prepared), graphics.pass);
  const double prepareMs = millisecondsSince(start);

  const auto placing = Clock::now();
  auto job = SpotSearchJob::create(model, options.request);
  if (!job) return printError(job.error(), file);
  ProgressBar bar(options.quiet);
  if (const Status done = runWithProgress(**job, bar); !done) return printError(done.error(), file);
  const SpotSearchResult result = (*job)->takeResult();
  printSpots(options, result, model->prepared.bodies, input->scaleToMm);
  if (result.spots.size() < options.request.count)
    fmt::print(stderr, "qrelief: warning: {}: found {} of {} spots\n", file, result.spots.size(),
               options.request.count);
  if (!output.isWanted()) return kEngraved;
  Json json = describe(options, *input, model->prepared.mesh.triangles.size(), model->prepared.bodies, result);
  json["timingsMs"] = {
      {"prepare", prepareMs}, {"place", millisecondsSince(placing)}, {"total", millisecondsSince(start)}};
  // A file name that is not UTF-8 must not lose the report.
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  const Status written = output.write(text);
  return written ? kEngraved : printError(written.error());
}

}  // namespace

std::function<int()> addPlaceCommand(CLI::App& app) {
  auto o = std::make_shared<PlaceOptions>();
  SpotSearchRequest& request = o->request;
  CLI::App* c = app.add_subcommand("place", "Find the best spots for a QR code or a text; each is tested");
  addModelFlags(*c, o->model);
  c->add_option("--count", request.count, fmt::format("spots to find [{}]", request.count))
      ->check(CLI::Range(std::size_t{1}, kMaxSpots));
  c->add_option("--json", o->json, "write the spots and their measurements as JSON; - writes to standard output");
  o->flags.add(*c, "text", "gives the exact quiet zone, which is narrower for longer texts: ");
  for (const char* group : kPlaceGroups) o->flags.addGroup(*c, group);
  for (const char* key : kPlaceKeys) o->flags.add(*c, key);
  c->add_option("--views", request.views, fmt::format("number of viewing directions tried [{}]", request.views))
      ->check(CLI::Range(200, 10000));
  c->add_flag("--quiet", o->quiet, "do not show progress");
  return [o] { return findSpots(*o); };
}

}  // namespace qrelief
