// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/message.h"
#include "printing/print_process.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"

namespace qrelief {

/// Dimensions of a carved symbol that a printer has to reproduce.
struct CarvedFeatures {
  double moduleMm = 0;
  std::optional<ModulePattern> pattern;  ///< the pattern of most data modules; none: not a known one
  double pocketMm = 0;                   ///< median edge of the largest square that fits into a dark module's pocket
  double gapMm = 0;         ///< least width of material between two pockets, along rows and columns; infinite if there
                            ///< are no gaps
  double meanDepthMm = 0;   ///< over the carved submodules
  double leastDepthMm = 0;  ///< 5th percentile of the depths of the dark modules' deepest submodules
  std::optional<double> wallMm;          ///< least thickness of material behind a floor, along the rays, if known
  std::optional<double> labelCapitalMm;  ///< height of the label's capitals; none: no text
};

/// Measures the features of a carved symbol.
/// @param depthMm  depths of the mask's submodules; only carved ones count
CarvedFeatures measureFeatures(const Symbol& symbol, const SubmoduleMask& mask, std::span<const double> depthMm,
                               double moduleMm);

/// Returns warnings about printing; empty if there are none. The bounds in nozzle widths follow the published prints
/// [Papp 2022, §8, 0.4 mm nozzle]: `square` and `diamond` down to modules of 0.9 mm, `thick-plus` down to 0.6 mm, no
/// `thin-plus` at 1.2 mm. They are scaled for other nozzles. Depths are counted in layers.
/// @param minWallMm  material that should stay behind every floor
std::vector<Message> advisePrinting(const CarvedFeatures& features, const Printer& printer, double minWallMm = 0.8);

/// Returns the width of the finest stroke of a letter that the printer makes, mm; 0 for an impossible printer.
double finestStrokeMm(const Printer& printer);

/// Returns a warning about a label whose strokes are thinner than the printer's line; none if there is no cause.
/// @param capitalMm  height of its capitals
std::optional<Message> adviseLabel(double capitalMm, const Printer& printer);

/// Invert these bounds: the smallest module that this nozzle prints with these pockets, the widest nozzle that prints
/// these modules, and the thickest layer that leaves the shallowest modules deep enough, mm.
double printableModuleMm(const CarvedFeatures& features, double nozzleMm);
double printableNozzleMm(const CarvedFeatures& features);
double printableLayerMm(const CarvedFeatures& features);

/// Returns the least module width of a symbol without a printing warning, mm, to a hundredth. Needs no carving.
/// @param printer  with a nozzle between 0 and 1000 mm
double leastPrintableModuleMm(const Symbol& symbol, const ModuleMask& modules, FinderPattern finders,
                              const Printer& printer);

}  // namespace qrelief
