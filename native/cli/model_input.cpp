// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/model_input.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/clock.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "io/parse_number.h"
#include "io/read_model.h"
#include "native/files.h"

namespace qrelief {

std::string standardInput(std::string path) { return path == kStandardStream ? "/dev/stdin" : std::move(path); }

void addScaleFlags(CLI::App& command, std::optional<double>& scale, std::string& units) {
  command.add_option("--scale", scale, "millimetres in one unit of the file [1; 3MF: from the file]");
  command.add_option("--units", units, "unit of the file, instead of --scale")
      ->check(CLI::IsMember(unitNames()))
      ->excludes("--scale");
}

void addCentreFlag(CLI::App& command, std::vector<double>& at, const std::string& help) {
  constexpr double kFarthest = 1e9;  // in file units; no model is larger
  const auto isCoordinate = [](const std::string& word) {
    const std::optional<double> value =
        parseNumber(std::string_view(word).substr(std::min(word.find_first_not_of(' '), word.size())));
    return value && std::abs(*value) <= kFarthest ? std::string() : fmt::format("{} is not a coordinate", word);
  };
  command.add_option("--at", at, help)->delimiter(',')->expected(3)->check(isCoordinate);
}

void addModelFlags(CLI::App& command, ModelFlags& flags) {
  command.add_option("MODEL", flags.path, kModelFormats)->required()->transform(standardInput);
  addScaleFlags(command, flags.scale, flags.units);
  addRepairFlags(command, flags.repair);
}

Result<ModelInput> loadModel(const ModelFlags& flags) {
  const auto start = Clock::now();
  const auto scale = scaleFrom(flags.scale, flags.units);
  QRELIEF_TRY(scale);
  const Result<RepairOptions> repair = repairOptionsFrom(flags.repair);
  QRELIEF_TRY(repair);
  const auto bytes = readFile(flags.path);
  QRELIEF_TRY(bytes);
  auto soup = readModel(*bytes, flags.path);
  QRELIEF_TRY(soup);
  ModelInput input;
  input.format = soup->format;
  input.warnings = soup->warnings;
  for (const ModelPart& part : soup->parts) input.partNames.push_back(part.name);
  input.scaleToMm = scale->value_or(soup->unitMm.value_or(1));
  input.loadMs = millisecondsSince(start);

  const auto preparing = Clock::now();
  auto prepared = prepareModel(*soup, {.scaleToMm = input.scaleToMm, .repair = *repair});
  QRELIEF_TRY(prepared);
  input.prepared = std::move(*prepared);
  input.prepareMs = millisecondsSince(preparing);
  return input;
}

Result<ModelInput> loadEngravable(const ModelFlags& flags) {
  auto input = loadModel(flags);
  if (!input) return input;
  const std::string file = fileNameOf(flags.path);
  for (const Message& warning : input->warnings) printWarning(warning, file);
  for (const Finding& finding : input->prepared.findings)
    if (finding.severity == Finding::Severity::Warning) printWarning(finding.message, file);
  QRELIEF_TRY(input->prepared.engravable());
  return input;
}

}  // namespace qrelief
