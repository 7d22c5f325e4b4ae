// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "pipeline/placement.h"
#include "pipeline/spot_search.h"

namespace qrelief {

/// Reasons why a code at a place may not print or decode. They are found without carving it.
struct SpotConcerns {
  bool prints = true;                        ///< the symbol is not smaller than SpotSearchRequest::leastPrintableMm
  bool takesPockets = true;                  ///< the wall takes pockets of SpotSearchRequest::leastDepthMm
  std::optional<double> shellBelowMm;        ///< if it does not: a shell that begins within this wall (shell_below.h)
  bool coversColours = false;                ///< the surface under the code and its quiet zone has several colours
  bool facesDown = false;                    ///< according to SpotSearchRequest::buildUp
  double unevenLight = 0;                    ///< see pipeline/spot_light.h
  std::optional<DirectionalLight> evenLamp;  ///< lights it evenly, in place of the request's only lamp, which does not
  double wallMm = 0;                         ///< least distance to the other side that nearly all modules have
  std::vector<Message> reasons;              ///< the concerns in words, empty if there are none
};

/// Measures the wall under nearly all modules by the limits used in engraving, the pose on the printer, and the light.
Result<SpotConcerns> concernsAt(const EngravableModel& model, const Placement& placement,
                                const SpotSearchRequest& request);

/// Returns true if a square on the surface has facets of several colours.
/// @param edgeMm  of the square around the placement's centre, on its QR plane
bool coversColours(const PreparedModel& model, const Placement& placement, double edgeMm);

/// Returns true if a code on this frame faces down on the printer.
bool facesDown(const ProjectionFrame& frame, const SpotSearchRequest& request);

/// Returns unevenLight() for a code of that size on the frame.
double unevenLightOn(const EngravableModel& model, const ProjectionFrame& frame, double symbolMm,
                     const SpotSearchRequest& request);

}  // namespace qrelief
