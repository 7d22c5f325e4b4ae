// SPDX-License-Identifier: GPL-3.0-or-later
// A code carved for the sky and one lamp, decoded under the sky and a lamp at a higher or lower elevation [Papp 2022,
// figure 22], on a plate, with the published steps. The lamp is at the symbol's top and as strong as the sky.
//
// Angles are elevations over the code. The paper measures between the light's direction and the normal: 98° is a lamp
// 8° over the code, 123° a lamp 33° over it. `sky` means no lamp.
#include "study/experiments/experiments.h"
#include "study/lamp_reading.h"
#include "study/methods/by_engine.h"
#include "study/methods/literal_2022.h"

namespace qrelief::study {
namespace {

constexpr double kAzimuthDeg = 90, kStrength = 1;

std::vector<DirectionalLight> lampAt(const std::string& elevation) {
  if (elevation == "sky") return {};
  return {{.azimuthDeg = kAzimuthDeg, .elevationDeg = std::stod(elevation), .strength = kStrength}};
}

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto spot = context.usualSpot("plate");
  QRELIEF_TRY(spot);
  const auto modules = byName<ModulePattern>(key[0], modulePatternName);
  EngraveRequest request = publishedRequest(
      **spot, modules, modules == ModulePattern::None ? FinderPattern::None : FinderPattern::ThickPlus);
  request.depth.lights = lampAt(key[1]);
  const auto code = carveBySearch(key[3], **spot, request);
  QRELIEF_TRY(code);
  const auto reads = readsUnder(**spot, *code, lampAt(key[2]));
  QRELIEF_TRY(reads);
  return Row{shown(summarise(code->depths).meanMm, 3), std::to_string(*reads)};
}

}  // namespace

Experiment lightAngles() {
  Experiment experiment{"light_angles",
                        {"modules", "carved_at", "read_at", "search"},
                        {"depth_mm", "reads"},
                        {},
                        measure,
                        [](const Row& key) {
                          return versionOfSearch(key[3], {kLight, kDecoding});
                        }};
  for (const char* modules : {"none", "square"})
    for (const char* carved : {"sky", "8", "33"})
      for (const char* read : {"4", "8", "15", "23", "33", "38", "48", "63", "78", "88"})
        for (const char* search : {kPublishedSearch, kLiteralSearch})
          experiment.cases.push_back({modules, carved, read, search});
  return experiment;
}

}  // namespace qrelief::study
