// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "engine/loaded_model.h"
#include "engine/wanted_code.h"
#include "mesh/ray.h"
#include "viewer/viewer.h"

namespace qrelief {

/// A code as it is shown on the surface before it is carved.
struct CodeOnSurface {
  SurfacePrint print;
  int modules = 21;  ///< of the symbol along its edge
  double symbolMm = 0, rotationDeg = 0, guaranteedMm = 0;
  double missingFraction = 0;  ///< see CodeEstimate
  bool isExact = false;
  std::shared_ptr<const EyeReach> reach;  ///< as the map knows it; the print may know better

  double moduleMm() const { return symbolMm / modules; }
  /// Whether a point of the surface lies in symbol or quiet zone and is seen by the reader.
  bool covers(const Mesh& mesh, const SurfacePoint& at) const;
  /// Turned and of another size, whatever fits.
  /// @param outer  edge of the square that must fit, in those of the symbol
  void adjust(double toRotationDeg, double toSymbolMm, double outer);
};

/// About where the wanted code would lie, see estimateCode. The symbol must exist.
Result<CodeOnSurface> estimatedCode(const LoadedModel& model, const WantedCode& wanted, Vec3 upHint,
                                    const SurfacePoint& at, std::optional<double> expectedMm = {});

/// Where it was found to lie.
Result<CodeOnSurface> exactCode(const LoadedModel& model, const Symbol& symbol, const EngraveRequest& request,
                                const Placement& placement);

/// The symbol on a frame, on whatever of the surface the frame's eye sees.
Result<SurfacePrint> seenPrint(const LoadedModel& model, const Symbol& symbol, const ProjectionFrame& frame,
                               double symbolMm, const EngraveRequest& request);

}  // namespace qrelief
