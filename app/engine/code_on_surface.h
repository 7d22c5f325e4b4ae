// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

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
  double symbolMm = 0, rotationDeg = 0;
  double missingFraction = 0;  ///< see CodeEstimate
  bool isForgiving = true;     ///< flat enough to be read by a phone held without care, see kForgivingTiltDeg
  bool isExact = false;
  /// Why the code may not print or decode there (pipeline/spot_concerns.h); none: not known.
  std::optional<std::vector<Message>> concerns;
  std::shared_ptr<const VisibilityMap> reach;  ///< coarse; the decal may have a finer one

  double moduleMm() const { return symbolMm / modules; }
  /// Returns true if the point lies in the decal and the eye sees it.
  bool covers(const Mesh& mesh, const SurfacePoint& at) const;
  /// Turns and resizes the code. Makes it no larger than fits there at that rotation, to about a texel of `reach`; if
  /// not even the centre is reached, takes the size as it is.
  /// @param outer  edge of the square that must fit, in symbol edges
  void adjust(double toRotationDeg, double toSymbolMm, double outer);
};

/// Returns the centre for a code picked at a point, see nearbyCentre(). The symbol must exist.
SurfacePoint centreNear(const LoadedModel& model, const CodeInput& input, Vec3 sceneUp, const SurfacePoint& picked);

/// Estimates where the wanted code would lie, see estimateCode. Its symbol must exist.
Result<CodeOnSurface> estimatedCode(const LoadedModel& model, const CodeInput& input, Vec3 sceneUp,
                                    const SurfacePoint& at, std::optional<double> expectedMm = {});

/// Returns the code at the exact place that was found. Its concerns are not known yet.
Result<CodeOnSurface> exactCode(const LoadedModel& model, const Symbol& symbol, const EngraveRequest& request,
                                const Placement& placement);

/// Finds the concerns about a code at its exact place, if they are not known.
Status findConcerns(CodeOnSurface& code, const LoadedModel& model, const Symbol& symbol, const EngraveRequest& request,
                    const Placement& placement);

/// Returns the decal, shown on all of the surface that its frame's eye sees.
Result<Decal> onVisibleSurface(const LoadedModel& model, Decal decal);

/// Returns the symbol on a frame, printed on all of the surface that the frame's eye sees.
Result<Decal> visibleDecal(const LoadedModel& model, const Symbol& symbol, const ProjectionFrame& frame,
                           double symbolMm, const EngraveRequest& request);

}  // namespace qrelief
