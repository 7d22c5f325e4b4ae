// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "base/result.h"
#include "study/experiment.h"

namespace qrelief::study {

/// The measured rows of an experiment, in a CSV file with a line of column names. The file is written after every
/// measured row, so that an interrupted run resumes where it stopped. Values contain no commas.
class Table {
 public:
  /// Reads the file, if it exists.
  /// @returns BadInput if the file's columns differ from the experiment's
  static Result<Table> open(const Experiment& experiment, std::string path);

  /// Returns the values of a row; null if it is missing or of another version.
  const Row* find(const Row& key) const;

  /// Adds a row and writes the file, under a temporary name first.
  Status add(const Row& key, Row values);

  /// Takes over the rows of another table, e.g. of another process, without writing the file.
  void take(const Table& other) { rows_.insert(other.rows_.begin(), other.rows_.end()); }

  /// Writes the file anew: the experiment's cases in order and nothing else.
  Status write(const Experiment& experiment) const;

 private:
  std::string path_;
  std::function<std::string(const Row& key)> version_;
  Row columns_;
  std::map<Row, Row> rows_;  // values by key
};

/// Columns after the measures: the code of the error if a case could not be measured, and the version of what the row
/// depends on.
inline constexpr const char* kFailedColumn = "failed";
inline constexpr const char* kVersionColumn = "version";

}  // namespace qrelief::study
