// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes determine a model and a request (tests/support/engrave_case.h). The whole pipeline runs with small symbols,
// and the oracle judges the outcome.
#include "fuzz/check.h"
#include "native/egl_context.h"
#include "support/engrave_oracle.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  static const Result<std::unique_ptr<EglContext>> context = EglContext::create();
  fuzz::require(context.has_value(), "there is a GL context");
  Choices choices(fuzz::bytesOf(data, size));
  EngraveCase engraveCase = makeEngraveCase(choices);
  if (engraveCase.mesh.triangles.size() > 1500) return -1;
  engraveCase.request.code.text.resize(1);
  engraveCase.request.code.symbol.version.reset();
  engraveCase.request.depth.contrast = std::min(engraveCase.request.depth.contrastAsked(), 0.05);
  const OracleVerdict verdict = runEngraveCase(engraveCase);
  fuzz::require(verdict.fault.empty(), engraveCase.describe() + ": " + verdict.kind + ": " + verdict.fault);
  return 0;
}
