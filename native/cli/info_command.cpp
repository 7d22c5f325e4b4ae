// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/message_json.h"
#include "cli/commands.h"
#include "cli/model_input.h"
#include "messages/sentences.h"
#include "native/files.h"

namespace qrelief {
namespace {

struct InfoOptions {
  ModelFlags model;
  std::string json;
};

using Json = nlohmann::ordered_json;

/// Returns the finding's count; 1 if it has none.
double countIn(const Message& message) {
  for (const MessageValue& value : message.values) {
    if (value.name == "count") return value.numbers[0];
    if (value.name == "pairs") return countIn(value.cause.front());
  }
  return 1;
}

/// Writes a finding with its sentence and the values in it (base/message_json.h).
Json jsonOf(const Finding& finding) {
  return {{"severity", severityName(finding.severity)},
          {"code", finding.message.code},
          {"count", static_cast<std::size_t>(countIn(finding.message))},
          {"message", sentence(finding.message)},
          {"hint", hint(finding.message)},
          {"values", jsonOf(finding.message)["values"]}};
}

int describe(const InfoOptions& options) {
  const std::string name = fileNameOf(options.model.path);
  const auto input = loadModel(options.model);
  if (!input) return printError(input.error(), name);
  const PreparedModel& model = input->prepared;
  const bool engravable = model.engravable().has_value();

  const Box3 box = boundingBox(model.mesh);
  const Vec3 size = box.size();
  Json json = {{"file", name},
               {"format", input->format},
               {"triangles", model.mesh.triangles.size()},
               {"vertices", model.mesh.positions.size()},
               {"shells", model.shells},
               {"scaleToMm", input->scaleToMm},
               {"sizeMm", {size.x, size.y, size.z}},
               {"minMm", {box.min.x, box.min.y, box.min.z}},
               {"maxMm", {box.max.x, box.max.y, box.max.z}},
               {"engravable", engravable},
               {"findings", Json::array()}};
  for (const UnitSuggestion& unit : model.unitSuggestions)
    json["unitSuggestions"].push_back({{"units", unit.unit}, {"scaleToMm", unit.scaleToMm}});
  if (engravable) json["volumeMm3"] = signedVolume(model.mesh);
  fmt::print("{}: {}, {} triangles, {} vertices, {} shell{}\n", name, input->format, model.mesh.triangles.size(),
             model.mesh.positions.size(), model.shells, model.shells == 1 ? "" : "s");
  fmt::print("size {:.4g} × {:.4g} × {:.4g} mm\n", size.x, size.y, size.z);
  for (const Message& warning : input->warnings) fmt::print("warning: {}\n", sentence(warning));
  for (const Finding& finding : model.findings) {
    json["findings"].push_back(jsonOf(finding));
    fmt::print("{}: {}\n", severityName(finding.severity), sentence(finding.message));
    if (const std::string helps = hint(finding.message); !helps.empty()) fmt::print("  hint: {}\n", helps);
  }
  fmt::print("{}\n", engravable ? "closed solid: ready to engrave" : "not a closed solid: repair it before engraving");
  if (!options.json.empty())
    if (const Status written = writeFileAtomically(options.json, json.dump(2) + "\n"); !written)
      return printError(written.error());
  return kEngraved;
}

}  // namespace

std::function<int()> addInfoCommand(CLI::App& app) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Print size, triangles and defects of a model");
  addModelFlags(*command, options->model);
  command->add_option("--json", options->json, "also write them as JSON");
  return [options] { return describe(*options); };
}

}  // namespace qrelief
