// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/repair_flags.h"
#include "io/read_model.h"
#include "mesh/prepare.h"

namespace qrelief {
namespace {

struct InfoOptions {
  std::string model, units, json;
  std::optional<double> scale;
  RepairFlags repair;
};

const char* nameOf(Finding::Severity severity) {
  return severity == Finding::Severity::Note ? "note" : severity == Finding::Severity::Warning ? "warning" : "blocking";
}

int describe(const InfoOptions& options) {
  const auto given = scaleFrom(options.scale, options.units);
  if (!given) return printError(given.error());
  const auto bytes = readFile(options.model);
  if (!bytes) return printError(bytes.error());
  auto soup = readModel(*bytes, options.model);
  if (!soup) return printError(soup.error());
  const double scale = given->value_or(soup->unitMm.value_or(1));
  const Result<RepairOptions> repair = repairOptionsFrom(options.repair);
  if (!repair) return printError(repair.error());
  auto model = prepareModel(*soup, {.scaleToMm = scale, .repair = *repair});
  if (!model) return printError(model.error());
  const bool engravable = model->engravable().has_value();

  const Box3 box = boundingBox(model->mesh);
  const Vec3 size = box.size();
  nlohmann::ordered_json json = {{"file", fileNameOf(options.model)},
                                 {"format", soup->format},
                                 {"triangles", model->mesh.triangles.size()},
                                 {"vertices", model->mesh.positions.size()},
                                 {"shells", model->shells},
                                 {"scaleToMm", scale},
                                 {"sizeMm", {size.x, size.y, size.z}},
                                 {"minMm", {box.min.x, box.min.y, box.min.z}},
                                 {"maxMm", {box.max.x, box.max.y, box.max.z}},
                                 {"engravable", engravable},
                                 {"findings", nlohmann::ordered_json::array()}};
  for (const UnitSuggestion& unit : model->unitSuggestions)
    json["unitSuggestions"].push_back({{"units", unit.unit}, {"scaleToMm", unit.scaleToMm}});
  if (engravable) json["volumeMm3"] = signedVolume(model->mesh);
  fmt::print("{}: {}, {} triangles, {} vertices, {} shell{}\n", fileNameOf(options.model), soup->format,
             model->mesh.triangles.size(), model->mesh.positions.size(), model->shells, model->shells == 1 ? "" : "s");
  fmt::print("size {:.4g} × {:.4g} × {:.4g} mm\n", size.x, size.y, size.z);
  for (const std::string& warning : soup->warnings) fmt::print("warning: {}\n", warning);
  for (const Finding& finding : model->findings) {
    json["findings"].push_back({{"severity", nameOf(finding.severity)},
                                {"code", finding.code},
                                {"count", finding.count},
                                {"message", finding.message},
                                {"hint", finding.hint}});
    fmt::print("{}: {}\n", nameOf(finding.severity), finding.message);
    if (!finding.hint.empty()) fmt::print("  what helps: {}\n", finding.hint);
  }
  fmt::print("{}\n", engravable ? "a closed solid: can be engraved" : "no closed solid: cannot be engraved as it is");
  if (!options.json.empty())
    if (const Status written = writeFileAtomically(options.json, json.dump(2) + "\n"); !written)
      return printError(written.error());
  return kEngraved;
}

}  // namespace

std::function<int()> addInfoCommand(CLI::App& app) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Size, triangles and defects of a model");
  command->add_option("MODEL", options->model, "OBJ, STL, PLY, OFF or 3MF file")->required();
  command->add_option("--scale", options->scale, "file units → mm [1; 3MF: its own unit]");
  command->add_option("--units", options->units, "unit of the file, instead of --scale")
      ->check(CLI::IsMember({"mm", "cm", "m", "in"}));
  addRepairFlags(*command, options->repair);
  command->add_option("--json", options->json, "write it as JSON, too");
  return [options] { return describe(*options); };
}

}  // namespace qrelief
