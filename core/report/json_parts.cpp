// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_parts.h"

#include <cmath>

#include "base/message_json.h"
#include "verification/ink.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

Json describeGrade(const Grade& grade) { return {{"value", grade.value}, {"grade", grade.grade}}; }

Json lengthOrNull(double mm) { return std::isfinite(mm) ? Json(mm) : Json(nullptr); }

}  // namespace

GradeReports describeGrades(const SymbolGrades& grades) {
  const Json common = {{"simulated", true},
                       {"decode", describeGrade(grades.decode)},
                       {"unusedErrorCorrection", describeGrade(grades.unusedCorrection)},
                       {"fixedPatternDamage", describeGrade(grades.fixedPatternDamage)},
                       {"formatInformation", describeGrade(grades.formatInformation)}};
  GradeReports reports{common, common};
  reports.iso15415["symbolContrast"] = describeGrade(grades.symbolContrast);
  reports.iso15415["modulation"] = describeGrade(grades.modulation);
  reports.iso15415["reflectanceMargin"] = describeGrade(grades.reflectanceMargin);
  reports.iso15415["overall"] = grades.iso15415;
  reports.iso29158["cellContrast"] = describeGrade(grades.cellContrast);
  reports.iso29158["cellModulation"] = describeGrade(grades.cellModulation);
  reports.iso29158["overall"] = grades.iso29158;
  return reports;
}

Json describeMessage(const Message& message, const Wording& wording) {
  Json json = jsonOf(message);
  if (!wording.sentence) return json;
  json["message"] = wording.sentence(message);
  json["hint"] = wording.hint(message);
  return json;
}

Json describeMessages(const std::vector<Message>& messages, const Wording& wording) {
  Json list = Json::array();
  for (const Message& message : messages) list.push_back(describeMessage(message, wording));
  return list;
}

Json describeAspect(const Aspect& aspect, const Wording& wording) {
  Json remedies = Json::array();
  for (const Remedy& remedy : aspect.remedies) {
    Json one = describeMessage(remedy.message, wording);
    for (const SettingChange& change : remedy.changes)
      one["changes"].push_back({{"setting", change.setting}, {"value", change.value}});
    remedies.push_back(std::move(one));
  }
  return {{"level", levelName(aspect.level)},
          {"passed", aspect.passed()},
          {"summary", describeMessage(aspect.summary, wording)},
          {"warnings", describeMessages(aspect.warnings, wording)},
          {"reasons", describeMessages(aspect.reasons, wording)},
          {"remedies", std::move(remedies)}};
}

Json describeVerdict(const Verdict& verdict, const Wording& wording) {
  return {{"passed", verdict.passed()},
          {"reads", describeAspect(verdict.reads, wording)},
          {"prints", describeAspect(verdict.prints, wording)},
          {"solid", describeAspect(verdict.solid, wording)}};
}

Json describeLights(const std::vector<DirectionalLight>& lights) {
  Json list = Json::array();
  for (const DirectionalLight& light : lights)
    list.push_back(
        {{"azimuthDeg", light.azimuthDeg}, {"elevationDeg", light.elevationDeg}, {"strength", light.strength}});
  return list;
}

Json describePrinted(const std::optional<PrintedEvidence>& printed) {
  if (!printed) return nullptr;
  const ReadingCount& count = printed->reading.count;
  return {{"process", printed->process}, {"facingDeg", printed->facingDeg},  {"tries", count.tries},
          {"reads", count.reads},        {"readsNeeded", printed->needed()}, {"read", printed->enough()}};
}

void addMark(Json& report, Mark mark, double markDepthMm, const Ink& ink) {
  report["mark"] = markName(mark);
  report["albedo"] = ink.light;
  if (mark == Mark::Shadow) return;
  report["markDepthMm"] = markDepthMm;
  report["darkReflectance"] = ink.dark;
}

Json describeFeatures(const CarvedFeatures& features, const Printer& printer) {
  return {{"nozzleMm", printer.nozzleMm},
          {"layerMm", printer.layerMm},
          {"pattern", features.pattern ? Json(modulePatternName(*features.pattern)) : Json(nullptr)},
          {"moduleMm", features.moduleMm},
          {"pocketMm", features.pocketMm},
          {"gapMm", lengthOrNull(features.gapMm)},
          {"meanDepthMm", features.meanDepthMm},
          {"meanDepthLayers", features.meanDepthMm / printer.layerMm},
          {"leastDepthMm", features.leastDepthMm},
          {"leastDepthLayers", features.leastDepthMm / printer.layerMm},
          {"wallMm", features.wallMm ? Json(*features.wallMm) : Json(nullptr)}};
}

}  // namespace qrelief
