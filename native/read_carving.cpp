// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/read_carving.h"

#include "native/zxing_decoder.h"
#include "pipeline/engrave.h"
#include "pipeline/printed_view.h"

namespace qrelief {

ReadingEvidence readCarving(const EngraveRequest& request, const EngraveResult& result) {
  if (result.readerView.luminance.empty()) return {};  // a text alone
  return evidenceOf(readFrontal(result.readerView), request.code.text);
}

Result<std::optional<PrintedEvidence>> readPrinted(const VerifyRequest& request, const Mesh& carved,
                                                   const std::function<void(const Progress&)>& progress) {
  const auto order = printedViewOf(request);
  QRELIEF_TRY(order);
  if (!*order) return std::nullopt;
  auto job = PrintedViewJob::create(carved, **order);
  QRELIEF_TRY(job);
  QRELIEF_TRY(advanceToEnd(**job, progress));
  const PrintedView view = (*job)->takeResult();
  return PrintedEvidence{evidenceOf(readFrontal(view.seen), request.text),
                         std::string(namedPrinters()[*request.process].name), view.facingDeg};
}

}  // namespace qrelief
