// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/planned_batch.h"

#include <algorithm>
#include <utility>

#include "base/parse_json.h"
#include "batch/batch_list.h"
#include "batch/manifest.h"
#include "engine/answers.h"
#include "message_codes/batch.h"
#include "settings/setting_json.h"

namespace qrelief {
namespace {

constexpr std::size_t kPreviewRows = 5;
const Error kNoRow = {ErrorKind::BadUsage, message<"no-such-row">()};

/// Returns the settings in which a request differs from the common one, and those that every row has of its own.
Json ownSettings(const EngraveRequest& request, const EngraveRequest& all) {
  const Json full = Json::parse(settingsJson(request)), common = Json::parse(settingsJson(all));
  Json own = Json::object();
  for (const auto& [key, value] : full.items())
    if (value != common[key] || key == "text" || key == "version") own[key] = value;
  return own;
}

Result<BatchList> listOf(const std::vector<std::uint8_t>& bytes, const Json& asked) {
  if (const auto count = asked["count"].get<std::size_t>(); count > 0) return countedBatchList(count);
  BatchListOptions options;
  if (asked.contains("hasNames")) options.hasNames = asked["hasNames"].get<bool>();
  return readBatchList(bytes, options);
}

/// Returns the columns of a list, each with its first cells, for a person who chooses among them.
Json columnsOf(const BatchList& list) {
  Json columns = Json::array();
  for (std::size_t i = 0; i < list.columns().size(); ++i) {
    Json cells = Json::array();
    for (std::size_t row = 0; row < std::min(list.size(), kPreviewRows); ++row) cells.push_back(list.cell(row, i));
    columns.push_back({{"name", list.columns()[i]}, {"cells", std::move(cells)}});
  }
  return columns;
}

}  // namespace

std::string PlannedBatch::planBatch(const std::vector<std::uint8_t>& bytes, const std::string& order) {
  plan_.reset();
  const Result<Json> parsed = parseJson(order);
  if (!parsed) return answer(parsed.error());
  const Json& asked = *parsed;
  auto request = requestFromJson(asked["settings"].dump());
  if (!request) return answer(request.error());
  request->code.text = asked["text"].get<std::string>();
  all_ = *request;
  perPlate_ = asked["perPlate"].get<std::size_t>();
  auto list = listOf(bytes, asked);
  if (!list) return answer(list.error());
  BatchRequest wanted{.all = std::move(*request), .name = asked["name"].get<std::string>()};
  if (asked.contains("id")) wanted.idColumn = asked["id"].get<std::string>();
  BatchPlan plan = BatchPlan::make(std::move(*list), wanted);
  Json problems = Json::array();
  for (const Message& problem : plan.problems()) problems.push_back(jsonOf(problem));
  if (!plan.models().empty())
    problems.push_back(jsonOf(message<"list-names-models">(with::quoted<"name">(plan.models().begin()->first))));
  Json warnings = Json::array();
  for (const Message& warning : plan.warnings()) warnings.push_back(jsonOf(warning));
  Json json = {{"ok", true},
               {"rows", problems.empty() ? plan.size() : 0},
               {"mayBeMore", problems.size() == BatchPlan::kMostProblems},
               {"unused", plan.unusedColumns()},
               {"columns", columnsOf(plan.list())},
               {"textNames", plan.textNames()},
               {"warnings", std::move(warnings)}};
  if (problems.empty()) {
    if (const CodeRequest code = plan.row(0).request.code; !code.isText()) {
      json["version"] = *code.symbol.version;
      json["modules"] = 17 + 4 * *code.symbol.version;
    }
    plan_ = std::move(plan);
  }
  json["problems"] = std::move(problems);
  return textOf(json);
}

std::optional<BatchRow> PlannedBatch::at(double index) const {
  if (!plan_ || !(index >= 0) || !(index < static_cast<double>(plan_->size()))) return std::nullopt;
  return plan_->row(static_cast<std::size_t>(index));
}

/// Returns the row's file, or its plate's.
std::string PlannedBatch::fileOf(const BatchRow& row) const {
  return perPlate_ == 0 ? row.file : layout().plate(layout().of(row.number - 1));
}

std::string PlannedBatch::batchRow(double index) const {
  const auto row = at(index);
  if (!row) return answer(kNoRow);
  return textOf({{"ok", true},
                 {"row",
                  {{"number", row->number},
                   {"line", row->line},
                   {"id", row->id},
                   {"text", row->request.code.text},
                   {"file", fileOf(*row)},
                   {"settings", ownSettings(row->request, all_)}}}});
}

std::optional<BatchUnit> PlannedBatch::unitAt(double index) const {
  const auto row = at(index);
  if (!row) return std::nullopt;
  const std::size_t number = layout().of(static_cast<std::size_t>(index));
  BatchUnit unit;
  for (std::size_t i = layout().begin(number); i < layout().end(number); ++i) unit.rows.push_back(plan_->row(i));
  unit.plate = layout().plate(number);
  unit.hasOwnFiles = perPlate_ == 0;
  return unit;
}

std::string PlannedBatch::unitTexts(double index, const std::string& placed) const {
  auto unit = unitAt(index);
  if (!unit) return answer(kNoRow);
  const Result<Json> parsed = parseJson(placed);
  if (!parsed) return answer(parsed.error());
  const Json& order = *parsed;
  const Json& centre = order["centre"];
  for (BatchRow& row : unit->rows)
    row.request.placement.centreMm = {centre[0].get<double>(), centre[1].get<double>(), centre[2].get<double>()};
  unit->others = order["others"].get<std::string>();
  const bool isOfPlate = order["of"] == "plate";
  return textOf(
      {{"ok", true},
       {"texts", isOfPlate ? matesToHash(*unit) : rowsToHash(*unit, order["mates"].get<std::vector<std::string>>())}});
}

std::string PlannedBatch::unitEntries(double index, const std::string& hashes) const {
  auto unit = unitAt(index);
  if (!unit) return answer(kNoRow);
  const Result<Json> parsed = parseJson(hashes);
  if (!parsed) return answer(parsed.error());
  unit->input = (*parsed)["input"].get<std::string>();
  Json entries = Json::array();
  for (const ManifestEntry& entry : pendingEntries(*unit, (*parsed)["settings"].get<std::vector<std::string>>()))
    entries.push_back(Json::parse(manifestLine(entry)));
  return textOf({{"ok", true}, {"entries", std::move(entries)}});
}

}  // namespace qrelief
