// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "base/result.h"

namespace qrelief {

/// How a printer lays a filament down, as far as it decides about the surface. The ratios are those of PrusaSlicer 2.5
/// and its profiles.
struct PrintProcess {
  double nozzleMm = 0.4;      ///< > 0
  double lineWidthMm = 0.45;  ///< of an outer wall, ≥ nozzleMm
  double layerMm = 0.2;       ///< > 0, ≤ nozzleMm

  /// Walls thinner than this are not laid at all.
  double thinnestWallMm() const { return 0.25 * nozzleMm; }
  /// Thinner walls become so wide.
  double thinnestLineMm() const { return 0.85 * nozzleMm; }
  /// How far the flanks of a line fall back between two layers: a quarter of the layer, 50 µm at 0.2 mm, as measured on
  /// prints of PLA.
  double grooveMm() const { return 0.25 * layerMm; }
};

struct NamedProcess {
  std::string_view name;  ///< "fdm-0.4/0.2"
  PrintProcess process;
};

/// Those that can be chosen by name; the first is the default.
std::span<const NamedProcess> printProcesses();

/// @returns BadUsage for one that no printer could follow
Status checkProcess(const PrintProcess& process);

}  // namespace qrelief
