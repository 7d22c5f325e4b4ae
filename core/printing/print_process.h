// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/result.h"

namespace qrelief {

enum class PrintTechnique : std::uint8_t {
  Filament,  ///< lines of molten plastic, layer on layer
  Resin,     ///< layers hardened by light, pixel by pixel
  Powder     ///< grains melted or glued together
};

/// The printer that a model is meant for.
struct Printer {
  double nozzleMm = 0.4;  ///< > 0; for Filament
  double layerMm = 0.2;   ///< > 0
  /// Line width of an outer wall, ≥ nozzleMm; none: 1.125 nozzles, as in slicers' profiles.
  std::optional<double> lineWidthMm = {};
  PrintTechnique technique = PrintTechnique::Filament;

  bool operator==(const Printer&) const = default;
};

/// Returns the line width of an outer wall, mm.
double lineWidthMm(const Printer& printer);

/// The process's effect on a layer's cross-section, as far as it shapes the surface. All in mm.
struct PrintProcess {
  double layerMm = 0.2;
  double cornerRadiusMm = 0.225;  ///< least radius of the solid's corners
  double pocketRadiusMm = 0.05;   ///< least radius of a pocket's corners; closes gaps narrower than twice that
  double thinnestWallMm = 0.1;    ///< thinner walls are not printed
  double thinnestLineMm = 0.34;   ///< thinner walls become this wide; 0: none is thinner than two corner radii
  double grooveMm = 0.05;  ///< depth of the groove between two layers, and radius of crevices that plastic flows into
  double grainMm = 0;      ///< standard deviation of the surface's roughness
  double finestMm = 0.4;   ///< smallest detail that the process can make

  bool operator==(const PrintProcess&) const = default;
};

/// Derives the process of a printer. @returns BadUsage for an impossible printer
Result<PrintProcess> processOf(const Printer& printer);

struct NamedPrinter {
  std::string_view name;  ///< "fdm-0.4/0.2": nozzle and layer
  Printer printer;
};

/// Returns the printers that users can choose by name, the most common first.
std::span<const NamedPrinter> namedPrinters();

}  // namespace qrelief
