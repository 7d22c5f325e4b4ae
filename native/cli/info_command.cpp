// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/message_json.h"
#include "cli/commands.h"
#include "cli/model_input.h"
#include "cli/output_files.h"
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

/// Lists the bodies, with their names and numbers of triangles.
Json bodiesOf(const PreparedModel& model) {
  const std::vector<std::size_t> triangles = model.bodySizes();
  Json bodies = Json::array();
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    bodies.push_back({{"name", model.bodies[b].name}, {"triangles", triangles[b]}});
  return bodies;
}

void printBodies(const Json& bodies) {
  constexpr std::size_t kMostPrinted = 20;
  for (std::size_t b = 0; b < std::min(bodies.size(), kMostPrinted); ++b)
    fmt::print("body {}: {}{}\n", b + 1,
               bodies[b]["name"].get<std::string>().empty() ? "" : bodies[b]["name"].get<std::string>() + ", ",
               counted(bodies[b]["triangles"].get<std::size_t>(), "triangle", "triangles"));
  if (bodies.size() > kMostPrinted)
    fmt::print("and {}\n", counted(bodies.size() - kMostPrinted, "more body", "more bodies"));
}

/// Says whether the model can be engraved, and where.
const char* conclusionOn(const PreparedModel& model) {
  if (!model.engravable()) return "not a closed solid: repair it before engraving";
  if (model.crossesItself) return "closed, but crosses itself: ready to engrave away from the crossings";
  return "closed solid: ready to engrave";
}

int describe(const InfoOptions& options) {
  const JsonOutput output(options.json);
  const std::string name = fileNameOf(options.model.path);
  if (const Status good = checkJson(options.json, options.model.path); !good) return printError(good.error());
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
               {"bodies", bodiesOf(model)},
               {"scaleToMm", input->scaleToMm},
               {"sizeMm", {size.x, size.y, size.z}},
               {"minMm", {box.min.x, box.min.y, box.min.z}},
               {"maxMm", {box.max.x, box.max.y, box.max.z}},
               {"engravable", engravable},
               {"findings", Json::array()}};
  for (const UnitSuggestion& unit : model.unitSuggestions)
    json["unitSuggestions"].push_back({{"units", unit.unit}, {"scaleToMm", unit.scaleToMm}});
  if (engravable) json["volumeMm3"] = signedVolume(model.mesh);
  fmt::print("{}: {}, {}, {}, {}\n", name, input->format, counted(model.mesh.triangles.size(), "triangle", "triangles"),
             counted(model.mesh.positions.size(), "vertex", "vertices"), counted(model.shells, "shell", "shells"));
  fmt::print("size {}\n", extentInWords(size.x, size.y, size.z, 4));
  if (model.bodies.size() > 1) printBodies(json["bodies"]);
  for (const Message& warning : input->warnings) fmt::print("warning: {}\n", sentence(warning));
  for (const Finding& finding : model.findings) {
    json["findings"].push_back(jsonOf(finding));
    fmt::print("{}: {}\n", severityName(finding.severity), sentence(finding.message));
    if (const std::string helps = hint(finding.message); !helps.empty()) fmt::print("  hint: {}\n", helps);
  }
  fmt::print("{}\n", conclusionOn(model));
  if (output.isWanted())
    if (const Status written = output.write(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"); !written)
      return printError(written.error());
  return kEngraved;
}

}  // namespace

std::function<int()> addInfoCommand(CLI::App& app) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Print size, triangles and defects of a model");
  addModelFlags(*command, options->model);
  command->add_option("--json", options->json, "also write them as JSON; - writes to standard output");
  return [options] { return describe(*options); };
}

}  // namespace qrelief
