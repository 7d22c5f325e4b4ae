// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "depth/depth_field.h"
#include "mesh/mesh.h"
#include "pipeline/placement.h"
#include "printing/print_process.h"
#include "qr/symbol.h"

namespace qrelief {

/// Opaque layers of an inlay that faces up, and lines of an inlay in a wall.
inline constexpr double kInlayLayers = 2, kInlayLines = 2;

/// Returns the depth of an inlay along the surface's normal so that nothing shines through and the printer can lay it:
///
///     max(2·layer·|cos θ|, 2·line·|sin θ|)
///
/// Along the vertical such a body measures depth/cos θ, and within a layer depth/sin θ across. So at every slope it is
/// at least two layers high and two lines wide.
/// @param facing  angle θ between the printer's vertical and the surface's normal, radians
double opaqueDepthMm(double facing, const Printer& printer);

/// Returns the greatest opaqueDepthMm() of any slope.
double deepestInlayMm(const Printer& printer);

/// Depth that a module's walls must take, as a part of the wanted depth; a thinner body shows what lies under it.
inline constexpr double kLeastInlayDepth = 0.5;

/// Returns the depth of an inlay along the rays: one for the whole code, so that the body is even. It is opaque for 95
/// % of the code's area; where a ray is more than 60° from the normal, for that angle.
/// @param buildUp  the printer's vertical
double inlayDepthMm(const Mesh& mesh, const Placement& placement, const Vec3& buildUp, const Printer& printer);

/// The pockets of an inlay.
struct InlayPockets {
  DepthField depths;        ///< whole modules, all of one depth
  double depthMm = 0;       ///< this depth; 0: no module takes an inlay
  std::size_t leftOut = 0;  ///< dark modules under which walls are too thin
};

/// Chooses the modules that take an inlay, and its depth. Dark modules whose walls take less than kLeastInlayDepth of
/// the wanted depth are left out; the thinnest wall of the others limits the depth of all.
/// @param symbolMm  edge without quiet zone, > 0
/// @param limitMm   greatest depth of every submodule, row-major from the symbol's top left
/// @param wantedMm  > 0
InlayPockets inlayPockets(const Symbol& symbol, double symbolMm, const std::vector<double>& limitMm, double wantedMm);

/// Returns a depth field for EmbedOptions::paint, which lowers nothing: a quantum in all dark modules.
DepthField paintedModules(const Symbol& symbol, double symbolMm);

}  // namespace qrelief
