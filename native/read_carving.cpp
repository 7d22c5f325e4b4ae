// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/read_carving.h"

#include <cmath>
#include <utility>

#include "native/zxing_reader.h"
#include "pipeline/printed_view.h"

namespace qrelief {
namespace {

template <class Job>
auto runTelling(Job& job, const std::function<void(const Progress&)>& tell) -> Result<decltype(job.takeResult())> {
  for (;;) {
    const auto progress = job.advance();
    if (!progress) return tl::unexpected(progress.error());
    tell(*progress);
    if (progress->done) return job.takeResult();
  }
}

/// Half of what `verify` traces: that changed no count by more than 6 of 72 tries, over 34 carvings of shared models.
constexpr int kFewPaths = 8;
constexpr double kMostOtherwise = 1.0 / 8;  // of the tries, with few paths

/// Of pictures whose light is traced.
Result<ReadingEvidence> readTraced(VerifyRequest wanted, const Mesh& carved,
                                   const std::function<void(const Progress&)>& progress) {
  const std::string text = wanted.text;
  auto job = VerifyJob::create(carved, std::move(wanted), zxingReaders());
  if (!job) return tl::unexpected(job.error());
  const auto verified = runTelling(**job, progress);
  if (!verified) return tl::unexpected(verified.error());
  const ReadingSummary& traced = verified->reading;
  return ReadingEvidence{traced.frontal, traced.frontal.reads > 0 ? text : traced.otherText, true};
}

}  // namespace

Result<ReadingEvidence> readCarving(const EngraveRequest& request, const EngraveResult& result,
                                    const std::function<void(const Progress&)>& progress) {
  const ReadingEvidence drawn = evidenceOf(readFrontal(result.readerView), request.text);
  if (!isUndecided(drawn)) return drawn;
  VerifyRequest wanted = verifyRequestOf(request, result);
  wanted.isReadingOnly = true;
  const int paths = std::exchange(wanted.paths, kFewPaths);
  const auto few = readTraced(wanted, result.mesh, progress);
  if (!few) return few;
  const ReadingCount& count = few->count;
  if (std::abs(count.reads - count.needed()) > kMostOtherwise * count.tries) return few;
  wanted.paths = paths;
  return readTraced(std::move(wanted), result.mesh, progress);
}

Result<std::optional<PrintedEvidence>> readPrinted(const VerifyRequest& request, const Mesh& carved,
                                                   const std::function<void(const Progress&)>& progress) {
  const auto wanted = printedViewOf(request);
  if (!wanted) return tl::unexpected(wanted.error());
  if (!*wanted) return std::nullopt;
  auto job = PrintedViewJob::create(carved, **wanted);
  if (!job) return tl::unexpected(job.error());
  const auto view = runTelling(**job, progress);
  if (!view) return tl::unexpected(view.error());
  return PrintedEvidence{evidenceOf(readFrontal(view->seen), request.text, true),
                         std::string(namedPrinters()[*request.process].name), view->facingDeg};
}

}  // namespace qrelief
