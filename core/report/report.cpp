// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report.h"

#include <fmt/format.h>

#include "base/version.h"
#include "delivery/second_colour.h"
#include "io/three_mf/source.h"
#include "math/angle.h"
#include "pipeline/engrave.h"
#include "pipeline/label_pockets.h"
#include "projection/flatness.h"
#include "qr/codewords.h"
#include "report/json_parts.h"
#include "settings/preset.h"
#include "verification/grades.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the bounding box of the 3MF item that a body belongs to; the model's, if it comes from no 3MF file.
Box3 boxOfItem(const PreparedModel& model, std::size_t body) {
  if (!model.source) return boundingBox(model.mesh);
  Box3 box;
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t)
    if (model.source->runs[model.mesh.body(t)].item == model.source->runs[body].item)
      for (int k = 0; k < 3; ++k) box.add(model.mesh.corner(t, k));
  return box;
}

Json describeInput(const EngravableModel& model, const EngraveResult& result, const ReportContext& context) {
  Json warnings = Json::array();
  for (const Finding& finding : model.prepared.findings)
    if (finding.severity != Finding::Severity::Note)
      warnings.push_back(describeMessage(finding.message, context.wording));
  const Box3 box = boundingBox(model.prepared.mesh);
  return {{"file", context.fileName},
          {"format", context.format},
          {"triangles", model.prepared.mesh.triangles.size()},
          {"vertices", model.prepared.mesh.positions.size()},
          {"scaleToMm", context.scaleToMm},
          {"sizeMm", triple(box.size())},
          {"lowMm", triple(boxOfItem(model.prepared, result.carvedBody).min)},
          {"buildUp", triple(glm::normalize(result.request.print.buildUp.resolve(result.placement.frame)))},
          {"warnings", warnings}};
}

const char* solverName(const EngraveRequest& request) {
  if (request.isForOneLight()) return "one-light";
  return request.depth.solver == ContrastSolver::Fast ? "fast" : "paper-steps";
}

Json describeSymbol(const Symbol& symbol) {
  Json rows = Json::array();
  for (int row = 0; row < symbol.size; ++row) {
    std::string text;
    for (int column = 0; column < symbol.size; ++column) text += symbol.isDark(row, column) ? '1' : '0';
    rows.push_back(text);
  }
  Json json = {{"version", symbol.version},
               {"ecc", errorCorrectionName(symbol.errorCorrection)},
               {"mask", symbol.mask},
               {"modules", symbol.size},
               {"correctableCodewords", blockStructure(symbol.version, symbol.errorCorrection).correctable()},
               {"rows", rows}};
  if (symbol.hasEci) json["eci"] = 26;
  return json;
}

Json describeProjection(const EngraveRequest& request, const Placement& placement) {
  Json iterations = Json::array();
  for (const DirectionIteration& i : placement.iterations)
    iterations.push_back({{"normal", triple(i.normal)},
                          {"varianceMm2", i.varianceMm2},
                          {"outsideShare", i.outsideFraction},
                          {"worstAngleDeg", toDegrees(i.worstAngle)},
                          {"measure", i.measure}});
  const char* method = request.placement.direction ? "given" : directionMethodName(request.placement.directionMethod);
  return {
      {"method", method},
      {"centre", triple(placement.frame.centre)},
      {"normal", triple(placement.frame.normal)},
      {"up", triple(placement.frame.up)},
      {"eyeDistanceMm", placement.frame.eyeDistance},
      {"bendMm", placement.bendMm},
      {"aimToleranceDeg", request.code.isText() ? Json() : Json(aimToleranceDeg(placement.bendMm, placement.moduleMm))},
      {"iterations", iterations}};
}

/// Describes the cost of the second colour. Waste is null where the printer changes no filaments.
Json describeColour(const EngraveResult& result) {
  const SecondColour second = secondColourOf(result);
  const ColourCost& cost = second.cost;
  Json colour = {{"layers", cost.layers},  {"changes", cost.changes}, {"secondG", cost.secondG},
                 {"firstWasteG", nullptr}, {"secondWasteG", nullptr}, {"wasteMinutes", nullptr},
                 {"towerG", nullptr}};
  if (second.isPriced) {
    colour["firstWasteG"] = cost.firstWasteG;
    colour["secondWasteG"] = cost.secondWasteG;
    colour["wasteMinutes"] = cost.wasteMinutes;
    colour["towerG"] = cost.towerG;
  }
  return colour;
}

