// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/planned_batch.h"

#include <cmath>
#include <sstream>
#include <utility>

#include "base/parse_json.h"
#include "batch/batch_list.h"
#include "batch/manifest.h"
#include "batch/plate_layout.h"
#include "engine/answers.h"
#include "settings/setting_json.h"

namespace qrelief {
namespace {

const Error kNoRow = {ErrorKind::BadUsage, message("no-such-row")};

/// Returns the columns of a row that the manifest and the page's table share.
Json nameOf(const BatchRow& row, const std::string& file) {
  return {{"number", row.number}, {"line", row.line}, {"id", row.id}, {"text", row.request.text}, {"file", file}};
}

/// Returns the settings in which a request differs from the common one, and those that every row has of its own.
Json ownSettings(const EngraveRequest& request, const EngraveRequest& all) {
  const Json given = Json::parse(settingsJson(request)), common = Json::parse(settingsJson(all));
  Json own = Json::object();
  for (const auto& [key, value] : given.items())
    if (value != common[key] || key == "text" || key == "version") own[key] = value;
  return own;
}

Result<BatchList> listOf(const std::vector<std::uint8_t>& bytes, std::size_t count) {
  return count > 0 ? Result<BatchList>(countedBatchList(count)) : readBatchList(bytes);
}

}  // namespace

std::string PlannedBatch::planBatch(const std::vector<std::uint8_t>& bytes, const std::string& wanted) {
  plan_.reset();
  const Result<Json> parsed = parseJson(wanted);
  if (!parsed) return answer(parsed.error());
  const Json& asked = *parsed;
  auto request = requestFromJson(asked["settings"].dump());
  if (!request) return answer(request.error());
  request->text = asked["text"].get<std::string>();
  all_ = *request;
  perPlate_ = asked["perPlate"].get<std::size_t>();
  auto list = listOf(bytes, asked["count"].get<std::size_t>());
  if (!list) return answer(list.error());
  BatchPlan plan = BatchPlan::make(std::move(*list), {std::move(*request), asked["name"].get<std::string>()});
  Json problems = Json::array();
  for (const Message& problem : plan.problems()) problems.push_back(jsonOf(problem));
  Json warnings = Json::array();
  for (const Message& warning : plan.warnings()) warnings.push_back(jsonOf(warning));
  Json told = {{"ok", true},
               {"rows", problems.empty() ? plan.size() : 0},
               {"mayBeMore", problems.size() == BatchPlan::kMostProblems},
               {"unused", plan.unusedColumns()},
               {"warnings", std::move(warnings)}};
  if (problems.empty()) {
    const int version = *plan.row(0).request.symbol.version;
    told["version"] = version;
    told["modules"] = 17 + 4 * version;
    plan_ = std::move(plan);
  }
  told["problems"] = std::move(problems);
  return textOf(told);
}

std::optional<BatchRow> PlannedBatch::at(double index) const {
  if (!plan_ || !(index >= 0) || !(index < static_cast<double>(plan_->size()))) return std::nullopt;
  return plan_->row(static_cast<std::size_t>(index));
}

/// Returns the row's file, or its plate's.
std::string PlannedBatch::fileOf(const BatchRow& row) const {
  if (perPlate_ == 0) return row.file;
  return plateName((row.number - 1) / perPlate_, (plan_->size() + perPlate_ - 1) / perPlate_);
}

std::string PlannedBatch::batchRows(double from, double count) const {
  Json rows = Json::array();
  for (double index = from; index < from + count; ++index)
    if (const auto row = at(index)) rows.push_back(nameOf(*row, fileOf(*row)));
  return textOf({{"ok", true}, {"rows", std::move(rows)}});
}

std::string PlannedBatch::batchRow(double index) const {
  const auto row = at(index);
  if (!row) return answer(kNoRow);
  Json told = nameOf(*row, fileOf(*row));
  told["settings"] = ownSettings(row->request, all_);
  return textOf({{"ok", true}, {"row", std::move(told)}});
}

std::string PlannedBatch::batchRowToHash(double index, const std::string& placed) const {
  auto row = at(index);
  if (!row) return answer(kNoRow);
  const Result<Json> parsed = parseJson(placed);
  if (!parsed) return answer(parsed.error());
  const Json& given = *parsed;
  const Json& centre = given["centre"];
  row->request.placement.centreMm = {centre[0].get<double>(), centre[1].get<double>(), centre[2].get<double>()};
  return textOf({{"ok", true}, {"text", settingsToHash(*row, given["others"].get<std::string>())}});
}

std::string PlannedBatch::manifestLine(const std::string& entry) const {
  const auto read = readManifestLine(entry);
  if (!read) return answer(ErrorKind::BadUsage, message("no-manifest-line"));
  return textOf({{"ok", true}, {"line", qrelief::manifestLine(*read)}});
}

std::string PlannedBatch::manifestCsv(const std::string& lines, bool withHeader) const {
  std::string csv = withHeader ? manifestCsvHeader() : "";
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);)
    if (const auto entry = readManifestLine(line)) csv += manifestCsvLine(*entry);
  return textOf({{"ok", true}, {"csv", csv}});
}

}  // namespace qrelief
