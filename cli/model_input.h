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

/// The model that a command works on, and how it is to be taken.
struct ModelFlags {
  std::string path, units;
  std::optional<double> scale;
  RepairFlags repair;
};

/// Adds MODEL, --scale, --units and the repair flags.
void addModelFlags(CLI::App& command, ModelFlags& flags);

/// A model from a file, checked; it may have blocking findings.
struct ModelInput {
  std::string format;
  std::vector<Message> warnings;  ///< of the reader
  std::vector<std::string> partNames;
  double scaleToMm = 1;
  PreparedModel prepared;
  double loadMs = 0, prepareMs = 0;
};

Result<ModelInput> loadModel(const ModelFlags& flags);

/// The same for a model that is to be engraved: warnings are said on stderr, a blocking finding is an error.
Result<ModelInput> loadEngravable(const ModelFlags& flags);

}  // namespace qrelief
