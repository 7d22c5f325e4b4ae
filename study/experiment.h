// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "study/study_context.h"
#include "study/versions.h"

namespace qrelief::study {

/// A table row's values, as written in the table.
using Row = std::vector<std::string>;

/// A table that is measured row by row. Each experiment has a file of its own under experiments/.
struct Experiment {
  std::string name;        ///< of its table: results/NAME.csv
  Row keys;                ///< columns that identify the measured case
  Row measures;            ///< columns that are measured
  std::vector<Row> cases;  ///< key values of each row, in the table's order
  /// Measures a row. If a case is impossible, returns an error; the table then holds the code of its message.
  std::function<Result<Row>(const Row& key, StudyContext& context)> measure;
  /// Returns the version of everything that a row depends on (versions.h). A row of another version is measured again.
  std::function<std::string(const Row& key)> version;
};

/// Returns every experiment, in the order of the page.
std::vector<Experiment> allExperiments();

/// Returns a function for Experiment::version if every row depends on the same parts.
std::function<std::string(const Row&)> dependingOn(std::initializer_list<Part> parts);

/// Formats a number for tables.
std::string shown(double value, int decimals);

/// Returns the columns that several tables share, and their values: depth in mm, and how many of 72 tries decode.
Row readingColumns();
Row readingRow(const Judged& judged);

/// Returns the enumerator with a name. @param name  must belong to an enumerator; these count from 0
template <class Enum, class NameOf>
Enum byName(const std::string& name, NameOf nameOf) {
  for (int i = 0;; ++i)
    if (nameOf(static_cast<Enum>(i)) == name) return static_cast<Enum>(i);
}

}  // namespace qrelief::study
