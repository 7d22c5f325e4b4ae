// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "base/result.h"
#include "study/experiment.h"

namespace qrelief::study {

/// The rows of an experiment that are measured, in a CSV file with a line of column names. The file is written with
/// every row that is measured, so that a run that was stopped goes on where it was. No value has a comma.
class Table {
 public:
  /// Reads what is there, if anything.
  /// @returns BadInput if the file's columns are not those of the experiment
  static Result<Table> open(const Experiment& experiment, std::string path);

  /// Values of a row; null where it is missing or of another version.
  const Row* find(const Row& key) const;

  /// Adds a row and writes the file, under a temporary name first.
  Status add(const Row& key, Row values);

  /// Takes over the rows of another table, as of another process; the file is not written.
  void take(const Table& other) { rows_.insert(other.rows_.begin(), other.rows_.end()); }

  /// Writes the file anew, with the experiment's cases in their order and nothing else.
  Status write(const Experiment& experiment) const;

 private:
  std::string path_;
  std::function<std::string(const Row& key)> version_;
  Row columns_;
  std::map<Row, Row> rows_;  // values by key
};

/// Columns after the measures: the code of the error where a case could not be measured, and the version of what the
/// row depends on.
inline constexpr const char* kFailedColumn = "failed";
inline constexpr const char* kVersionColumn = "version";

}  // namespace qrelief::study
