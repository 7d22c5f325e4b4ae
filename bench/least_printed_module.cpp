// SPDX-License-Identifier: GPL-3.0-or-later
// The least module that reads as printed, for every module pattern and finder pattern on a plate [Papp 2022, figure
// 11].
//
//     qrelief_least_module_table [PROCESS…]     fdm-0.4/0.2 and fdm-0.25/0.1
//
// Modules become smaller by a tenth until two sizes in a row do not read as printed; the least is the one before the
// first that does not. A print reads if at least two in five tries succeed (verification/frontal_reading.h). Version 2,
// contrast of the preset `balanced`, carved for the print that is looked at. Depth: mean over the carved submodules,
// mm, there.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "messages/sentences.h"
#include "native/egl_context.h"
#include "native/read_carving.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kLargestNozzles = 4, kSmallestNozzles = 0.6, kStep = 0.9;
constexpr int kVersion = 2, kModules = 25;

struct Least {
  double moduleMm = 0, depthMm = 0;  // 0: not even the largest reads
};

Result<Least> leastModule(const std::shared_ptr<const EngravableModel>& model, EngraveRequest request, BuildPose pose) {
  Least least;
  int failures = 0;
  request.buildUp.pose = pose;
  const double nozzle = request.printer.nozzleMm;
  for (double module = kLargestNozzles * nozzle; module > kSmallestNozzles * nozzle && failures < 2; module *= kStep) {
    request.placement.sizeMm = module * kModules;
    const auto carved = engrave(model, request);
    if (!carved) return tl::unexpected(carved.error());
    const auto printed = readPrinted(verifyRequestOf(request, *carved), carved->mesh, [](const Progress&) {});
    if (!printed) return tl::unexpected(printed.error());
    const bool reads = (*printed)->reading.count.enough();
    failures += !reads;
    if (reads && failures == 0) least = {module, summarise(carved->depths).meanMm};
  }
  return least;
}

int failed(const std::string& what, const Error& error) {
  fmt::print(stderr, "{}: {}\n", what, sentenceAndHint(error.message));
  return 1;
}

int run(std::vector<std::string> processes) {
  const auto context = EglContext::create();
  if (!context) return failed("EGL", context.error());
  if (processes.empty()) processes = {"fdm-0.4/0.2", "fdm-0.25/0.1"};
  auto prepared = prepareModel(shapes::soupOf(shapes::plate({60, 60}, 10, 4, 4)), {});
  if (!prepared) return failed("plate", prepared.error());
  const auto model = EngravableModel::upload(std::move(*prepared));
  fmt::print(
      "| process | modules | finders | lying: least module (mm) | depth | standing: least module (mm) | depth |\n"
      "|---|---|---|---|---|---|---|\n");
  for (std::size_t p = 0; p < namedPrinters().size(); ++p) {
    const NamedPrinter& named = namedPrinters()[p];
    if (std::find(processes.begin(), processes.end(), named.name) == processes.end()) continue;
    for (int pattern = 0; pattern < 5; ++pattern)
      for (int finder = 0; finder < 5; ++finder) {
        EngraveRequest request;
        request.carveFor = CarveFor::Print;
        request.text = "https://example.org/p/2026";
        request.symbol.version = kVersion;
        request.placement.centreMm = {0, 0, 0};
        request.placement.upHint = {0, 1, 0};
        request.placement.sizeMode = SizeMode::Fixed;
        request.modulePattern = static_cast<ModulePattern>(pattern);
        request.finderPattern = static_cast<FinderPattern>(finder);
        request.process = p;
        request.printer = named.printer;
        fmt::print("| {} | {} | {} |", named.name, modulePatternName(request.modulePattern),
                   finderPatternName(request.finderPattern));
        for (const BuildPose pose : {BuildPose::CodeUp, BuildPose::CodeUpright}) {
          const auto least = leastModule(model, request, pose);
          if (!least) return failed("plate", least.error());
          const auto shown = [&](double mm) { return least->moduleMm > 0 ? fmt::format("{:.2f}", mm) : "–"; };
          fmt::print(" {} | {} |", shown(least->moduleMm), shown(least->depthMm));
        }
        fmt::print("\n");
        std::fflush(stdout);
      }
  }
  return 0;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::run({argv + 1, argv + argc}); }
