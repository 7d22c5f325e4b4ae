// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "mesh/repair.h"

namespace qrelief {

/// Command-line options for repairs.
struct RepairFlags {
  std::string weldTolerance = "auto", maxHole = "auto";
  std::vector<std::string> without;
};

/// Adds --weld-tolerance, --max-hole and --no-repair.
void addRepairFlags(CLI::App& command, RepairFlags& flags);

Result<RepairOptions> repairOptionsFrom(const RepairFlags& flags);

}  // namespace qrelief
