// SPDX-License-Identifier: GPL-3.0-or-later
// Largest code at the eight models' centres for each way to find the direction [Papp 2022, figures 13 and 14]: at every
// rotation, upright, and turned by 45°. Edge of a symbol of version 3 without the quiet zone, which must fit, too.
#include "study/experiments/experiments.h"

namespace qrelief::study {
namespace {

constexpr double kLargestMm = 100;

Result<double> largestMm(StudyContext& context, const Row& key, SizeMode mode, double rotateDeg) {
  const auto model = context.model(key[0]);
  QRELIEF_TRY(model);
  auto request = context.usualRequest(key[0]);
  QRELIEF_TRY(request);
  PlacementRequest& place = request->placement;
  place.sizeMode = mode;
  place.maxSizeMm = kLargestMm;
  place.rotateDeg = rotateDeg;
  place.directionMethod = byName<DirectionMethod>(key[1], directionMethodName);
  const auto spot = findSpot(key[0], *model, *request);
  QRELIEF_TRY(spot);
  return spot->placement.symbolMm;
}

Result<Row> measure(const Row& key, StudyContext& context) {
  Row row;
  for (const auto& [mode, rotateDeg] :
       {std::pair(SizeMode::Free, 0.0), std::pair(SizeMode::Oriented, 0.0), std::pair(SizeMode::Oriented, 45.0)}) {
    const auto mm = largestMm(context, key, mode, rotateDeg);
    QRELIEF_TRY(mm);
    row.push_back(shown(*mm, 2));
  }
  return row;
}

}  // namespace

Experiment guaranteedSize() {
  Experiment experiment{
      "guaranteed_size", {"model", "direction"},   {"guaranteed_mm", "upright_mm", "turned_45_mm"}, {},
      measure,           dependingOn({kPlacement})};
  for (const std::string& model : StudyContext::models())
    for (int i = 0; i < 4; ++i)
      experiment.cases.push_back({model, directionMethodName(static_cast<DirectionMethod>(i))});
  return experiment;
}

}  // namespace qrelief::study
