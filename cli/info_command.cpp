// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/model_input.h"
#include "messages/sentences.h"

namespace qrelief {
namespace {

struct InfoOptions {
  ModelFlags model;
  std::string json;
};

int describe(const InfoOptions& options) {
  const auto input = loadModel(options.model);
  if (!input) return printError(input.error());
  const PreparedModel& model = input->prepared;
  const std::string name = fileNameOf(options.model.path);
  const bool engravable = model.engravable().has_value();

  const Box3 box = boundingBox(model.mesh);
  const Vec3 size = box.size();
  nlohmann::ordered_json json = {{"file", name},
                                 {"format", input->format},
                                 {"triangles", model.mesh.triangles.size()},
                                 {"vertices", model.mesh.positions.size()},
                                 {"shells", model.shells},
                                 {"scaleToMm", input->scaleToMm},
                                 {"sizeMm", {size.x, size.y, size.z}},
                                 {"minMm", {box.min.x, box.min.y, box.min.z}},
                                 {"maxMm", {box.max.x, box.max.y, box.max.z}},
                                 {"engravable", engravable},
                                 {"findings", nlohmann::ordered_json::array()}};
  for (const UnitSuggestion& unit : model.unitSuggestions)
    json["unitSuggestions"].push_back({{"units", unit.unit}, {"scaleToMm", unit.scaleToMm}});
  if (engravable) json["volumeMm3"] = signedVolume(model.mesh);
  fmt::print("{}: {}, {} triangles, {} vertices, {} shell{}\n", name, input->format, model.mesh.triangles.size(),
             model.mesh.positions.size(), model.shells, model.shells == 1 ? "" : "s");
  fmt::print("size {:.4g} × {:.4g} × {:.4g} mm\n", size.x, size.y, size.z);
  for (const Message& warning : input->warnings) fmt::print("warning: {}\n", sentence(warning));
  for (const Finding& finding : model.findings) {
    json["findings"].push_back({{"severity", severityName(finding.severity)},
                                {"code", finding.code},
                                {"count", finding.count},
                                {"message", finding.message},
                                {"hint", finding.hint}});
    fmt::print("{}: {}\n", severityName(finding.severity), finding.message);
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
  addModelFlags(*command, options->model);
  command->add_option("--json", options->json, "write it as JSON, too");
  return [options] { return describe(*options); };
}

}  // namespace qrelief
