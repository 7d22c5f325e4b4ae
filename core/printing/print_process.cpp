// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/print_process.h"

#include "message_codes/printing.h"

namespace qrelief {
namespace {

using Technique = PrintTechnique;

// Filament: from PrusaSlicer 2.5 and its profiles.
constexpr double kLineNozzles = 1.125;  // 0.45 mm for a nozzle of 0.4 mm
constexpr double kClosingRadiusMm = 0.049;
constexpr double kThinnestWallNozzles = 0.25, kThinnestLineNozzles = 0.85;
/// Groove depth in layers: layers of 0.2 mm leave grooves of up to 50 µm, as measured on PLA prints.
constexpr double kGrooveLayers = 0.25;

// Resin and powder: half the width of the widest engraving that gets lost. Printing services ask for engraved lines of
// at least 0.3 mm (resin), 0.4 mm (multi jet fusion) and 0.5 mm (laser sintering).
constexpr double kResinRadiusMm = 0.1, kResinFinestMm = 0.3;
constexpr double kPowderRadiusMm = 0.2, kPowderGrainMm = 0.02;

constexpr NamedPrinter kPrinters[] = {
    {"fdm-0.4/0.2", {0.4, 0.2, {}, Technique::Filament}},   {"fdm-0.4/0.12", {0.4, 0.12, {}, Technique::Filament}},
    {"fdm-0.25/0.1", {0.25, 0.1, {}, Technique::Filament}}, {"fdm-0.6/0.3", {0.6, 0.3, {}, Technique::Filament}},
    {"resin-0.05", {0.05, 0.05, {}, Technique::Resin}},     {"powder", {0.1, 0.1, {}, Technique::Powder}},
};

Result<PrintProcess> filament(const Printer& printer) {
  const double nozzle = printer.nozzleMm, layer = printer.layerMm;
  if (!(layer <= nozzle))
    return fail(ErrorKind::BadUsage,
                message<"layer-above-nozzle">(with::lengthMm<"layer">(layer), with::lengthMm<"nozzle">(nozzle)));
  const double line = lineWidthMm(printer);
  if (!(line >= nozzle))
    return fail(ErrorKind::BadUsage,
                message<"line-below-nozzle">(with::lengthMm<"line">(line), with::lengthMm<"nozzle">(nozzle)));
  return PrintProcess{.layerMm = layer,
                      .cornerRadiusMm = line / 2,
                      .pocketRadiusMm = kClosingRadiusMm,
                      .thinnestWallMm = kThinnestWallNozzles * nozzle,
                      .thinnestLineMm = kThinnestLineNozzles * nozzle,
                      .grooveMm = kGrooveLayers * layer,
                      .grainMm = 0,
                      .finestMm = nozzle};
}

}  // namespace

double lineWidthMm(const Printer& printer) { return printer.lineWidthMm.value_or(kLineNozzles * printer.nozzleMm); }

Result<PrintProcess> processOf(const Printer& printer) {
  if (!(printer.layerMm > 0 && printer.nozzleMm > 0))
    return fail(ErrorKind::BadUsage, message<"layer-above-nozzle">(with::lengthMm<"layer">(printer.layerMm),
                                                                   with::lengthMm<"nozzle">(printer.nozzleMm)));
  switch (printer.technique) {
    case Technique::Filament:
      break;
    case Technique::Resin:
      return PrintProcess{printer.layerMm, kResinRadiusMm, kResinRadiusMm, 2 * kResinRadiusMm, 0, 0, 0, kResinFinestMm};
    case Technique::Powder:
      return PrintProcess{printer.layerMm, kPowderRadiusMm,    kPowderRadiusMm, 2 * kPowderRadiusMm, 0, 0,
                          kPowderGrainMm,  2 * kPowderRadiusMm};
  }
  return filament(printer);
}

std::span<const NamedPrinter> namedPrinters() { return kPrinters; }

}  // namespace qrelief
