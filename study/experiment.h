// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "study/versions.h"
#include "study/workshop.h"

namespace qrelief::study {

/// Values of one row's columns, as the table has them.
using Row = std::vector<std::string>;

/// A table that is measured row by row. Each experiment stands in a file of its own under experiments/.
struct Experiment {
  std::string name;        ///< of its table: results/NAME.csv
  Row keys;                ///< columns that say what is measured
  Row measures;            ///< columns that are measured
  std::vector<Row> cases;  ///< key values of each row, in the table's order
  /// Values of the measures. A case that cannot be is an error; the table then has its message's code.
  std::function<Result<Row>(const Row& key, Workshop& workshop)> measure;
  /// Version of all that a row depends on (versions.h). A row of another version is measured again.
  std::function<std::string(const Row& key)> version;
};

/// Every experiment, in the order of the page.
std::vector<Experiment> allExperiments();

/// For Experiment::version where every row depends on the same.
std::function<std::string(const Row&)> dependingOn(std::initializer_list<Part> parts);

/// A number as tables have it.
std::string shown(double value, int decimals);

/// Depth, mm, and tries of 72 that read: columns that several tables have, and their values.
Row readingColumns();
Row readingRow(const Judged& judged);

/// The value of an enumeration that has a name. @param name  of one of its values, which count from 0
template <class Enum, class NameOf>
Enum byName(const std::string& name, NameOf nameOf) {
  for (int i = 0;; ++i)
    if (nameOf(static_cast<Enum>(i)) == name) return static_cast<Enum>(i);
}

}  // namespace qrelief::study
