// SPDX-License-Identifier: GPL-3.0-or-later
// Smallest module that decodes as printed, for every module pattern and finder pattern, two nozzles, lying and
// standing, on a plate [Papp 2022, figure 11].
//
// Modules shrink by a tenth until two sizes in a row do not decode as printed; the smallest is the last size before the
// first failure. A print decodes if at least two in five tries succeed (verification/frontal_reading.h). Version 2,
// contrast of the preset `balanced`, carved for the simulated print. Depth: mean over the carved submodules.
#include "native/read_carving.h"
#include "pipeline/verify.h"
#include "study/experiments/experiments.h"

namespace qrelief::study {
namespace {

constexpr double kLargestNozzles = 4, kSmallestNozzles = 0.6, kStep = 0.9;
constexpr int kVersion = 2, kModules = 25;

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto plate = context.model("plate");
  QRELIEF_TRY(plate);
  EngraveRequest request;
  request.depth.carveFor = CarveFor::Print;
  request.code.text = "https://example.org/p/2026";
  request.code.symbol.version = kVersion;
  request.placement.upHint = {0, 1, 0};
  request.placement.sizeMode = SizeMode::Fixed;
  for (std::size_t i = 0; i < namedPrinters().size(); ++i)
    if (namedPrinters()[i].name == key[0])
      request.print.process = i, request.print.printer = namedPrinters()[i].printer;
  request.code.modulePattern = byName<ModulePattern>(key[1], modulePatternName);
  request.code.finderPattern = byName<FinderPattern>(key[2], finderPatternName);
  request.print.buildUp.pose = byName<BuildPose>(key[3], buildPoseName);

  double leastMm = 0, depthMm = 0;
  int failures = 0;
  const double nozzle = request.print.printer.nozzleMm;
  for (double module = kLargestNozzles * nozzle; module > kSmallestNozzles * nozzle && failures < 2; module *= kStep) {
    request.placement.sizeMm = module * kModules;
    const auto carved = engrave(*plate, request);
    QRELIEF_TRY(carved);
    const auto printed = readPrinted(verifyRequestOf(request, *carved), carved->mesh, [](const Progress&) {});
    QRELIEF_TRY(printed);
    const bool reads = (*printed)->reading.count.enough();
    failures += !reads;
    if (reads && failures == 0) leastMm = module, depthMm = summarise(carved->depths).meanMm;
  }
  if (leastMm == 0) return Row{"", ""};  // not even the largest decodes
  return Row{shown(leastMm, 3), shown(depthMm, 3)};
}

}  // namespace

Experiment leastModule() {
  Experiment experiment{"least_module", {"process", "modules", "finders", "pose"},        {"module_mm", "depth_mm"}, {},
                        measure,        dependingOn({kSearch, kLight, kPrint, kDecoding})};
  for (const char* process : {"fdm-0.4/0.2", "fdm-0.25/0.1"})
    for (int pattern = 0; pattern < 5; ++pattern)
      for (int finder = 0; finder < 5; ++finder)
        for (const BuildPose pose : {BuildPose::CodeUp, BuildPose::CodeUpright})
          experiment.cases.push_back({process, std::string(modulePatternName(static_cast<ModulePattern>(pattern))),
                                      std::string(finderPatternName(static_cast<FinderPattern>(finder))),
                                      std::string(buildPoseName(pose))});
  return experiment;
}

}  // namespace qrelief::study
