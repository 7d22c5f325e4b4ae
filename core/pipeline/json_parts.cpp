// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/json_parts.h"

#include <cmath>

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

Json describeAdvice(const std::vector<PrintAdvice>& advice) {
  Json list = Json::array();
  for (const PrintAdvice& one : advice) list.push_back({{"problem", one.problem}, {"hint", one.hint}});
  return list;
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
