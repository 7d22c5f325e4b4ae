// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "math/box.h"
#include "mesh/prepare.h"

namespace qrelief {

/// Below this a module is neither printed nor read by anything at hand (finest resin printers: 0.05 mm pixels, four to
/// a module).
inline constexpr double kMinModuleMm = 0.2;

/// A code that room is looked for.
struct CodeRoom {
  int modules = 21;  ///< along the symbol's edge
  double outer = 1;  ///< edge of what must fit, in edges of the symbol, ≥ 1

  double minSymbolMm() const { return kMinModuleMm * modules; }
};

/// Edge that no square on the QR plane about a point of a model exceeds if the model is to fill it as seen from the
/// eye, wherever the point lies and whichever way the plane: two opposite corners of the square are the images of
/// points of the model, at most a diagonal d of its box apart. Seen from the distance D, a point at the height h ≤ d
/// over the plane is enlarged by D / (D - h), so that the corners' images are at most d / (1 - d / D) apart, √2 edges.
/// Infinite from within a diagonal.
double squareBoundMm(const Box3& boxMm, double eyeDistanceMm);

/// Whether a model may have room for a code of the least module size; by its box alone, so at once.
/// @returns NoSolution if it has not, with the units that would help
Status checkRoom(const PreparedModel& model, const CodeRoom& room, double eyeDistanceMm);

}  // namespace qrelief
