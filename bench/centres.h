// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/engrave.h"

namespace qrelief::bench {

/// Where a model of a table is engraved.
struct Centre {
  std::string name;     ///< "model kind"
  int modelNumber = 0;  ///< of those that could be loaded
  Vec3 positionMm{0};
  std::optional<double> widthWithQuietZoneMm;
};

using AtCentre = std::function<Status(const std::shared_ptr<const EngravableModel>&, const Centre&)>;

/// Loads model after model and visits the centres that a file names:
///
///     {"model.stl": {"scaleToMm": 1, "picks": {"KIND": {"pointFileUnits": [x, y, z], "widthWithQuietZoneMm": 35}}}}
///
/// @param kinds  the wanted ones, in this order; all if empty
/// @returns 0, or 1 if anything went wrong, which is printed
int forEachCentre(const std::string& folder, const std::string& centresFile, const std::vector<std::string>& kinds,
                  const AtCentre& visit);

/// What follows the name of a table's program.
struct TableArguments {
  std::string folder, centresFile;
  std::vector<std::string> kinds;
};

/// The main() of a table: reads `FOLDER CENTRES.json [KIND...]` and makes a GL context for it.
int runTable(int argc, char** argv, const std::function<int(const GeometryPass&, const TableArguments&)>& run);

/// Prints it. @returns 1
int failed(const std::string& what, const Error& error);

Result<Placement> place(const EngravableModel& model, const GeometryPass& pass, int modules,
                        const PlacementRequest& request);

}  // namespace qrelief::bench
