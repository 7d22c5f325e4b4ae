// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "math/box.h"
#include "mesh/prepare.h"

namespace qrelief {

/// Smallest useful module: nothing available prints or scans a smaller one (finest resin printers: 0.05 mm pixels, four
/// to a module).
inline constexpr double kMinModuleMm = 0.2;

/// The code that has to fit.
struct SizeBound {
  int modules = 21;  ///< along the symbol's edge
  double outer = 1;  ///< edge of the square that must fit, in edges of the symbol, ≥ 1

  double minSymbolMm() const { return kMinModuleMm * modules; }
};

/// Returns an upper bound of the edge of a square on the QR plane that the model can fill as seen from the eye, for any
/// point of the model as the centre and any orientation of the plane. Two opposite corners of the square are the images
/// of points of the model, at most a diagonal d of its box apart. From the distance D, a point at the height h ≤ d over
/// the plane is enlarged by D / (D - h), so the images of the corners are at most d / (1 - d / D) apart, which is √2
/// edges. Infinite if the eye is within one diagonal.
double squareBoundMm(const Box3& boxMm, double eyeDistanceMm);

/// Returns advice for a model without room for a code, to be quoted within an error: the units in which the model would
/// have a usual size and perhaps room, or `otherwise` if there are none or the model is not small.
Message roomAdvice(const PreparedModel& model, const SizeBound& room, double eyeDistanceMm, Message otherwise);

/// Checks if a model can have room for a code with the smallest modules. It looks at the bounding box only, so it is
/// immediate.
/// @returns NoSolution if there is no room, with the units that would help
Status checkSizeBound(const PreparedModel& model, const SizeBound& room, double eyeDistanceMm);

}  // namespace qrelief
