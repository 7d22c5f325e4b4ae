// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/read_carving.h"

#include <cmath>

#include "native/zxing_reader.h"

namespace qrelief {

VerifyRequest verifyRequestOf(const EngraveRequest& request, const EngraveResult& result) {
  VerifyRequest wanted;
  wanted.frame = result.placement.frame;
  wanted.symbolMm = result.placement.symbolMm;
  wanted.text = request.text;
  wanted.symbol = result.symbol;
  wanted.printer = {request.nozzleMm, request.layerMm};
  wanted.minWallMm = request.minWallMm;
  wanted.albedo = std::round(1e6 * static_cast<double>(request.albedo)) / 1e6;  // as it was given: a float of it is not
  wanted.ranges = false;
  wanted.inheritedSelfIntersections = result.inheritedSelfIntersections;
  return wanted;
}

Result<ReadingEvidence> readCarving(const EngraveRequest& request, const EngraveResult& result,
                                    const std::function<void(const Progress&)>& progress) {
  const ReadingEvidence drawn = evidenceOf(readFrontal(result.readerView), request.text);
  if (!isUndecided(drawn)) return drawn;
  auto job = VerifyJob::create(result.mesh, verifyRequestOf(request, result), zxingReaders());
  if (!job) return tl::unexpected(job.error());
  for (;;) {
    const auto step = (*job)->advance();
    if (!step) return tl::unexpected(step.error());
    progress(*step);
    if (step->done) break;
  }
  const ReadingSummary traced = (*job)->takeResult().reading;
  return ReadingEvidence{traced.frontal, traced.frontal.reads > 0 ? request.text : traced.otherText, true};
}

}  // namespace qrelief
