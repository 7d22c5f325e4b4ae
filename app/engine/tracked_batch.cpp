// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/tracked_batch.h"

#include <array>
#include <sstream>

#include "base/parse_json.h"
#include "engine/answers.h"
#include "message_codes/batch.h"

namespace qrelief {
namespace {

constexpr std::array<const char*, 3> kLossNames = {"retry", "fail", "stop"};

std::vector<ManifestEntry> entriesOf(const std::string& lines) {
  std::vector<ManifestEntry> entries;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);)
    if (auto entry = readManifestLine(line)) entries.push_back(std::move(*entry));
  return entries;
}

/// @param page  {"state", "skipped", "count"}
Json rowsOf(const BatchProgress& progress, const Json& page) {
  Json rows = Json::array();
  for (const std::size_t row : progress.page(readRowState(page["state"].get<std::string>()),
                                             page["skipped"].get<std::size_t>(), page["count"].get<std::size_t>()))
    rows.push_back({{"index", row}, {"state", rowStateName(progress.state(row))}, {"reason", progress.reason(row)}});
  return rows;
}

}  // namespace

std::string TrackedBatch::begin(const std::string& layout) {
  const Result<Json> parsed = parseJson(layout);
  if (!parsed) return answer(parsed.error());
  const Json& order = *parsed;
  progress_ = BatchProgress(
      {order["rows"].get<std::size_t>(), order["perPlate"].get<std::size_t>(), order["printEvery"].get<std::size_t>()});
  return done();
}

std::string TrackedBatch::state(const std::string& asked) const {
  const Result<Json> parsed = parseJson(asked);
  if (!parsed) return answer(parsed.error());
  const BatchProgress::Counts& counts = progress_.counts();
  const auto remaining = progress_.remainingMs(parsed->value("workedMs", 0.0));
  return textOf({{"ok", true},
                 {"waiting", counts.waiting},
                 {"running", counts.running},
                 {"done", counts.done},
                 {"failed", counts.failed},
                 {"finished", counts.finished()},
                 {"remainingMs", remaining ? Json(*remaining) : Json()},
                 {"rows", parsed->contains("page") ? rowsOf(progress_, parsed->at("page")) : Json::array()}});
}

std::string TrackedBatch::run(const std::string& what) {
  if (what == "end")
    progress_.endRun();
  else
    progress_.startRun(what == "retry");
  return done();
}

std::string TrackedBatch::take() {
  Json rows = Json::array();
  const BatchLayout& layout = progress_.layout();
  if (const auto unit = progress_.take())
    for (std::size_t row = layout.begin(*unit); row < layout.end(*unit); ++row)
      rows.push_back({{"index", row}, {"print", layout.printsRow(row)}});
  return textOf({{"ok", true}, {"rows", std::move(rows)}});
}

std::string TrackedBatch::settle(const std::string& lines) {
  progress_.settle(entriesOf(lines));
  return done();
}

std::string TrackedBatch::lose(double row) {
  const auto unit = row < 0 ? std::nullopt : std::optional(progress_.layout().of(static_cast<std::size_t>(row)));
  return textOf({{"ok", true}, {"then", kLossNames[static_cast<std::size_t>(progress_.lose(unit))]}});
}

std::string TrackedBatch::manifestLine(const std::string& entry) const {
  const auto read = readManifestLine(entry);
  if (!read) return answer(ErrorKind::BadUsage, message<"no-manifest-line">());
  return textOf({{"ok", true}, {"line", qrelief::manifestLine(*read)}});
}

std::string TrackedBatch::manifestCsv(const std::string& lines, bool withHeader) const {
  std::string csv = withHeader ? manifestCsvHeader() : "";
  for (const ManifestEntry& entry : entriesOf(lines)) csv += manifestCsvLine(entry);
  return textOf({{"ok", true}, {"csv", csv}});
}

std::string TrackedBatch::readManifest(const std::vector<std::uint8_t>& bytes, bool isFirst, bool restores) {
  if (isFirst) index_ = {};
  index_.read({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, [&](const ManifestEntry& entry) {
    if (restores) progress_.note(entry);
  });
  return done();
}

std::string TrackedBatch::manifestSpans(double fromNumber, double count) const {
  Json spans = Json::array();
  auto line = index_.lines().lower_bound(static_cast<std::size_t>(fromNumber));
  for (; line != index_.lines().end() && static_cast<double>(spans.size()) < count; ++line)
    spans.push_back({line->second.begin, line->second.begin + line->second.bytes});
  return textOf(
      {{"ok", true}, {"spans", std::move(spans)}, {"next", line == index_.lines().end() ? Json() : Json(line->first)}});
}

}  // namespace qrelief
