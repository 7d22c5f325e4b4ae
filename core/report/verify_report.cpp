// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/verify_report.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/parse_json.h"
#include "base/version.h"
#include "message_codes/pipeline.h"
#include "qr/codewords.h"
#include "report/json_parts.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

Vec3 vectorFrom(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

DirectionalLight lampFrom(const Json& json) {
  return {json.at("azimuthDeg").get<double>(), json.at("elevationDeg").get<double>(),
          json.at("strength").get<double>()};
}

const char* nameOf(SymbolPose pose) {
  switch (pose) {
    case SymbolPose::AsWanted:
      return "as wanted";
    case SymbolPose::Turned90:
      return "turned by 90°";
    case SymbolPose::Turned180:
      return "turned by 180°";
    case SymbolPose::Turned270:
      return "turned by 270°";
    case SymbolPose::Mirrored:
      return "mirrored";
    case SymbolPose::None:
      break;
  }
  return "not found";
}

/// Reads mark and materials; reports of older versions have none. Throws the exceptions of nlohmann's accessors.
Status readMark(const Json& report, VerifyRequest& request) {
  const auto name = report.value("mark", std::string(markName(Mark::Shadow)));
  for (const Mark mark : {Mark::Shadow, Mark::Inlay, Mark::Paint}) {
    if (name != markName(mark)) continue;
    request.mark = mark;
    request.albedo = report.value("albedo", MarkRequest{.mark = mark}.surfaceAlbedo());
    if (mark == Mark::Shadow) return {};
    request.markDepthMm = report.at("markDepthMm").get<double>();
    request.darkReflectance = report.at("darkReflectance").get<double>();
    return {};
  }
  return badInput(message<"report-mark">(with::term<"found">(name)));
}

/// Reads the label; its frame is none if its name is unknown. Throws the exceptions of nlohmann's accessors.
LabelOptions labelFrom(const Json& report) {
  const auto label = report.find("label");
  if (label == report.end() || label->is_null()) return {};
  LabelOptions read = {label->at("text").get<std::string>()};
  for (const LabelFrame frame : {LabelFrame::Rounded, LabelFrame::Square})
    if (label->at("frame") == labelFrameName(frame)) read.frame = frame;
  return read;
}

/// Reads the symbol. Throws the exceptions of nlohmann's accessors.
Result<Symbol> symbolFrom(const Json& symbol, const std::string& text) {
  const auto level = errorCorrectionByName(symbol.at("ecc").get<std::string>());
  if (!level) return badInput(message<"report-ecc">());
  auto encoded = encodeSymbol(text, {.errorCorrection = *level,
                                     .version = symbol.at("version").get<int>(),
                                     .maskRule = MaskRule::Fixed,
                                     .mask = symbol.at("mask").get<int>(),
                                     .eci = symbol.contains("eci") ? EciUse::Auto : EciUse::Never});
  QRELIEF_TRY(encoded);
  return withModules(std::move(*encoded), symbol.at("rows").get<std::vector<std::string>>());
}

/// Reads the request. Throws the exceptions of nlohmann's accessors.
Result<VerifyRequest> readRequest(const Json& report) {
  VerifyRequest request;
  request.text = report.at("text").get<std::string>();
  const Json& projection = report.at("projection");
  request.frame = makeFrame(vectorFrom(projection.at("centre")), vectorFrom(projection.at("normal")),
                            vectorFrom(projection.at("up")), projection.at("eyeDistanceMm").get<double>());
  request.symbolMm = report.at("size").at("symbolMm").get<double>();
  QRELIEF_TRY(readMark(report, request));
  request.label = labelFrom(report);
  request.label.isAlone = report.value("content", std::string()) == contentName(Content::Text);
  auto symbol = request.isText() ? Result<Symbol>(blankSymbol()) : symbolFrom(report.at("symbol"), request.text);
  QRELIEF_TRY(symbol);
  request.symbol = std::move(*symbol);
  if (const auto depth = report.find("depth"); depth != report.end()) {
    for (const Json& lamp : depth->value("lights", Json::array())) request.lamps.push_back(lampFrom(lamp));
    request.needsLamp = depth->value("objective", std::string()) == depthObjectiveName(DepthObjective::OneLight) &&
                        !request.lamps.empty();
  }
  const Json& input = report.at("input");
  request.lowMm = vectorFrom(input.at("lowMm"));
  request.buildUp = vectorFrom(input.at("buildUp"));
  if (const auto mesh = report.find("mesh"); mesh != report.end())
    request.inheritedSelfIntersections = mesh->value("inheritedSelfIntersections", std::size_t{0});
  return request;
}

Json describeViews(const std::vector<ReadingView>& views) {
  Json list = Json::array();
  for (const ReadingView& view : views)
    list.push_back({{"test", readingTestName(view.test)},
                    {"light", view.lamp ? "sky+lamp" : "sky"},
                    {"tiltDeg", view.tiltDeg},
                    {"azimuthDeg", view.azimuthDeg},
                    {"pixelsPerModule", view.pixelsPerModule},
                    {"blurModules", view.blurModules},
                    {"noise", view.noise},
                    {"exposure", view.exposure},
                    {"tries", view.tries},
                    {"reads", view.reads},
                    {"read", view.read()}});
  return list;
}

Json numberOrNull(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

/// Describes the pictures that were decoded, and the ranges found by them. Of a text alone nothing is decoded.
Json describePictures(const VerifyRequest& request, const VerifyResult& result, const VerifyReportContext& context) {
  if (request.isText()) return {{"decoded", nullptr}};
  const ReadingSummary& reading = result.reading;
  return {{"decoded", reading.frontal.enough()},
          {"text", reading.frontal.reads > 0 ? request.text : reading.otherText},
          {"reader", context.reader},
          {"tries", reading.frontal.tries},
          {"reads", reading.frontal.reads},
          {"readsNeeded", reading.frontal.needed()},
          {"tiltDeg", {{"sky", numberOrNull(reading.tiltDeg)}, {"sky+lamp", numberOrNull(reading.tiltDegLamp)}}},
          {"pixelsPerModule", numberOrNull(reading.pixelsPerModule)},
          {"blurModules", numberOrNull(reading.blurModules)},
          {"cornerErrorModules", numberOrNull(reading.cornerErrorModules)}};
}

Json describeReading(const VerifyRequest& request, const VerifyResult& result, const VerifyReportContext& context) {
  Json json = describePictures(request, result, context);
  json["printed"] = describePrinted(context.printed);
  if (result.grades) {
    GradeReports grades = describeGrades(*result.grades);
    json["iso15415"] = std::move(grades.iso15415);
    json["iso29158"] = std::move(grades.iso29158);
  }
  json["printability"] = describeMessages(
      context.verdict.prints.level == Level::Good ? std::vector<Message>() : context.verdict.prints.reasons,
      context.wording);
  json["views"] = describeViews(result.views);
  json["verdict"] = describeVerdict(context.verdict, context.wording);
  return json;
}

std::size_t differingModules(const Symbol& symbol, const Symbol& wanted) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < wanted.dark.size(); ++i) count += symbol.dark[i] != wanted.dark[i];
  return count;
}

