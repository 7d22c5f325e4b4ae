// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/table.h"

#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <sstream>

#include "message_codes/command.h"
#include "native/files.h"

namespace qrelief::study {
namespace {

Row columnsOf(const Experiment& experiment) {
  Row columns = experiment.keys;
  columns.insert(columns.end(), experiment.measures.begin(), experiment.measures.end());
  columns.emplace_back(kFailedColumn);
  columns.emplace_back(kVersionColumn);
  return columns;
}

Row cut(const std::string& line) {
  Row values;
  std::size_t begin = 0;
  for (std::size_t comma; (comma = line.find(',', begin)) != std::string::npos; begin = comma + 1)
    values.push_back(line.substr(begin, comma - begin));
  values.push_back(line.substr(begin));
  return values;
}

std::string lineOf(const Row& key, const Row& values) {
  return fmt::format("{},{}\n", fmt::join(key, ","), fmt::join(values, ","));
}

}  // namespace

Result<Table> Table::open(const Experiment& experiment, std::string path) {
  Table table;
  table.path_ = std::move(path);
  table.columns_ = columnsOf(experiment);
  table.version_ = experiment.version;
  if (!std::filesystem::exists(table.path_)) return table;
  const auto bytes = readFile(table.path_);
  QRELIEF_TRY(bytes);
  std::string text(bytes->begin(), bytes->end());
  text.resize(text.rfind('\n') + 1);
  std::istringstream lines(text);
  std::string line;
  for (bool first = true; std::getline(lines, line); first = false) {
    Row values = cut(line);
    if (first && values != table.columns_)
      return badInput(message<"study-other-columns">(with::term<"path">(table.path_)));
    if (first || values.size() != table.columns_.size()) continue;
    const auto keys = static_cast<std::ptrdiff_t>(experiment.keys.size());
    table.rows_[Row(values.begin(), values.begin() + keys)] = Row(values.begin() + keys, values.end());
  }
  return table;
}

const Row* Table::find(const Row& key) const {
  const auto row = rows_.find(key);
  return row == rows_.end() || row->second.back() != version_(key) ? nullptr : &row->second;
}

Status Table::add(const Row& key, Row values) {
  // Write the whole file: so no line is ever half written, and a truncated line is gone.
  values.push_back(version_(key));
  rows_[key] = std::move(values);
  std::string text = fmt::format("{}\n", fmt::join(columns_, ","));
  for (const auto& [known, measured] : rows_) text += lineOf(known, measured);
  return writeFileAtomically(path_, text);
}

Status Table::write(const Experiment& experiment) const {
  std::string text = fmt::format("{}\n", fmt::join(columns_, ","));
  for (const Row& key : experiment.cases)
    if (const Row* values = find(key)) text += lineOf(key, *values);
  return writeFileAtomically(path_, text);
}

}  // namespace qrelief::study
