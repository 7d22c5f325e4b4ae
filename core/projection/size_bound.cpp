// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/size_bound.h"

#include <limits>
#include <numbers>

namespace qrelief {
namespace {

/// Returns the advice for a model that is too small: tiny models may be in another unit, others must be scaled up.
Message adviceFor(const PreparedModel& model) {
  if (model.unitSuggestions.empty()) return message("scale-up-or-shorten");
  return unitAdvice(model.unitSuggestions);
}

}  // namespace

double squareBoundMm(const Box3& boxMm, double eyeDistanceMm) {
  const double diagonal = boxMm.diagonal();
  if (diagonal >= eyeDistanceMm) return std::numeric_limits<double>::infinity();
  return diagonal / (1 - diagonal / eyeDistanceMm) / std::numbers::sqrt2;
}

Status checkSizeBound(const PreparedModel& model, const SizeBound& room, double eyeDistanceMm) {
  const Box3 box = boundingBox(model.mesh);
  const double most = squareBoundMm(box, eyeDistanceMm) / room.outer;
  if (most >= room.minSymbolMm()) return {};
  return fail(ErrorKind::NoSolution,
              message("model-too-small", with::extentMm<"size">(box.size()), with::count<"modules">(room.modules),
                      with::lengthMm<"least">(room.minSymbolMm()), with::lengthMm<"module">(kMinModuleMm),
                      with::lengthMm<"most">(most), with::cause<"advice">(adviceFor(model))));
}

}  // namespace qrelief