/// Returns true if decoders can restore the wanted symbol: they have its fixed patterns, and error correction restores
/// the data modules that differ.
bool decodesAs(const Symbol& symbol, const Symbol& wanted) {
  const CodewordLayout layout = layoutCodewords(wanted);
  std::vector<std::uint8_t> isWrong(layout.blockOfCodeword.size(), 0);
  for (std::size_t i = 0; i < wanted.dark.size(); ++i) {
    if (symbol.dark[i] == wanted.dark[i]) continue;
    if (wanted.roles[i] != ModuleRole::Data) return false;
    if (const int codeword = layout.codewordOfModule[i]; codeword >= 0) isWrong[static_cast<std::size_t>(codeword)] = 1;
  }
  std::vector<int> wrong(static_cast<std::size_t>(layout.structure.blocks), 0);
  for (std::size_t c = 0; c < isWrong.size(); ++c)
    wrong[static_cast<std::size_t>(layout.blockOfCodeword[c])] += isWrong[c];
  return std::all_of(wrong.begin(), wrong.end(), [&](int count) { return count <= layout.structure.correctable(); });
}

}  // namespace

Result<Symbol> withModules(Symbol symbol, const std::vector<std::string>& rows) {
  const Symbol wanted = symbol;
  const auto size = static_cast<std::size_t>(symbol.size);
  Grid<std::uint8_t> flipped(symbol.size, symbol.size);
  if (rows.size() != size)
    return badInput(message<"report-rows">(with::count<"rows">(rows.size()), with::count<"wanted">(size)));
  for (std::size_t row = 0; row < size; ++row) {
    if (rows[row].size() != size || rows[row].find_first_not_of("01") != std::string::npos)
      return badInput(message<"report-row">(with::index<"row">(row + 1), with::count<"wanted">(size)));
    for (std::size_t column = 0; column < size; ++column) {
      const bool dark = rows[row][column] == '1';
      flipped[row * size + column] = symbol.dark[row * size + column] && !dark;
      symbol.dark[row * size + column] = dark;
    }
  }
  if (!decodesAs(symbol, wanted))
    return badInput(message<"report-no-code">(
        with::count<"count">(differingModules(symbol, wanted)), with::index<"version">(symbol.version),
        with::term<"level">(errorCorrectionName(symbol.errorCorrection)), with::count<"mask">(symbol.mask)));
  if (std::find(flipped.begin(), flipped.end(), 1) != flipped.end()) symbol.flipped = std::move(flipped);
  return symbol;
}

