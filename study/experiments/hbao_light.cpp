// SPDX-License-Identifier: GPL-3.0-or-later
// Horizon-based ambient occlusion against path tracing: error of its luminance in the carved submodules of one carving
// on a plate, by radius, angle bias, directions and steps. The method `papp-2022` carves the plate, whatever the
// parameters. Shows which parameters estimate the light best; the paper publishes none [Papp 2022, §7 and §8].
// HbaoOptions has the parameters with the least mean absolute error over both carvings: 0.043. More directions and
// steps find more horizons. The light is then too dark, because it lacks reflections.
//
// Error: own − traced, 1 = an unoccluded surface. Traced with 64 paths a submodule, seed 1, with reflected light. The
// pass runs on the CPU and by a shader; shader_difference is the mean size of the difference between their luminances.
#include <cmath>
#include <map>

#include "base/clock.h"
#include "study/experiments/experiments.h"
#include "study/light_error.h"
#include "study/methods/by_engine.h"
#include "study/methods/literal_2022.h"

namespace qrelief::study {
namespace {

constexpr const char* kModel = "plate";

/// The carving to light, and its light by path tracing.
struct Carving {
  CarvedCode code;
  std::vector<double> traced;
};

Result<const Carving*> carvingOf(const StudyPlacement& spot, const std::string& modulesName) {
  static std::map<std::string, Carving> known;  // by module pattern
  if (const auto it = known.find(modulesName); it != known.end()) return &it->second;
  const auto modules = byName<ModulePattern>(modulesName, modulePatternName);
  const EngraveRequest request =
      publishedRequest(spot, modules, modules == ModulePattern::None ? FinderPattern::None : FinderPattern::ThickPlus);
  auto code = carveByEngine(spot, request);
  QRELIEF_TRY(code);
  auto traced = tracedLuminance(spot, *code);
  QRELIEF_TRY(traced);
  return &known.emplace(modulesName, Carving{std::move(*code), std::move(*traced)}).first->second;
}

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto spot = context.usualSpot(kModel);
  QRELIEF_TRY(spot);
  const auto carving = carvingOf(**spot, key[0]);
  QRELIEF_TRY(carving);
  const CellLayout layout{(*spot)->symbol.size};
  HbaoOptions options;
  options.radiusModules = std::stod(key[1]);
  options.angleBiasDeg = std::stod(key[2]);
  options.directions = std::stoi(key[3]);
  options.steps = std::stoi(key[4]);
  HbaoLight light(cellHeights(**spot),
                  {layout.cells() / CellLayout::kN,
                   (*spot)->placement.moduleMm,
                   static_cast<float>((*spot)->request.marking.surfaceAlbedo()),
                   {}},
                  options);
  const DepthField& depths = (*carving)->code.depths;
  std::vector<float> depthsMm(static_cast<std::size_t>(layout.cells()) * static_cast<std::size_t>(layout.cells()));
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t i : carvedOf((*carving)->code.mask)) {
    cells.push_back(layout.ofSymbol(static_cast<int>(i) / depths.size, static_cast<int>(i) % depths.size));
    depthsMm[cells.back()] = static_cast<float>(depths.depthMm[i]);
  }
  const auto start = Clock::now();
  const std::vector<float> luminance = light.luminance(cells, depthsMm, 0);
  const double ms = millisecondsSince(start);
  QRELIEF_TRY(light.useShader());
  light.luminance(cells, depthsMm, 0);  // compiles it for the graphics processor
  const auto again = Clock::now();
  const std::vector<float> byShader = light.luminance(cells, depthsMm, 0);
  const double shaderMs = millisecondsSince(again);
  double difference = 0;
  for (const std::uint32_t cell : cells)
    difference += std::abs(static_cast<double>(byShader[cell] - luminance[cell])) / static_cast<double>(cells.size());
  std::vector<double> own;
  for (const std::uint32_t cell : cells) own.push_back(static_cast<double>(luminance[cell]));
  const LightError error = lightErrorOf(own, (*carving)->traced);
  return Row{shown(error.mean, 3), shown(error.meanSize, 3), shown(difference, 4), shown(ms, 1), shown(shaderMs, 1)};
}

}  // namespace

Experiment hbaoLight() {
  Experiment experiment{"hbao_light",
                        {"modules", "radius_modules", "bias_deg", "directions", "steps"},
                        {"light_error", "light_error_size", "shader_difference", "pass_ms", "shader_pass_ms"},
                        {},
                        measure,
                        dependingOn({kSearch, kHbao})};
  for (const char* modules : {"none", "square"}) {
    for (const char* radius : {"1", "2", "4", "8"})
      for (const char* bias : {"0", "15", "30"}) experiment.cases.push_back({modules, radius, bias, "8", "6"});
    for (const char* radius : {"2", "4"})
      for (const char* bias : {"0", "15"}) {
        experiment.cases.push_back({modules, radius, bias, "4", "4"});
        experiment.cases.push_back({modules, radius, bias, "16", "16"});
      }
  }
  return experiment;
}

}  // namespace qrelief::study
