// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of blur, distance and tilt for a carved code, by module pattern and finder pattern [Papp 2022, §8], with the
// published steps and our default, on a plate, a cylinder and the bumpy sphere. Pictures and decoders are the same as
// in `verify` (verification/reading_sweep.h); a value is empty if the code does not decode even from nearby in front.
#include "native/zxing_decoder.h"
#include "pipeline/verify.h"
#include "study/carved_surface.h"
#include "study/experiments/experiments.h"
#include "study/methods/by_engine.h"
#include "study/methods/literal_2022.h"

namespace qrelief::study {
namespace {

std::string shownIfAny(const std::optional<double>& value, int decimals) {
  return value ? shown(*value, decimals) : std::string();
}

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto spot = context.usualSpot(key[0]);
  QRELIEF_TRY(spot);
  const auto modules = byName<ModulePattern>(key[2], modulePatternName);
  const auto finders = byName<FinderPattern>(key[3], finderPatternName);
  EngraveRequest request = publishedRequest(**spot, modules, finders);
  if (key[1] == "ours") {
    request = (*spot)->request;
    request.code.modulePattern = modules;
    request.code.finderPattern = finders;
  }
  const auto code = carveBySearch(key[1], **spot, request);
  QRELIEF_TRY(code);
  const auto surface = CarvedSurface::make(**spot, code->depths);
  QRELIEF_TRY(surface);
  EngraveResult result;
  result.placement = (*spot)->placement;
  result.symbol = code->symbol;
  VerifyRequest verification = verifyRequestOf(request, result);
  verification.ranges = true;
  auto job = VerifyJob::create(surface->mesh(), verification, zxingDecoders());
  QRELIEF_TRY(job);
  const auto verified = runToEnd(**job);
  QRELIEF_TRY(verified);
  const ReadingSummary& reading = verified->reading;
  return Row{shown(summarise(code->depths).meanMm, 3), std::to_string(reading.frontal.reads),
             shownIfAny(reading.blurModules, 2),       shownIfAny(reading.pixelsPerModule, 1),
             shownIfAny(reading.tiltDeg, 0),           shownIfAny(reading.tiltDegLamp, 0)};
}

}  // namespace

Experiment robustness() {
  Experiment experiment{"robustness",
                        {"model", "search", "modules", "finders"},
                        {"depth_mm", "designed", "blur_modules", "pixels_per_module", "tilt_deg", "tilt_lamp_deg"},
                        {},
                        measure,
                        [](const Row& key) {
                          return versionOfSearch(key[1], {kLight, kDecoding});
                        }};
  for (const char* model : {"plate", "cylinder", "bumpy-sphere"}) {
    const auto add = [&](const char* search) {
      experiment.cases.push_back({model, search, "none", "none"});
      for (const char* modules : {"square", "thin-plus", "diamond", "thick-plus"})
        for (const char* finders : {"diamond", "thick-plus"})
          experiment.cases.push_back({model, search, modules, finders});
    };
    add(kPublishedSearch);
    experiment.cases.push_back({model, "ours", "thick-plus", "thick-plus-sharp"});
    add(kLiteralSearch);
  }
  return experiment;
}

}  // namespace qrelief::study
