// SPDX-License-Identifier: GPL-3.0-or-later
// Compares `engrave` and `verify` on the same carvings: whether they decode, in pictures drawn by the GPU and in traced
// pictures. Finally prints the difference in decoded tries between drawn and traced pictures, on which isUndecided() is
// based.
#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "base/progress.h"
#include "bench/centres.h"
#include "native/read_carving.h"
#include "native/zxing_decoder.h"
#include "pipeline/verify.h"
#include "settings/preset.h"

namespace qrelief {
namespace {

constexpr int kNone = 1000;  // more than the number of tries

struct Case {
  ModulePattern pattern;
  FinderPattern finder;
  Preset preset;
  bool free = false;
};

int run(const bench::TableArguments& arguments) {
  const std::array<Case, 6> cases = {{{ModulePattern::ThickPlus, FinderPattern::ThickPlusSharp, Preset::Balanced},
                                      {ModulePattern::ThickPlus, FinderPattern::ThickPlusSharp, Preset::Shallow, true},
                                      {ModulePattern::Square, FinderPattern::None, Preset::Shallow, true},
                                      {ModulePattern::Diamond, FinderPattern::None, Preset::Balanced, true},
                                      {ModulePattern::None, FinderPattern::ThickPlusSharp, Preset::Shallow},
                                      {ModulePattern::ThinPlus, FinderPattern::AsModules, Preset::Robust}}};
  int number = 0, agreeing = 0, leastMore = kNone, mostMore = -kNone;
  const int status = bench::forEachCentre(
      arguments.folder, arguments.centresFile, arguments.kinds,
      [&](const std::shared_ptr<const EngravableModel>& model, const bench::Centre& centre) -> Status {
        for (std::size_t k = 0; k < cases.size(); ++k) {
          const Case& c = cases[k];
          EngraveRequest request;
          request.code.text = "HELLO";
          request.depth.preset = c.preset;
          request.code.modulePattern = c.pattern;
          request.code.finderPattern = c.finder;
          request.placement.centreMm = centre.positionMm;
          request.placement.quietZone = !c.free;
          if (!c.free) request.placement.maxSizeMm = 20 + 5 * (number % 5);
          const auto result = engrave(model, request);
          if (!result) {
            fmt::print("{} {}: {}\n", centre.name, k, result.error().message.code);
            continue;
          }
          const ReadingEvidence reading = readCarving(request, *result);
          VerifyRequest verification = verifyRequestOf(request, *result);
          verification.isTraced = true;
          auto job = VerifyJob::create(result->mesh, verification, zxingDecoders());
          QRELIEF_TRY(job);
          const auto verified = runToEnd(**job);
          QRELIEF_TRY(verified);
          const bool engraves = judge(request, *result, reading).passed(),
                     verifies = judge(verification, *verified).passed();
          agreeing += engraves == verifies;
          ++number;
          const int more = verified->reading.frontal.reads - reading.count.reads;
          leastMore = std::min(leastMore, more);
          mostMore = std::max(mostMore, more);
          fmt::print("{} {}: {:.1f} mm, engrave {} ({} of {}), verify --traced {} ({} of {}){}\n", centre.name, k,
                     verification.symbolMm, engraves, reading.count.reads, reading.count.tries, verifies,
                     verified->reading.frontal.reads, verified->reading.frontal.tries,
                     engraves == verifies ? "" : " DIFFER");
          std::fflush(stdout);
        }
        return {};
      });
  fmt::print("{} of {} results: engrave and verify agree\n", agreeing, number);
  if (number > 0) fmt::print("traced less lit: {} to {} tries\n", leastMore, mostMore);
  return status;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::bench::runTable(argc, argv, qrelief::run); }
