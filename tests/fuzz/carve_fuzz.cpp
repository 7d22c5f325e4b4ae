// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes determine a model, a request and made-up depths. Everything runs except the rendering, so it runs many
// times as often as engrave_fuzz.
#include "fuzz/check.h"
#include "support/engrave_oracle.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  Choices choices(fuzz::bytesOf(data, size));
  EngraveCase engraveCase = makeEngraveCase(choices);
  if (engraveCase.mesh.triangles.size() > 1500) return -1;
  engraveCase.request.code.text.resize(1);
  engraveCase.request.code.symbol.version.reset();
  const OracleVerdict verdict = runCarvingCase(engraveCase, choices);
  fuzz::require(verdict.fault.empty(), engraveCase.describe() + ": " + verdict.kind + ": " + verdict.fault);
  return 0;
}
