// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/text_verdict.h"

#include <cmath>

#include "math/angle.h"
#include "message_codes/verdict.h"
#include "pipeline/engrave.h"
#include "pipeline/label_pockets.h"
#include "printing/build_direction.h"
#include "verdict/ink_advice.h"
#include "verdict/print_words.h"
#include "verdict/remedies.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

/// Smallest height of capitals in technical drawings [ISO 3098-1].
constexpr double kLegibleMm = 1.8;
constexpr double kRoundingMm = 1e-6;

double strokeMm(const EngraveResult& result) { return thinnestStroke() * capitalMmOf(result).value_or(0); }

bool facesDown(const EngraveRequest& request, const EngraveResult& result) {
  if (!request.print.process) return false;
  const ProjectionFrame& frame = result.placement.frame;
  const Vec3 up = glm::normalize(request.print.buildUp.resolve(frame));
  return glm::dot(up, frame.normal) < std::cos(toRadians(kSteepestOverhangDeg));
}

/// Returns reasons why strokes that are wide enough may still print badly.
std::vector<Message> adviseStrokes(const EngraveRequest& request, const EngraveResult& result) {
  const Printer& printer = request.print.printer;
  std::vector<Message> advice;
  if (facesDown(request, result)) advice.push_back(message<"faces-down">());
  if (request.marking.isInColour()) {
    // Strokes take the place of modules, and are judged by themselves.
    for (Message& one : adviseInkPrinting(
             {request.marking.mark, lineWidthMm(printer), result.markDepthMm, result.opaqueDepthMm, printer}))
      advice.push_back(std::move(one));
  } else if (result.label.depthMm < kLabelLayers * printer.layerMm - kRoundingMm) {
    advice.push_back(message<"text-shallow">(with::lengthMm<"depth">(result.label.depthMm)));
  }
  return advice;
}

}  // namespace

Aspect judgeLegibility(const EngraveRequest& request, const EngraveResult& result) {
  const double capital = capitalMmOf(result).value_or(0);
  const bool isLarge = capital >= kLegibleMm - kRoundingMm;
  Aspect aspect;
  aspect.level = isLarge ? Level::Good : Level::Barely;
  aspect.summary =
      isLarge ? message<"text-reads">(with::lengthMm<"capital">(capital), with::lengthMm<"stroke">(strokeMm(result)))
              : message<"text-hard-to-read">(with::lengthMm<"capital">(capital));
  aspect.reasons.push_back(message<"text-reads-because">(with::lengthMm<"least">(kLegibleMm)));
  if (!isLarge) aspect.remedies = textRemedies(request, result, kLegibleMm / capital, false);
  return aspect;
}

Aspect judgeStrokes(const EngraveRequest& request, const EngraveResult& result) {
  const Printer& printer = request.print.printer;
  const double stroke = strokeMm(result), finest = finestStrokeMm(printer);
  const auto because =
      message<"text-prints-because">(with::lengthMm<"stroke">(stroke), with::lengthMm<"finest">(finest));
  Aspect aspect;
  if (stroke < finest - kRoundingMm) {
    aspect.level = Level::Bad;
    aspect.summary = message<"text-prints-not">(with::cause<"printing">(printing(printer)));
    aspect.failed.push_back(
        message<"text-too-fine">(with::lengthMm<"stroke">(stroke), with::lengthMm<"finest">(finest)));
    aspect.reasons = aspect.failed;
    aspect.remedies = textRemedies(request, result, finest / stroke, true);
    return aspect;
  }
  aspect.reasons = adviseStrokes(request, result);
  if (aspect.reasons.empty()) {
    aspect.summary = message<"text-prints">(with::cause<"printing">(printing(printer)));
    aspect.reasons.push_back(because);
  } else {
    aspect.level = Level::Barely;
    aspect.summary = message<"text-may-not-print">(with::cause<"printing">(printing(printer)));
    aspect.remedies = {anotherSpot()};
  }
  return aspect;
}

}  // namespace qrelief
