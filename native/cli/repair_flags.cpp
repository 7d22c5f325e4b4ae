// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/repair_flags.h"

#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "message_codes/command.h"

namespace qrelief {
namespace {

Result<std::optional<double>> millimetresOrAuto(const std::string& text, const char* option) {
  if (text == "auto") return std::optional<double>();
  try {
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    if (used == text.size() && value >= 0 && std::isfinite(value)) return std::optional(value);
  } catch (const std::exception&) {
  }
  return fail(ErrorKind::BadUsage,
              message<"tolerance-not-a-length">(with::term<"option">(option), with::quoted<"given">(text)));
}

}  // namespace

void addRepairFlags(CLI::App& command, RepairFlags& flags) {
  command.add_option(
      "--weld-tolerance", flags.weldTolerance,
      "MM or auto: weld vertices of open edges within this distance, and split open edges at vertices on them; "
      "auto: 1/100000 of the diagonal; 0: weld equal vertices only [auto]");
  command.add_option("--max-hole", flags.maxHole,
                     "MM or auto: fill holes up to this diameter; auto: a fifth of the diagonal [auto]");
  command
      .add_option("--no-repair", flags.without,
                  "STEP,...: skip these repairs: weld, t-junctions, holes, stray, orientation, crossings, or all")
      ->delimiter(',')
      ->check(CLI::IsMember({"weld", "t-junctions", "holes", "stray", "orientation", "crossings", "all"}));
}

Result<RepairOptions> repairOptionsFrom(const RepairFlags& flags) {
  RepairOptions options;
  for (const std::string& step : flags.without) {
    if (step == "all") options = RepairOptions::none();
    if (step == "weld") options.weldNear = false;
    if (step == "t-junctions") options.splitTJunctions = false;
    if (step == "holes") options.fillHoles = false;
    if (step == "stray") options.dropStray = false;
    if (step == "orientation") options.orient = false;
    if (step == "crossings") options.untangle = false;
  }
  const auto tolerance = millimetresOrAuto(flags.weldTolerance, "--weld-tolerance");
  QRELIEF_TRY(tolerance);
  const auto maxHole = millimetresOrAuto(flags.maxHole, "--max-hole");
  QRELIEF_TRY(maxHole);
  options.weldToleranceMm = *tolerance;
  options.maxHoleMm = *maxHole;
  return options;
}

}  // namespace qrelief
