// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/engrave.h"

namespace qrelief::bench {

/// A centre on a model to engrave at.
struct Centre {
  std::string name;     ///< "model kind"
  int modelNumber = 0;  ///< counted over the models that could be loaded
  Vec3 positionMm{0};
  std::optional<double> widthWithQuietZoneMm;
};

using AtCentre = std::function<Status(const std::shared_ptr<const EngravableModel>&, const Centre&)>;

/// Loads one model after another and visits the centres that a file lists:
///
///     {"model.stl": {"scaleToMm": 1, "picks": {"KIND": {"pointFileUnits": [x, y, z], "widthWithQuietZoneMm": 35}}}}
///
/// @param kinds  the wanted ones, in this order; all if empty
/// @returns 0, or 1 after any error; prints errors
int forEachCentre(const std::string& folder, const std::string& centresFile, const std::vector<std::string>& kinds,
                  const AtCentre& visit);

/// Arguments of a table's program.
struct TableArguments {
  std::string folder, centresFile;
  std::vector<std::string> kinds;
};

/// Runs the main() of a table: reads `FOLDER CENTRES.json [KIND...]` and makes a GL context.
int runTable(int argc, char** argv, const std::function<int(const TableArguments&)>& run);

/// Prints an error. @returns 1
int failed(const std::string& what, const Error& error);

Result<Placement> place(const EngravableModel& model, int modules, const PlacementRequest& request);

}  // namespace qrelief::bench
