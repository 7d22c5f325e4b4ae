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
  Failed,  ///< nothing is written, because carving or a check failed
  Refused  ///< a streamed request that describes nothing to carve
};

/// Returns "done", "failed" or "refused".
std::string_view rowStatusName(RowStatus status);

/// Lower-case hexadecimal SHA-256 of a row's inputs and outputs.
struct RowHashes {
  std::string input;        ///< the model's file
  std::string settings;     ///< everything else that determines the output, see settingsToHash()
  std::string output;       ///< the file; empty unless Done
  std::string plate;        ///< the plate, if there is one in addition to the file; empty unless Done
  std::string second = {};  ///< the row's second file, if there is one; empty unless Done

  bool operator==(const RowHashes&) const = default;
};

/// A line of a manifest: the result of a row.
struct ManifestEntry {
  std::size_t number = 1;
  std::string id, text;
  std::string file;   ///< file of this row alone; if there are no such files, the plate
  std::string plate;  ///< plate that also holds the row; empty: none in addition to `file`
  RowHashes sha256;
  RowStatus status = RowStatus::Failed;
  std::string reason;       ///< why it is not Done, in words; otherwise empty
  std::string details;      ///< a JSON object, see describeRow(); or empty
  std::string second = {};  ///< second file of this row (BatchRow::files()); empty: none
  /// Of a row that is still to be carved with an open mark: the name of a second file if it gets one. Not written.
  std::optional<std::string> possibleSecond = {};
};

/// Writes an entry as a line of JSON without its end:
/// {"number", "id", "text", "file", "plate", "second", "sha256": {"input", "settings", "output", "plate", "second"},
/// "status", "reason", …details}; empty values are left out
std::string manifestLine(const ManifestEntry& entry);

/// Parses a line of a manifest.
/// @returns none if it is not one
std::optional<ManifestEntry> readManifestLine(std::string_view line);

/// Write the manifest as a table that spreadsheets open [RFC 4180]: its first line, and the line of a row.
std::string manifestCsvHeader();
std::string manifestCsvLine(const ManifestEntry& entry);

/// Returns the text to hash as RowHashes::settings: version, settings, centre, name, and all other inputs of the
/// command.
/// @param others  how the model was repaired and scaled, and which other rows are on its plate
std::string settingsToHash(const BatchRow& row, std::string_view others);

/// A carved row and its evaluation.
struct CarvedRow {
  const EngraveRequest& request;
  const EngraveResult& result;
  const ReadingEvidence& reading;
  const std::optional<PrintedEvidence>& printed;  ///< none: its print was not simulated
  const Verdict& verdict;
  double totalMs;
};

/// Describes a row as {"symbol", "reading", "printed", "verdict", "grades", "depth", "timingsMs"}; "printed" only if
/// its print was simulated. A text alone has "letters" in place of "symbol", "reading", "printed" and "grades".
std::string describeRow(const CarvedRow& row);

}  // namespace qrelief
