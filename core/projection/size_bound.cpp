// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/size_bound.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "message_codes/place.h"

namespace qrelief {
namespace {

constexpr double kSmallMm = 30;  // larger models are rarely meant in another unit

double largestMm(const SizeBound& room, const Box3& boxMm, double eyeDistanceMm) {
  return squareBoundMm(boxMm, eyeDistanceMm) / room.outer;
}

}  // namespace

double squareBoundMm(const Box3& boxMm, double eyeDistanceMm) {
  const double diagonal = boxMm.diagonal();
  if (diagonal >= eyeDistanceMm) return std::numeric_limits<double>::infinity();
  return diagonal / (1 - diagonal / eyeDistanceMm) / std::numbers::sqrt2;
}

Message roomAdvice(const PreparedModel& model, const SizeBound& room, double eyeDistanceMm, Message otherwise) {
  const Box3 box = boundingBox(model.mesh);
  const Vec3 size = box.size();
  if (std::max({size.x, size.y, size.z}) >= kSmallMm) return otherwise;
  std::vector<UnitSuggestion> units = suggestUnits(size, model.scaleToMm);
  std::erase_if(units, [&](const UnitSuggestion& unit) {
    const double factor = unit.scaleToMm / model.scaleToMm;
    return largestMm(room, {box.min * factor, box.max * factor}, eyeDistanceMm) < room.minSymbolMm();
  });
  if (units.empty()) return otherwise;
  return model.unitSuggestions.empty() ? message<"shorter-text-or-unit">(with::cause<"advice">(unitAdvice(units)))
                                       : unitAdvice(units);
}

Status checkSizeBound(const PreparedModel& model, const SizeBound& room, double eyeDistanceMm) {
  const Box3 box = boundingBox(model.mesh);
  const double most = largestMm(room, box, eyeDistanceMm);
  if (most >= room.minSymbolMm()) return {};
  return fail(ErrorKind::NoSolution,
              message<"model-too-small">(
                  with::extentMm<"size">(box.size()), with::count<"modules">(room.modules),
                  with::lengthMm<"least">(room.minSymbolMm()), with::lengthMm<"module">(kMinModuleMm),
                  with::lengthMm<"most">(most),
                  with::cause<"advice">(roomAdvice(model, room, eyeDistanceMm, message<"scale-up-or-shorten">()))));
}

}  // namespace qrelief
