// SPDX-License-Identifier: GPL-3.0-or-later
// Whether `engrave` and `verify` say the same of what was carved: reads, on pictures drawn by the GPU and traced.
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "base/progress.h"
#include "bench/centres.h"
#include "native/zxing_reader.h"
#include "pipeline/verify.h"
#include "settings/preset.h"
#include "verification/frontal_reading.h"

namespace qrelief {
namespace {

ReadingCount readAll(const ReaderView& seen, const std::string& text) {
  ReadingCount count;
  for (const GreyImage& picture : frontalPictures(seen.luminance, seen.clean.width, seen.pixelsPerModule))
    for (const SymbolReader& reader : zxingReaders()) {
      const auto read = reader(picture);
      ++count.tries;
      count.reads += read && !read->mirrored && read->text == text;
    }
  return count;
}

struct Case {
  ModulePattern pattern;
  FinderPattern finder;
  Preset preset;
  bool free = false;
};

int run(const GeometryPass&, const bench::TableArguments& arguments) {
  const std::array<Case, 6> cases = {{{ModulePattern::ThickPlus, FinderPattern::ThickPlusSharp, Preset::Balanced},
                                      {ModulePattern::ThickPlus, FinderPattern::ThickPlusSharp, Preset::Shallow, true},
                                      {ModulePattern::Square, FinderPattern::None, Preset::Shallow, true},
                                      {ModulePattern::Diamond, FinderPattern::None, Preset::Balanced, true},
                                      {ModulePattern::None, FinderPattern::ThickPlusSharp, Preset::Shallow},
                                      {ModulePattern::ThinPlus, FinderPattern::AsModules, Preset::Robust}}};
  fmt::print("case, symbol mm, drawn, traced\n");
  int number = 0;
  return bench::forEachCentre(
      arguments.folder, arguments.centresFile, arguments.kinds,
      [&](const std::shared_ptr<const EngravableModel>& model, const bench::Centre& centre) -> Status {
        for (std::size_t k = 0; k < cases.size(); ++k) {
          const Case& c = cases[k];
          EngraveRequest request;
          request.text = "HELLO";
          request.preset = c.preset;
          request.modulePattern = c.pattern;
          request.finderPattern = c.finder;
          request.placement.centreMm = centre.positionMm;
          request.placement.quietZone = !c.free;
          if (!c.free) request.placement.maxSizeMm = 20 + 5 * (number % 5);
          const auto result = engrave(model, request);
          if (!result) {
            fmt::print("{} {}: {}\n", centre.name, k, result.error().message.code);
            continue;
          }
          const ReadingCount drawn = readAll(result->readerView, request.text);
          VerifyRequest wanted;
          wanted.frame = result->placement.frame;
          wanted.symbolMm = result->placement.symbolMm;
          wanted.text = request.text;
          wanted.symbol = result->symbol;
          wanted.ranges = false;
          auto job = VerifyJob::create(result->mesh, wanted, zxingReaders());
          if (!job) return tl::unexpected(job.error());
          const auto verified = runToEnd(**job);
          if (!verified) return tl::unexpected(verified.error());
          fmt::print("{} {}: {:.1f} {} {:.3f} {:.3f}\n", centre.name, k, wanted.symbolMm, drawn.reads,
                     static_cast<double>(drawn.reads) / drawn.tries, verified->reading.share);
          std::fflush(stdout);
          ++number;
        }
        return {};
      });
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::bench::runTable(argc, argv, qrelief::run); }
