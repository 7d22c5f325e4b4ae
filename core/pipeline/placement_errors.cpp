// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/placement_errors.h"

#include <cmath>

#include "math/round_down.h"
#include "message_codes/pipeline.h"
#include "message_codes/place.h"
#include "projection/size_bound.h"

namespace qrelief {
namespace {

double downToHundredths(double mm) { return std::floor(mm * 100) / 100; }

/// Rounds a size down as messages show it: of a code that hardly fits at all, to 0.
double sizeShown(double mm) { return mm < 0.01 ? 0 : downToThreeDigits(mm); }

auto inFile(const NoRoom& room) { return with::place<"at">(*room.crossing / room.model.scaleToMm); }

double leastMm(const NoRoom& room) { return kMinModuleMm * room.modules; }

}  // namespace

Message codeInWords(const PlacementRequest& request) {
  if (request.sizeMode != SizeMode::Fixed) return request.isText ? message<"any-text">() : message<"any-code">();
  if (request.isText) return message<"text-alone">(with::lengthMm<"size">(request.sizeMm));
  if (request.quietZone) return message<"code-with-quiet-zone">(with::lengthMm<"size">(request.sizeMm));
  return message<"code-alone">(with::lengthMm<"size">(request.sizeMm));
}

Error crossingAtCentre(const NoRoom& room, Vec3 centre) {
  return {ErrorKind::NoSolution,
          message<"crossing-at-centre">(with::lengthMm<"distance">(glm::distance(*room.crossing, centre)), inFile(room),
                                        with::lengthMm<"least">(leastMm(room)))};
}

Error tooSmallAsAsked(const NoRoom& room, double symbolMm) {
  const auto size = with::lengthMm<"size">(symbolMm);
  const auto least = with::lengthMm<"least">(leastMm(room));
  if (room.request.isText) return {ErrorKind::NoSolution, message<"text-too-small-as-asked">(size, least)};
  return {ErrorKind::NoSolution,
          message<"modules-too-small-as-asked">(size, with::lengthMm<"module">(symbolMm / room.modules), least)};
}

Error tooSmallHere(const NoRoom& room, double symbolMm) {
  const auto size = with::lengthMm<"size">(sizeShown(symbolMm));
  const auto advice = with::cause<"advice">(roomAdvice(
      room.model, {room.modules, roomFactor(room.modules, room.request)}, room.request.eyeDistanceMm,
      room.crossing ? message<"choose-a-spot-off-crossings">(inFile(room)) : message<"choose-a-wider-spot">()));
  if (room.request.isText)
    return {ErrorKind::NoSolution,
            message<"text-too-small-here">(size, with::lengthMm<"least">(leastMm(room)), advice)};
  const auto module = with::lengthMm<"module">(sizeShown(symbolMm / room.modules));
  return {ErrorKind::NoSolution, message<"modules-too-small-here">(size, module, advice)};
}

Error tooLarge(const NoRoom& room, const FittingSizes& fitting) {
  const auto code = with::cause<"code">(codeInWords(room.request));
  const auto here = with::lengthMm<"here">(downToThreeDigits(fitting.hereMm));
  const auto everywhere = with::lengthMm<"everywhere">(downToThreeDigits(fitting.everywhereMm));
  const auto bestTurn = with::number<"bestTurn">(fitting.turnedDeg);
  const auto turned = with::lengthMm<"turned">(downToThreeDigits(fitting.turnedMm));
  const auto advice = with::cause<"advice">(room.crossing ? message<"choose-smaller-or-off-crossings">(inFile(room))
                                                          : message<"choose-smaller-or-wider">());
  const bool turningHelps = downToHundredths(fitting.turnedMm) > downToHundredths(fitting.hereMm);
  if (!turningHelps) return {ErrorKind::NoSolution, message<"code-too-large">(code, here, everywhere, advice)};
  if (fitting.turnedMm < room.request.sizeMm)
    return {ErrorKind::NoSolution, message<"code-too-large-here">(code, here, bestTurn, turned, everywhere, advice)};
  return {ErrorKind::NoSolution, message<"code-fits-turned">(code, here, bestTurn, turned, everywhere)};
}

}  // namespace qrelief
