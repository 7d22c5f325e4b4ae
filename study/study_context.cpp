// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_context.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "carving/embed.h"
#include "io/read_model.h"
#include "native/files.h"
#include "native/read_carving.h"
#include "native/zxing_decoder.h"
#include "pipeline/verify.h"
#include "support/shapes.h"

namespace qrelief::study {
namespace {

constexpr int kVersion = 3;

struct Generated {
  const char* name;
  Vec3 centreMm;
  Mesh (*make)();
};

const std::vector<Generated>& generated() {
  static const std::vector<Generated> kAll = {{"plate",
                                               {0, 0, 0},
                                               [] {
                                                 return shapes::plate({60, 60}, 25, 4, 4);
                                               }},
                                              {"cylinder", {30, 0, 0}, [] { return shapes::cylinder(30, 90, 128); }}};
  return kAll;
}

}  // namespace

const std::vector<std::string>& StudyContext::models() {
  static const std::vector<std::string> kNames = {"plate", "pyramid", "cylinder",     "saddle",
                                                  "star",  "vase",    "bumpy-sphere", "bunny"};
  return kNames;
}

Result<Vec3> StudyContext::centreOf(const std::string& modelName) {
  for (const Generated& one : generated())
    if (modelName == one.name) return one.centreMm;
  if (centres_.empty()) {
    const auto bytes = readFile(samplesFolder_ + "/manifest.json");
    QRELIEF_TRY(bytes);
    for (const auto& sample : nlohmann::json::parse(*bytes)) {
      const auto& at = sample["centreMm"];
      centres_[sample["id"]] = {at[0].get<double>(), at[1].get<double>(), at[2].get<double>()};
    }
  }
  return centres_.at(modelName);
}

Result<std::shared_ptr<const EngravableModel>> StudyContext::model(const std::string& name, double scale) {
  const std::string key = name + " " + std::to_string(scale);
  if (const auto known = models_.find(key); known != models_.end()) return known->second;
  PolygonSoup soup;
  const auto result =
      std::find_if(generated().begin(), generated().end(), [&](const Generated& g) { return name == g.name; });
  if (result != generated().end()) {
    soup = shapes::soupOf(result->make());
  } else {
    const std::string file = name + ".stl";
    const auto bytes = readFile(samplesFolder_ + "/" + file);
    QRELIEF_TRY(bytes);
    auto read = readModel(*bytes, file);
    QRELIEF_TRY(read);
    soup = std::move(*read);
  }
  auto prepared = prepareModel(soup, {.scaleToMm = scale});
  QRELIEF_TRY(prepared);
  return models_[key] = EngravableModel::upload(std::move(*prepared));
}

Result<EngraveRequest> StudyContext::usualRequest(const std::string& modelName) {
  const auto centre = centreOf(modelName);
  QRELIEF_TRY(centre);
  EngraveRequest request;
  request.code.text = kText;
  request.code.symbol.version = kVersion;
  request.placement.centreMm = *centre;
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = kUsualModuleMm * (17 + 4 * kVersion);
  request.depth.keepPreset = true;
  request.print.buildUp.pose = BuildPose::CodeUp;
  return request;
}

Result<const StudyPlacement*> StudyContext::spotFor(const std::string& modelName, const EngraveRequest& request,
                                                    double scale, const std::string& key) {
  if (const auto known = spots_.find(key); known != spots_.end()) return &known->second;
  auto loaded = model(modelName, scale);
  QRELIEF_TRY(loaded);
  auto spot = findSpot(modelName, *loaded, request);
  QRELIEF_TRY(spot);
  return &spots_.emplace(key, std::move(*spot)).first->second;
}

Result<const StudyPlacement*> StudyContext::usualSpot(const std::string& modelName, DirectionMethod direction) {
  auto request = usualRequest(modelName);
  QRELIEF_TRY(request);
  request->placement.directionMethod = direction;
  return spotFor(modelName, *request, 1, modelName + " " + directionMethodName(direction));
}

Result<const StudyPlacement*> StudyContext::spotOfWidth(const std::string& modelName, double moduleMm,
                                                        DirectionMethod direction) {
  auto request = usualRequest(modelName);
  QRELIEF_TRY(request);
  const double scale = moduleMm / kUsualModuleMm;
  request->placement.sizeMm *= scale;
  request->placement.centreMm *= scale;
  request->placement.directionMethod = direction;
  return spotFor(modelName, *request, scale,
                 fmt::format("{} {} {}", modelName, moduleMm, directionMethodName(direction)));
}

DepthSummary depthOf(const CarvedCode& code) {
  DepthField masked = code.depths;
  for (std::size_t i = 0; i < masked.depthMm.size(); ++i)
    if (!code.mask[i]) masked.depthMm[i] = 0;
  return summarise(masked);
}

Result<Judged> StudyContext::judge(const StudyPlacement& spot, const CarvedCode& code) const {
  Judged judged;
  const std::vector<double>& depths = code.depths.depthMm;
  for (const double depth : depths) judged.removedMm += depth / static_cast<double>(depths.size());
  judged.depth = depthOf(code);
  const auto carved =
      embedDepthField(spot.model->prepared.mesh, spot.placement.frame, spot.placement.patch.triangles, code.depths);
  QRELIEF_TRY(carved);
  EngraveResult result;
  result.placement = spot.placement;
  result.symbol = code.symbol;
  VerifyRequest request = verifyRequestOf(spot.request, result);
  request.ranges = false;
  if (code.readUnder) request.lamps = {*code.readUnder};
  auto job = VerifyJob::create(carved->mesh, request, zxingDecoders());
  QRELIEF_TRY(job);
  const auto verified = runToEnd(**job);
  QRELIEF_TRY(verified);
  judged.designed = verified->reading.frontal;
  const auto printed = readPrinted(request, carved->mesh, [](const Progress&) {});
  QRELIEF_TRY(printed);
  if (*printed) judged.printed = (*printed)->reading.count;
  return judged;
}

}  // namespace qrelief::study