/// Describes the label or the text alone as carved; null without either.
Json describeLabel(const LabelOptions& label, const EngraveResult& result) {
  if (label.empty()) return nullptr;
  const auto capitalMm = capitalMmOf(result);
  return {{"text", label.text},
          {"frame", labelFrameName(label.frame)},
          {"depthMm", result.label.depthMm},
          {"capitalMm", capitalMm ? Json(*capitalMm) : Json()},
          {"strokeMm", capitalMm ? Json(thinnestStroke() * *capitalMm) : Json()}};
}

/// Describes the decoding of a code. Of a text alone nothing is decoded.
Json describeReading(const EngraveRequest& request, const ReportContext& context) {
  if (request.code.isText()) return {{"decoded", nullptr}, {"views", Json::array()}};
  const ReadingEvidence& reading = context.reading;
  return {{"decoded", context.verdict.reads.passed()},
          {"text", reading.text},
          {"reader", context.reader},
          {"tries", reading.count.tries},
          {"reads", reading.count.reads},
          {"readsNeeded", reading.count.needed()},
          {"views", Json::array({{{"light", request.lamps().empty() ? "sky" : "sky+lights"},
                                  {"tiltDeg", 0},
                                  {"picture", "simulated phone"},
                                  {"tries", reading.count.tries},
                                  {"reads", reading.count.reads},
                                  {"read", context.verdict.reads.passed()}}})}};
}

/// Adds the grades of the luminance that the depth search ended with, not of a picture.
void addGrades(Json& verification, const EngraveRequest& request, const EngraveResult& result) {
  GradeReports grades = describeGrades(gradesOf(request, result));
  verification["iso15415"] = std::move(grades.iso15415);
  verification["iso29158"] = std::move(grades.iso29158);
}

Json patternMaskOf(const EngraveRequest& request) {
  return request.code.ownPattern ? Json(moduleMaskText(*request.code.ownPattern)) : Json(nullptr);
}

/// Describes the pockets of a code without a second colour.
Json describeDepth(const EngraveRequest& request, const EngraveResult& result, const ReportContext& context) {
  const DepthSummary depth = summarise(result.depths);
  Json json = {{"meanMm", depth.meanMm},
               {"maxMm", depth.maxMm},
               {"p95Mm", depth.p95Mm},
               {"iterations", result.searchIterations},
               {"limitedSubmodules", result.limitedSubmodules},
               {"unfinishedSubmodules", result.unfinishedSubmodules},
               {"patternMask", patternMaskOf(request)},
               {"features", describeFeatures(featuresOf(result), request.print.printer)},
               {"objective", depthObjectiveName(request.depth.objective)},
               {"lights", describeLights(request.lamps())},
               {"carvedFor", request.isForPrint() ? "print" : "design"},
               {"solver", solverName(request)},
               {"contrast", result.request.depth.contrastAsked()}};
  if (!request.depth.contrast) {
    json["preset"] = presetName(request.depth.preset);
    json["askedPreset"] = presetName(context.askedPreset.value_or(request.depth.preset));
  }
  return json;
}

/// Describes the pockets of an inlay; a painted code has none.
Json describeInlay(const EngraveResult& result) {
  const DepthSummary depth = summarise(result.depths);
  return {{"meanMm", depth.meanMm},
          {"maxMm", depth.maxMm},
          {"p95Mm", depth.p95Mm},
          {"opaqueMm", result.opaqueDepthMm},
          {"modulesLeftOut", result.modulesLeftOut}};
}

Json describeDepthOfText(const EngraveResult& result) {
  const DepthSummary depth = pocketDepths(result);
  return {{"meanMm", depth.meanMm}, {"maxMm", depth.maxMm}, {"p95Mm", depth.p95Mm}};
}

