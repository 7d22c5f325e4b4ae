// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/print_process.h"

#include <array>

namespace qrelief {
namespace {

constexpr double kLineNozzles = 1.125;  // what vendors' profiles take: 0.45 mm for a nozzle of 0.4 mm

constexpr PrintProcess filament(double nozzleMm, double layerMm) {
  return {nozzleMm, kLineNozzles * nozzleMm, layerMm};
}

constexpr std::array<NamedProcess, 4> kProcesses = {{{"fdm-0.4/0.2", filament(0.4, 0.2)},
                                                     {"fdm-0.4/0.12", filament(0.4, 0.12)},
                                                     {"fdm-0.25/0.1", filament(0.25, 0.1)},
                                                     {"fdm-0.6/0.3", filament(0.6, 0.3)}}};

}  // namespace

std::span<const NamedProcess> printProcesses() { return kProcesses; }

Status checkProcess(const PrintProcess& process) {
  if (!(process.layerMm > 0 && process.layerMm <= process.nozzleMm))
    return fail(ErrorKind::BadUsage, message("layer-above-nozzle", with::lengthMm("layer", process.layerMm),
                                             with::lengthMm("nozzle", process.nozzleMm)));
  if (!(process.lineWidthMm >= process.nozzleMm))
    return fail(ErrorKind::BadUsage, message("line-below-nozzle", with::lengthMm("line", process.lineWidthMm),
                                             with::lengthMm("nozzle", process.nozzleMm)));
  return {};
}

}  // namespace qrelief
