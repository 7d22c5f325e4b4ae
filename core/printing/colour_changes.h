// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "mesh/mesh.h"
#include "printing/print_process.h"

namespace qrelief {

/// Price of one change from one filament to the other, on a printer with one nozzle.
struct FilamentChange {
  double purgeMm3 = 0;  ///< plastic pushed out until the new colour is clean, ≥ 0
  double seconds = 0;   ///< ≥ 0
};

/// Least purge of one change that a Bambu Lab A1 allows, mm³: a lower bound for comparisons.
inline constexpr double kLeastPurgeMm3 = 48;

/// Returns the usual price of a change. It depends on the filament switcher, not on nozzle or layer, so it is the same
/// for all filament printers; none for techniques that print one material.
std::optional<FilamentChange> usualFilamentChange(const Printer& printer);

/// Cost of the second colour of one code. All zero for a code of one colour.
struct ColourCost {
  int layers = 0;      ///< layers that contain the second colour
  int changes = 0;     ///< filament changes, both ways
  double secondG = 0;  ///< second filament within the code, printed solid; of PLA, like all weights here
  /// Filaments purged by the changes: every change purges the filament that it loads.
  double firstWasteG = 0, secondWasteG = 0;
  double wasteMinutes = 0;  ///< duration of all changes
  /// Wipe tower without the purges, as PrusaSlicer builds it if it purges into one: layers below the last change need a
  /// tower that carries the next ones. Printed mostly with the first filament.
  double towerG = 0;

  double wasteG() const { return firstWasteG + secondWasteG; }
  bool operator==(const ColourCost&) const = default;
};

/// Pose, process and filament switcher of the print.
struct ColourPrint {
  Vec3 up{0, 0, 1};  ///< the printer's vertical in the model's space, any length > 0
  PrintProcess process;
  FilamentChange change;
};

/// Triangles of a model that a slicer prints in the second colour down to a depth.
struct PaintedTriangles {
  std::span<const std::uint32_t> triangles;  ///< indices in the model's mesh
  double depthMm = 0;                        ///< depth of the colour below the surface, > 0
};

/// Counts layers and filament changes as a slicer does, and prices the changes.
///
/// A slicer cuts both bodies halfway up each layer. In a layer with both filaments it begins with the filament that the
/// nozzle holds, so such a layer costs one change. A layer with one filament costs a change only if the nozzle holds
/// the other. The print begins with the first filament if the first layer contains it. The second colour has the shape
/// that the process gives the inlay's cross-sections (extruded_outline.h); a layer where it is too thin has none.
///
/// The wipe tower follows the defaults of PrusaSlicer 2.5 [src/libslic3r/GCode/WipeTower.cpp], as long as the
/// purges of one layer need. Other slicers build smaller towers or none. The tower's printing time is not counted.
///
/// Cost: O(triangles · layers they pass), and about 0.1 µs for each of the inlay's points, which are a sixth of the
/// finest detail apart.
/// @param body   carved model; closed
/// @param inlay  body of the second colour, in the pockets of the first; closed
ColourCost colourCost(const Mesh& body, const Mesh& inlay, const ColourPrint& print);

/// Does the same for painted facets: a layer has the second colour if it passes through a painted triangle or within
/// the depth below one.
/// @param body  model with its painted triangles; closed
ColourCost colourCost(const Mesh& body, const PaintedTriangles& painted, const ColourPrint& print);

}  // namespace qrelief
