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

/// Layers that make an inlay opaque if it faces up, and lines that do so in a vertical wall.
inline constexpr double kInlayLayers = 2, kInlayLines = 2;

/// Returns the depth of an inlay along the surface's normal at which it is opaque and printable:
///
///     max(2·layer·|cos θ|, 2·line·|sin θ|)
///
/// Along the vertical such a body measures depth/cos θ, and within a layer depth/sin θ across. So at every slope it is
/// at least two layers high and two lines wide.
/// @param facing  angle θ between the printer's vertical and the surface's normal, radians
double opaqueDepthMm(double facing, const Printer& printer);

/// Returns the greatest opaqueDepthMm() over all slopes.
double deepestInlayMm(const Printer& printer);

/// Least depth that a module's wall must allow, as a fraction of the wanted depth; a thinner inlay is see-through.
inline constexpr double kLeastInlayDepth = 0.5;

/// Returns the depth of an inlay along the rays: one depth for the whole code, so that the body is even. The inlay is
/// opaque on 95 % of the code's area; rays more than 60° from the normal count as 60°.
/// @param buildUp  the printer's vertical
double inlayDepthMm(const Mesh& mesh, const Placement& placement, const Vec3& buildUp, const Printer& printer);

/// Returns a depth field that carves nothing.
DepthField noPockets(const Symbol& symbol, double symbolMm);

/// The pockets of an inlay.
struct InlayPockets {
  DepthField depths;        ///< whole modules, all of one depth
  double depthMm = 0;       ///< that depth; 0: no module takes an inlay
  std::size_t leftOut = 0;  ///< dark modules under which walls are too thin
};

/// Chooses the modules that take an inlay, and its depth. Dark modules whose walls take less than kLeastInlayDepth of
/// the wanted depth are left out; the thinnest wall of the others limits the depth of all.
/// @param symbolMm  edge without quiet zone, > 0
/// @param limitMm   greatest depth of every submodule, row-major from the symbol's top left
/// @param wantedMm  > 0
InlayPockets inlayPockets(const Symbol& symbol, double symbolMm, const std::vector<double>& limitMm, double wantedMm);

/// Returns a depth field for EmbedOptions::paint: a quantum in all dark modules. Painting lowers nothing.
DepthField paintedModules(const Symbol& symbol, double symbolMm);

}  // namespace qrelief
