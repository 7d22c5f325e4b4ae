// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/repair_flags.h"
#include "mesh/prepare.h"

namespace qrelief {

/// The formats of models, for the help of MODEL.
inline constexpr const char* kModelFormats = "OBJ, STL, PLY, OFF or 3MF file";

/// Command-line options for the model: its file, units, scale and repairs.
struct ModelFlags {
  std::string path, units;
  std::optional<double> scale;
  RepairFlags repair;
};

/// Returns the path of an input: kStandardStream is standard input.
std::string standardInput(std::string path);

/// Adds --scale and --units, of which a command takes one.
void addScaleFlags(CLI::App& command, std::optional<double>& scale, std::string& units);

/// Adds --at, a point of three finite numbers.
void addCentreFlag(CLI::App& command, std::vector<double>& at, const std::string& help);

/// Adds MODEL, --scale, --units and the repair flags.
void addModelFlags(CLI::App& command, ModelFlags& flags);

/// A checked model from a file; it may have blocking findings.
struct ModelInput {
  std::string format;
  std::vector<Message> warnings;  ///< from the parser
  std::vector<std::string> partNames;
  double scaleToMm = 1;
  PreparedModel prepared;
  double loadMs = 0, prepareMs = 0;
};

Result<ModelInput> loadModel(const ModelFlags& flags);

/// Loads a model to engrave: prints warnings to stderr, and returns a blocking finding as an error.
Result<ModelInput> loadEngravable(const ModelFlags& flags);

}  // namespace qrelief