Result<VerifyRequest> requestFromReport(std::string_view json) {
  const Result<Json> report = parseJson(json);
  if (!report) return badInput(message<"report-not-understood">(with::cause<"problem">(report.error().message)));
  try {
    return readRequest(*report);
  } catch (const Json::exception& error) {
    std::string problem = error.what();  // "[json.exception.out_of_range.403] key 'size' not found"
    problem.erase(0, problem.find(' ') + 1);
    return badInput(message<"report-not-understood">(with::term<"problem">(problem)));
  }
}

std::string makeVerifyReport(const VerifyRequest& request, const VerifyResult& result,
                             const VerifyReportContext& context) {
  const SolidityReport& solid = result.solidity;
  Json report;
  report["qrelief"] = kVersion;
  report["text"] = request.text;
  report["verified"] = context.verdict.passed();
  report["failedChecks"] = describeMessages(context.verdict.failed(), context.wording);
  report["input"] = {{"file", context.fileName}, {"format", context.format}};
  report["projection"] = {{"centre", triple(request.frame.centre)},
                          {"normal", triple(request.frame.normal)},
                          {"up", triple(request.frame.up)},
                          {"eyeDistanceMm", request.frame.eyeDistance}};
  report["size"] = {{"symbolMm", request.symbolMm},
                    {"moduleMm", request.isText() ? Json() : Json(request.symbolMm / request.symbol.size)}};
  report["mesh"] = {
      {"triangles", solid.triangles},
      {"vertices", solid.vertices},
      {"solid", solid.solid()},
      {"closed", solid.closed()},
      {"manifold", solid.manifold()},
      {"selfIntersections", solid.selfIntersections},
      {"inheritedSelfIntersections", std::min(request.inheritedSelfIntersections, solid.selfIntersections)},
      {"volumeMm3", solid.volumeMm3},
      {"findings", Json::array()}};
  for (const SolidityFinding& finding : solid.findings())
    report["mesh"]["findings"].push_back({{"problem", describeMessage(finding.message, context.wording)},
                                          {"at", finding.at ? triple(*finding.at) : Json(nullptr)}});
  addMark(report, request.mark, request.markDepthMm, request.ink());
  if (request.mark == Mark::Shadow && !request.isText())
    report["carving"] = {{"pose", nameOf(result.profile.pose)},
                         {"fit", result.profile.fit},
                         {"meanDepthMm", result.profile.meanDepthMm}};
  if (result.features) report["carving"]["features"] = describeFeatures(*result.features, request.printer);
  report["lights"] = describeLights(request.lamps);
  report["verification"] = describeReading(request, result, context);
  report["timingsMs"] = {{"total", context.totalMs}};
  // Text that is not UTF-8 (a file name, say) must not make the report fail.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace qrelief
