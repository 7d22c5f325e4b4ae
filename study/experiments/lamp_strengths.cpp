// SPDX-License-Identifier: GPL-3.0-or-later
// Depth on a plate carved for one lamp, by the lamp's elevation and strength, and decoded tries under that lamp, with
// the published steps. Shows what decides whether lamps make codes deeper or shallower [Papp 2022, figure
// 21]: the paper gives neither elevation nor strength. The lamp is at the symbol's top; a strength of 1 equals the
// sky's.
#include "study/experiments/experiments.h"
#include "study/lamp_reading.h"
#include "study/methods/by_engine.h"

namespace qrelief::study {
namespace {

constexpr double kAzimuthDeg = 90;

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto spot = context.usualSpot("plate");
  QRELIEF_TRY(spot);
  const auto modules = byName<ModulePattern>(key[0], modulePatternName);
  EngraveRequest request = publishedRequest(
      **spot, modules, modules == ModulePattern::None ? FinderPattern::None : FinderPattern::ThickPlus);
  request.depth.lights = {
      {.azimuthDeg = kAzimuthDeg, .elevationDeg = std::stod(key[1]), .strength = std::stod(key[2])}};
  const auto code = carveByEngine(**spot, request);
  QRELIEF_TRY(code);
  const auto reads = readsUnder(**spot, *code, request.depth.lights);
  QRELIEF_TRY(reads);
  return Row{shown(summarise(code->depths).meanMm, 3), std::to_string(code->limited), std::to_string(*reads)};
}

}  // namespace

Experiment lampStrengths() {
  Experiment experiment{"lamp_strengths",
                        {"modules", "elevation", "strength"},
                        {"depth_mm", "limited", "reads"},
                        {},
                        measure,
                        dependingOn({kSearch, kLight, kLamps, kDecoding})};
  for (const char* modules : {"none", "square"})
    for (const char* elevation : {"8", "20", "33", "50", "70"})
      for (const char* strength : {"0.25", "0.5", "1", "2", "4"})
        experiment.cases.push_back({modules, elevation, strength});
  return experiment;
}

}  // namespace qrelief::study
