// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "engine/code_input.h"
#include "engine/loaded_model.h"
#include "mesh/ray.h"
#include "pipeline/placement.h"
#include "viewer/viewer.h"

namespace qrelief {

/// A code as shown on the surface before it is carved.
struct CodeOnSurface {
  Decal decal;
  int modules = 21;  ///< along the symbol's edge
  double symbolMm = 0, rotationDeg = 0, guaranteedMm = 0;
  double missingFraction = 0;  ///< see CodeEstimate
  bool isExact = false;
  std::shared_ptr<const VisibilityMap> reach;  ///< coarse; the decal may have a finer one

  double moduleMm() const { return symbolMm / modules; }
  /// Returns true if the point lies in the decal and the eye sees it.
  bool covers(const Mesh& mesh, const SurfacePoint& at) const;
  /// Turns and resizes the code, whether or not it then fits.
  /// @param outer  edge of the square that must fit, in symbol edges
  void adjust(double toRotationDeg, double toSymbolMm, double outer);
};

/// Estimates where the wanted code would lie, see estimateCode. Its symbol must exist.
Result<CodeOnSurface> estimatedCode(const LoadedModel& model, const CodeInput& input, Vec3 upHint,
                                    const SurfacePoint& at, std::optional<double> expectedMm = {});

/// Returns the code at the exact place that was found.
Result<CodeOnSurface> exactCode(const LoadedModel& model, const Symbol& symbol, const EngraveRequest& request,
                                const Placement& placement);

/// Returns the symbol on a frame, printed on all of the surface that the frame's eye sees.
Result<Decal> visibleDecal(const LoadedModel& model, const Symbol& symbol, const ProjectionFrame& frame,
                           double symbolMm, const EngraveRequest& request);

}  // namespace qrelief
