// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "batch/batch_plan.h"
#include "verdict/verdict.h"

namespace qrelief {

enum class RowStatus : std::uint8_t {
  Done,    ///< written, and every check passed
  Failed,  ///< nothing is written: it could not be carved, or a check did not pass
  Refused  ///< a request of a stream that says nothing that could be carved
};

/// "done", "failed", "refused".
std::string_view rowStatusName(RowStatus status);

/// Lower-case hexadecimal SHA-256 of what a row comes from and of what came of it.
struct RowHashes {
  std::string input;     ///< of the model's file
  std::string settings;  ///< of everything else that decides the output, see settingsToHash()
  std::string output;    ///< of the file; empty unless Done
  std::string plate;     ///< of the plate, if there is one beside the file; empty unless Done

  bool operator==(const RowHashes&) const = default;
};

/// A line of a manifest: what became of a row.
struct ManifestEntry {
  std::size_t number = 1;
  std::string id, text;
  std::string file;   ///< of the row alone; without such files, the plate
  std::string plate;  ///< that it is on, too; empty: none beside `file`
  RowHashes sha256;
  RowStatus status = RowStatus::Failed;
  std::string reason;   ///< why it is not Done, in words; empty if it is
  std::string details;  ///< a JSON object, see describeRow(); or empty
};

/// A line of JSON without its end:
/// {"number", "id", "text", "file", "plate", "sha256": {"input", "settings", "output", "plate"}, "status", "reason",
/// …details}; what is empty is left out
std::string manifestLine(const ManifestEntry& entry);

/// @returns none if it is no line of a manifest
std::optional<ManifestEntry> readManifestLine(std::string_view line);

/// The same as a table that spreadsheets open, [RFC 4180]: its first line, and that of a row.
std::string manifestCsvHeader();
std::string manifestCsvLine(const ManifestEntry& entry);

/// What is to be hashed as RowHashes::settings: version, settings, centre, name, and what else the command was told.
/// @param others  how the model was repaired and scaled, and which other rows are on its plate
std::string settingsToHash(const BatchRow& row, std::string_view others);

/// A row that was carved, and what was found out about it.
struct CarvedRow {
  const EngraveRequest& request;
  const EngraveResult& result;
  const ReadingEvidence& reading;
  const std::optional<PrintedEvidence>& printed;  ///< none: its print was not looked at
  const Verdict& verdict;
  double totalMs;
};

/// {"symbol", "reading", "printed", "verdict", "grades", "depth", "timingsMs"}; "printed" only if it was looked at.
std::string describeRow(const CarvedRow& row);

}  // namespace qrelief
