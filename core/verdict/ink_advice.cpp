// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/ink_advice.h"

#include <cmath>

#include "message_codes/verdict.h"

namespace qrelief {
namespace {

constexpr double kRoundingMm = 1e-9;
constexpr double kOpaqueMm = 0.011;  // depths are multiples of 0.01 mm

}  // namespace

std::vector<Message> adviseInk(const Ink& ink) {
  std::vector<Message> advice;
  if (ink.isInverted()) advice.push_back(message<"code-inverted">());
  if (ink.contrast() < kGoodInkContrast)
    advice.push_back(message<"colours-alike">(with::number<"dark">(ink.dark), with::number<"light">(ink.light),
                                              with::number<"good">(kGoodInkContrast)));
  return advice;
}

std::vector<Message> adviseInkPrinting(const InkedCode& code) {
  std::vector<Message> advice;
  const double lineMm = lineWidthMm(code.printer);
  if (code.printer.technique != PrintTechnique::Filament)
    advice.push_back(message<"one-material-process">());
  else if (code.moduleMm < lineMm - kRoundingMm)
    advice.push_back(
        message<"modules-narrower-than-line">(with::lengthMm<"module">(code.moduleMm), with::lengthMm<"line">(lineMm)));
  if (code.mark == Mark::Inlay && code.depthMm < code.opaqueDepthMm - kOpaqueMm)
    advice.push_back(
        message<"inlay-not-opaque">(with::lengthMm<"depth">(code.depthMm),
                                    with::lengthMm<"needed">(std::ceil(100 * code.opaqueDepthMm - 1e-6) / 100)));
  return advice;
}

double nozzleForInk(double moduleMm, const Printer& printer) {
  return printer.lineWidthMm ? 0 : moduleMm / lineWidthMm(printer) * printer.nozzleMm;
}

}  // namespace qrelief
