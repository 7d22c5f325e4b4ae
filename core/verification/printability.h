// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "printing/print_process.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"

namespace qrelief {

/// What a printer has to make of a carved symbol.
struct CarvedFeatures {
  double moduleMm = 0;
  std::optional<ModulePattern> pattern;  ///< the one that most data modules have; none: no known one
  double pocketMm = 0;                   ///< edge of the largest square that fits into a dark module's pocket: median
  double gapMm = 0;         ///< least material between two pockets, along rows and columns; infinite if there is none
  double meanDepthMm = 0;   ///< over the carved submodules
  double leastDepthMm = 0;  ///< 5th percentile of the depths of the dark modules' deepest submodules
  std::optional<double> wallMm;  ///< least material behind a floor, along the rays, if it is known
};

/// @param carved   (5·modules)² submodules, row-major from the symbol's top left, 1 = carved
/// @param depthMm  of the same; only carved ones count
CarvedFeatures measureFeatures(const Symbol& symbol, const std::vector<std::uint8_t>& carved,
                               const std::vector<double>& depthMm, double moduleMm);

/// What may go wrong in print; empty if nothing that is known. The bounds in nozzle widths are what the published
/// prints allow [Papp 2022, §8, 0.4 mm nozzle]: `square` and `diamond` down to modules of 0.9 mm, `thick-plus` down to
/// 0.6 mm, no `thin-plus` at 1.2 mm; for other nozzles they are scaled. Depths are counted in layers.
/// @param minWallMm  material that should stay behind every floor
std::vector<Message> advisePrinting(const CarvedFeatures& features, const Printer& printer, double minWallMm = 0.8);

/// The same bounds, asked the other way round: the least module that such a nozzle prints with these pockets, the
/// widest nozzle that prints these modules, and the highest layer that leaves the shallowest modules deep enough, mm.
double printableModuleMm(const CarvedFeatures& features, double nozzleMm);
double printableNozzleMm(const CarvedFeatures& features);
double printableLayerMm(const CarvedFeatures& features);

/// Before anything is carved: the least module of a symbol against whose width nothing speaks, mm, to a hundredth.
/// @param printer  of a nozzle between 0 and 1000 mm
double leastPrintableModuleMm(const Symbol& symbol, ModulePattern modules, FinderPattern finders,
                              const Printer& printer);

}  // namespace qrelief
