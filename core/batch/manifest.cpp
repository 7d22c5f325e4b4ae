// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/manifest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csv.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/parse_json.h"
#include "base/version.h"
#include "pipeline/engrave.h"
#include "pipeline/label_pockets.h"
#include "settings/setting_json.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kStatusNames = {"done", "failed", "refused"};
constexpr std::array<const char*, 9> kOwnKeys = {"number", "id",     "text",   "file",  "plate",
                                                 "second", "sha256", "status", "reason"};

/// Writes JSON. Replaces text that is not UTF-8, so that the line is not lost.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Quotes a cell where CSV requires it [RFC 4180].
std::string csvCell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
  std::string cell(2 * text.size() + 2, '\0');
  cell.resize(csv_write(cell.data(), cell.size(), text.data(), text.size()));
  return cell;
}

/// Returns a value of the details as the table shows it; empty if it is missing.
std::string detail(const Json& details, const char* pointer) {
  const Json::json_pointer at(pointer);
  if (!details.contains(at)) return {};
  const Json& value = details.at(at);
  return value.is_string() ? value.get<std::string>() : value.is_null() ? "" : dumped(value);
}

double rounded(double value) { return std::round(1e4 * value) / 1e4; }

}  // namespace

std::string_view rowStatusName(RowStatus status) { return kStatusNames[static_cast<std::size_t>(status)]; }

std::string manifestLine(const ManifestEntry& entry) {
  Json json = {{"number", entry.number},
               {"id", entry.id},
               {"text", entry.text},
               {"file", entry.file},
               {"sha256", {{"input", entry.sha256.input}, {"settings", entry.sha256.settings}}},
               {"status", rowStatusName(entry.status)}};
  if (!entry.plate.empty()) json["plate"] = entry.plate;
  if (!entry.second.empty()) json["second"] = entry.second;
  if (!entry.sha256.output.empty()) json["sha256"]["output"] = entry.sha256.output;
  if (!entry.sha256.plate.empty()) json["sha256"]["plate"] = entry.sha256.plate;
  if (!entry.sha256.second.empty()) json["sha256"]["second"] = entry.sha256.second;
  if (!entry.reason.empty()) json["reason"] = entry.reason;
  std::string line = dumped(json);
  if (!entry.details.empty()) line.replace(line.size() - 1, 1, "," + entry.details.substr(1));
  return line;
}

std::optional<ManifestEntry> readManifestLine(std::string_view line) {
  Result<Json> parsed = parseJson(line);
  if (!parsed || !parsed->is_object()) return std::nullopt;
  Json& json = *parsed;
  try {
    ManifestEntry entry;
    entry.number = json.at("number").get<std::size_t>();
    entry.id = json.at("id").get<std::string>();
    entry.text = json.at("text").get<std::string>();
    entry.file = json.at("file").get<std::string>();
    const Json& hashes = json.at("sha256");
    entry.plate = json.value("plate", "");
    entry.second = json.value("second", "");
    entry.sha256 = {hashes.at("input").get<std::string>(), hashes.at("settings").get<std::string>(),
                    hashes.value("output", ""), hashes.value("plate", ""), hashes.value("second", "")};
    const auto name = json.at("status").get<std::string>();
    const auto status = std::find(kStatusNames.begin(), kStatusNames.end(), name);
    if (status == kStatusNames.end()) return std::nullopt;
    entry.status = static_cast<RowStatus>(status - kStatusNames.begin());
    entry.reason = json.value("reason", "");
    for (const char* key : kOwnKeys) json.erase(key);
    if (!json.empty()) entry.details = dumped(json);
    return entry;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string manifestCsvHeader() {
  return "number,id,text,file,plate,status,reason,reads,prints,solid,meanDepthMm,maxDepthMm,iso29158,totalMs,"
         "sha256,second,sha256Second\r\n";
}

std::string manifestCsvLine(const ManifestEntry& entry) {
  const Json details = entry.details.empty() ? Json::object() : Json::parse(entry.details);
  std::string line = std::to_string(entry.number);
  for (const std::string& cell :
       {entry.id, entry.text, entry.file, entry.plate, std::string(rowStatusName(entry.status)), entry.reason,
        detail(details, "/verdict/reads"), detail(details, "/verdict/prints"), detail(details, "/verdict/solid"),
        detail(details, "/depth/meanMm"), detail(details, "/depth/maxMm"), detail(details, "/grades/iso29158"),
        detail(details, "/timingsMs/total"), entry.sha256.output, entry.second, entry.sha256.second})
    line += ',' + csvCell(cell);
  return line + "\r\n";
}

std::string settingsToHash(const BatchRow& row, std::string_view others) {
  const Vec3 centre = row.request.placement.centreMm;
  return fmt::format("qrelief {}\n{}\n{} {} {}\n{}\n{}\n", kVersion, settingsJson(row.request), centre.x, centre.y,
                     centre.z, row.file, others);
}

std::string describeRow(const CarvedRow& row) {
  const auto& [request, result, reading, printed, verdict, totalMs] = row;
  const auto counted = [](const ReadingEvidence& evidence) {
    return Json{{"tries", evidence.count.tries}, {"reads", evidence.count.reads}, {"traced", evidence.traced}};
  };
  const DepthSummary depth = pocketDepths(result);
  Json details;
  if (request.code.isText())
    details["letters"] = {{"capitalMm", rounded(capitalMmOf(result).value_or(0))},
                          {"sizeMm", result.placement.symbolMm}};
  else
    details = {{"symbol",
                {{"version", result.symbol.version},
                 {"errorCorrection", errorCorrectionName(result.symbol.errorCorrection)},
                 {"mask", result.symbol.mask},
                 {"symbolMm", result.placement.symbolMm}}},
               {"reading", counted(reading)}};
  if (printed) details["printed"] = counted(printed->reading);
  details["verdict"] = {{"passed", verdict.passed()},
                        {"reads", levelName(verdict.reads.level)},
                        {"prints", levelName(verdict.prints.level)},
                        {"solid", levelName(verdict.solid.level)}};
  if (!request.code.isText()) {
    const SymbolGrades grades = gradesOf(request, result);
    details["grades"] = {{"iso15415", grades.iso15415}, {"iso29158", grades.iso29158}};
  }
  details["depth"] = {{"meanMm", rounded(depth.meanMm)},
                      {"maxMm", rounded(depth.maxMm)},
                      {"p95Mm", rounded(depth.p95Mm)},
                      {"preset", presetName(request.depth.preset)}};
  details["timingsMs"] = {{"total", std::round(totalMs)}};
  return dumped(details);
}

}  // namespace qrelief
