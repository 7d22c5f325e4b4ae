// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/result.h"

namespace qrelief {

enum class PrintTechnique : std::uint8_t {
  Filament,  ///< lines of molten plastic, one layer on the other
  Resin,     ///< layers hardened by light, pixel by pixel
  Powder     ///< grains melted or glued together
};

/// The printer that a model is meant for.
struct Printer {
  double nozzleMm = 0.4;  ///< > 0; of Filament
  double layerMm = 0.2;   ///< > 0
  /// Of an outer wall, ≥ nozzleMm; none: 1.125 nozzles, as slicers' profiles have it.
  std::optional<double> lineWidthMm = {};
  PrintTechnique technique = PrintTechnique::Filament;

  bool operator==(const Printer&) const = default;
};

/// What a printer makes of the cross-section of a layer, as far as it decides about the surface. All in mm.
struct PrintProcess {
  double layerMm = 0.2;
  double cornerRadiusMm = 0.225;  ///< no corner of the solid is sharper
  double pocketRadiusMm = 0.05;   ///< no corner of a pocket is sharper; gaps narrower than twice that are closed
  double thinnestWallMm = 0.1;    ///< thinner walls are not made at all
  double thinnestLineMm = 0.34;   ///< thinner walls become so wide; 0: none is thinner than two corner radii
  double grooveMm = 0.05;         ///< between two layers, and the radius of what plastic flows into there
  double grainMm = 0;             ///< standard deviation of the surface's roughness
  double finestMm = 0.4;          ///< what the process can shape at all

  bool operator==(const PrintProcess&) const = default;
};

/// @returns BadUsage for a printer that there cannot be
Result<PrintProcess> processOf(const Printer& printer);

struct NamedPrinter {
  std::string_view name;  ///< "fdm-0.4/0.2": nozzle and layer
  Printer printer;
};

/// Those that can be chosen by name, the most usual first.
std::span<const NamedPrinter> namedPrinters();

}  // namespace qrelief
