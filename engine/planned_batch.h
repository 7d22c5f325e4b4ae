// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "batch/batch_plan.h"

namespace qrelief {

/// The rows of a batch, as the page asks for them, and its manifest's lines. It needs neither a model nor a GL context:
/// a row is carved by Engine::configure() and startEngrave(). Answers are those of Engine.
class PlannedBatch {
 public:
  /// {rows, problems: [message], mayBeMore, unused: [column], version, modules}: see BatchPlan. With a problem there
  /// are no rows; `version` and `modules` are those of the first row. An error for a list that cannot be read.
  /// @param list    its file; not looked at where there is a count
  /// @param wanted  {"settings": {…}, "text", "name", "count", "perPlate"}: what all rows have, the templates, "" where
  /// the
  ///                list's columns say it, how many rows are numbered without a list, and how many stand on a plate, or
  ///                0
  std::string plan(const std::vector<std::uint8_t>& list, const std::string& wanted);

  /// {rows: [{number, line, id, text, file}]}: at most `count`, from 0 on. Rows of a plate have its name as `file`.
  std::string rows(double from, double count) const;
  /// {row: {number, line, id, text, file, settings}}: `settings` in which the row differs from those that all have,
  /// its text and version always among them. @param index  from 0
  std::string row(double index) const;
  /// {text}: what is to be hashed of a row, see settingsToHash().
  /// @param placed  {"centre": [x, y, z], "others"}: what else decides the row's file
  std::string toHash(double index, const std::string& placed) const;

  /// {line}: the line of the manifest (batch/manifest.h) without its end. @param entry  the same as JSON of any layout
  std::string manifestLine(const std::string& entry) const;
  /// {csv}: the same as a table. @param lines  of the manifest; others are left out
  std::string manifestCsv(const std::string& lines, bool withHeader) const;

 private:
  std::optional<BatchRow> at(double index) const;
  std::string fileOf(const BatchRow& row) const;

  std::optional<BatchPlan> plan_;  // none: with problems
  EngraveRequest all_;
  std::size_t perPlate_ = 0;
};

}  // namespace qrelief
