// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/experiments/chosen_settings.h"

#include "study/methods/break_up.h"
#include "study/methods/by_engine.h"
#include "study/methods/methods.h"

namespace qrelief::study {
namespace {

BuildDirection buildDirection(const std::string& pose, const ProjectionFrame& frame) {
  if (pose == kSlantedPose) return {.up = frame.normal + frame.up};
  return {.pose = byName<BuildPose>(pose, buildPoseName)};
}

Result<Row> measure(const Row& key, StudyContext& context) {
  const double moduleMm = std::stod(key[1]);
  const auto place = context.spotOfWidth(key[0], moduleMm);
  QRELIEF_TRY(place);
  StudyPlacement spot = **place;
  EngraveRequest& request = spot.request;
  request.print.buildUp = buildDirection(key[2], spot.placement.frame);
  request.depth.carveFor = CarveFor::Print;
  request.code.modulePattern = byName<ModulePattern>(key[3], modulePatternName);
  request.code.finderPattern = byName<FinderPattern>(key[4], finderPatternName);
  request.depth.contrast = std::stod(key[5]);
  request.depth.maxDepthMm = std::stod(key[6]) * moduleMm;
  auto symbol = symbolAtLevel(spot, *errorCorrectionByName(key[8]));
  QRELIEF_TRY(symbol);
  if (key[7] == "yes") breakUpDarkAreas(*symbol);
  const auto code = carveByEngine(spot, request, &*symbol);
  QRELIEF_TRY(code);
  (*place)->measured = spot.measured;
  const auto judged = context.judge(spot, *code);
  QRELIEF_TRY(judged);
  Row row = readingRow(*judged);
  row.push_back(shown(judged->depth.p95Mm, 3));
  row.push_back(shown(judged->depth.maxMm, 3));
  return row;
}

}  // namespace

Row ChosenSettings::key(const std::string& model, double moduleMm, const std::string& pose) const {
  return {model,
          shown(moduleMm, 1),
          pose,
          std::string(modulePatternName(modules)),
          std::string(finderPatternName(finders)),
          shown(contrast, 2),
          shown(maxDepthModules, 1),
          breakUpDarkAreas ? "yes" : "no",
          std::string(errorCorrectionName(level))};
}

Experiment chosenSettingsExperiment(const std::string& name) {
  Row measures = readingColumns();
  measures.emplace_back("depth_p95_mm");
  measures.emplace_back("depth_max_mm");
  return {name,
          {"model", "module_mm", "pose", "modules", "finders", "contrast", "max_depth_modules", "broken_up", "level"},
          measures,
          {},
          measure,
          dependingOn({kSearch, kLight, kPrint, kDecoding})};
}

}  // namespace qrelief::study
