// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/printed_code.h"

#include <cassert>
#include <utility>

#include "base/parse_json.h"
#include "io/read_model.h"
#include "message_codes/engine.h"
#include "verification/frontal_reading.h"

namespace qrelief {
namespace {

Vec3 vectorOf(const Json& json) { return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()}; }

/// The numbers of a process, by their keys in an order.
constexpr std::pair<const char*, double PrintProcess::*> kProcessParts[] = {
    {"layerMm", &PrintProcess::layerMm},
    {"cornerRadiusMm", &PrintProcess::cornerRadiusMm},
    {"pocketRadiusMm", &PrintProcess::pocketRadiusMm},
    {"thinnestWallMm", &PrintProcess::thinnestWallMm},
    {"thinnestLineMm", &PrintProcess::thinnestLineMm},
    {"grooveMm", &PrintProcess::grooveMm},
    {"grainMm", &PrintProcess::grainMm},
    {"finestMm", &PrintProcess::finestMm},
};

PrintedViewRequest requestOf(const Json& order) {
  PrintedViewRequest request;
  for (const auto& [key, part] : kProcessParts) request.process.*part = order["process"][key];
  const Json& frame = order["frame"];
  request.frame = {vectorOf(frame["centre"]), vectorOf(frame["right"]), vectorOf(frame["up"]),
                   vectorOf(frame["normal"]), frame["eyeDistanceMm"]};
  request.symbol.size = order["modules"];
  request.symbol.dark = {request.symbol.size, request.symbol.size, order["dark"].get<std::vector<std::uint8_t>>()};
  request.symbolMm = order["symbolMm"];
  request.buildUp = vectorOf(order["buildUp"]);
  request.albedo = order["albedo"];
  const Json& mark = order["mark"];
  request.mark = static_cast<Mark>(mark["kind"].get<int>());
  request.markDepthMm = mark["depthMm"];
  request.ink = {mark["dark"], mark["light"]};
  request.label = {mark["label"], static_cast<LabelFrame>(mark["frame"].get<int>())};
  for (const Json& lamp : order["lamps"])
    request.lamps.push_back({lamp["azimuthDeg"], lamp["elevationDeg"], lamp["strength"]});
  return request;
}

}  // namespace

Json jsonOf(const PrintedViewRequest& request) {
  const ProjectionFrame& frame = request.frame;
  Json process;
  for (const auto& [key, part] : kProcessParts) process[key] = request.process.*part;
  Json lamps = Json::array();
  for (const DirectionalLight& lamp : request.lamps)
    lamps.push_back(
        {{"azimuthDeg", lamp.azimuthDeg}, {"elevationDeg", lamp.elevationDeg}, {"strength", lamp.strength}});
  return {{"process", std::move(process)},
          {"frame",
           {{"centre", jsonOf(frame.centre)},
            {"right", jsonOf(frame.right)},
            {"up", jsonOf(frame.up)},
            {"normal", jsonOf(frame.normal)},
            {"eyeDistanceMm", frame.eyeDistance}}},
          {"modules", request.symbol.size},
          {"dark", request.symbol.dark},
          {"symbolMm", request.symbolMm},
          {"buildUp", jsonOf(request.buildUp)},
          {"albedo", request.albedo},
          {"mark",
           {{"kind", static_cast<int>(request.mark)},
            {"depthMm", request.markDepthMm},
            {"dark", request.ink.dark},
            {"light", request.ink.light},
            {"label", request.label.text},
            {"frame", static_cast<int>(request.label.frame)}}},
          {"lamps", std::move(lamps)}};
}

std::string PrintedCode::start(std::vector<std::uint8_t> stl, const std::string& order) {
  const auto soup = readModel(std::exchange(stl, {}), "carved.stl");
  if (!soup) return answer(soup.error());
  auto mesh = meshAsFound(*soup, 1);
  if (!mesh) return answer(mesh.error());
  carved_ = std::move(*mesh);
  view_ = {};
  const Result<Json> parsed = parseJson(order);
  if (!parsed) return answer(parsed.error());
  const PrintedViewRequest request = requestOf(*parsed);
  modules_ = request.symbol.size;
  auto job = PrintedViewJob::create(carved_, request);
  if (!job) return answer(job.error());
  job_ = std::move(*job);
  return answer(job_->progress());
}

std::string PrintedCode::advance() {
  if (!job_) return answer(ErrorKind::BadUsage, message<"nothing-engraved">());
  const auto progress = job_->advance();
  if (!progress || progress->done) {
    carved_ = {};
    if (progress) view_ = job_->takeResult();
    job_.reset();
  }
  if (!progress) return answer(progress.error());
  if (!progress->done) return answer(*progress);
  Json misread = Json::array();
  for (std::size_t i = 0; i < view_.misread.size(); ++i)
    if (view_.misread[i] != 0) misread.push_back({static_cast<int>(i) / modules_, static_cast<int>(i) % modules_});
  Json said = Json::parse(answer(*progress));
  said["facingDeg"] = view_.facingDeg;
  said["misread"] = std::move(misread);
  return textOf(said);
}

std::vector<GreyImage> PrintedCode::pictures(const std::string& of) const {
  const ReaderView& seen = view_.seen;
  if (seen.luminance.empty()) return {};
  if (of == "front") return {seen.clean};
  assert(of == "reading");
  return frontalPictures(seen.luminance, seen.pixelsPerModule);
}

}  // namespace qrelief