Json describeTried(const ReportContext& context) {
  Json tried = Json::array();
  for (const TriedCarving& one : context.tried) {
    Json changes = Json::array();
    for (const SettingChange& change : one.changes)
      changes.push_back({{"setting", change.setting}, {"value", change.value}});
    const auto counted = [](const std::optional<ReadingCount>& count) {
      return count ? Json{{"tries", count->tries}, {"reads", count->reads}} : Json();
    };
    tried.push_back({{"changes", changes},
                     {"offered", one.isOffer},
                     {"delivered", static_cast<int>(tried.size()) == context.delivered},
                     {"centre", one.centreMm ? triple(*one.centreMm) : Json()},
                     {"symbolMm", one.symbolMm > 0 ? Json(one.symbolMm) : Json()},
                     {"design", counted(one.reads)},
                     {"print", counted(one.printed)},
                     {"passed", one.passed},
                     {"failure", one.failure ? describeMessage(*one.failure, context.wording) : Json()}});
  }
  return tried;
}

/// Returns the warnings about printing, without regard to a simulated print.
std::vector<Message> printingWarnings(const EngraveRequest& request, const EngraveResult& result,
                                      const ReportContext& context) {
  const Aspect prints = judge(request, result, context.reading).prints;
  return prints.level == Level::Good ? std::vector<Message>() : prints.reasons;
}

}  // namespace

std::string makeReport(const EngraveRequest& request, const EngravableModel& model, const EngraveResult& result,
                       const ReportContext& context) {
  const SolidityReport& solid = result.solidity;
  Json report;
  report["qrelief"] = kVersion;
  const bool isText = request.code.isText();
  report["text"] = request.code.text;
  report["content"] = contentName(request.code.content);
  report["input"] = describeInput(model, result, context);
  report["symbol"] = isText ? Json() : describeSymbol(result.symbol);
  report["projection"] = describeProjection(request, result.placement);
  report["size"] = {{"symbolMm", result.placement.symbolMm},
                    {"moduleMm", isText ? Json() : Json(result.placement.moduleMm)},
                    {"guaranteedMm", result.placement.guaranteedMm},
                    {"rotationDeg", result.placement.rotationDeg},
                    {"mode", sizeModeName(request.placement.sizeMode)}};
  addMark(report, request.marking.mark, result.markDepthMm, request.marking.ink());
  report["depth"] = isText                         ? describeDepthOfText(result)
                    : request.marking.isInColour() ? describeInlay(result)
                                                   : describeDepth(request, result, context);
  report["label"] = describeLabel(request.code.lettering(), result);
  report["mesh"] = {{"surface", surfaceModeName(request.surface())},
                    {"triangles", solid.triangles},
                    {"vertices", solid.vertices},
                    {"keptTriangles", result.keptTriangles},
                    {"bodies", result.bodies.size()},
                    {"carvedBody", result.carvedBody + 1},
                    {"carvedBodyName", result.bodies[result.carvedBody].name},
                    {"closed", solid.closed()},
                    {"manifold", solid.manifold()},
                    {"selfIntersections", solid.selfIntersections},
                    {"newSelfIntersections", solid.selfIntersections - result.inheritedSelfIntersections},
                    {"inheritedSelfIntersections", result.inheritedSelfIntersections},
                    {"volumeMm3", solid.volumeMm3}};
  report["colour"] = describeColour(result);
  report["tried"] = describeTried(context);
  report["verification"] = describeReading(request, context);
  report["verification"]["printed"] = describePrinted(context.printed);
  report["verification"]["failedChecks"] = describeMessages(context.verdict.failed(), context.wording);
  report["verification"]["verdict"] = describeVerdict(context.verdict, context.wording);
  if (!isText) addGrades(report["verification"], request, result);
  report["verification"]["printability"] =
      describeMessages(printingWarnings(request, result, context), context.wording);
  report["timingsMs"] = {{"load", context.loadMs}, {"prepare", context.prepareMs}};
  for (const auto& [stage, ms] : result.timingsMs.all()) report["timingsMs"][stage] = ms;
  report["timingsMs"]["write"] = context.writeMs;
  report["timingsMs"]["total"] = context.totalMs;
  if (context.spotMs > 0) report["timingsMs"]["spot"] = context.spotMs;
  report["gl"] = {{"renderer", result.litByShaders ? context.gl.renderer : gl::kProcessorName},
                  {"version", result.litByShaders ? context.gl.version : ""}};
  // Text that is not UTF-8 (a file name, say) must not make the report fail.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace qrelief
