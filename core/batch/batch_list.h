// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// The rows of a batch as in its list: cells of text by column. Takes the size of the list and 8 bytes per cell, even
/// for a million rows.
class BatchList {
 public:
  /// @param columns  unique names
  explicit BatchList(std::vector<std::string> columns = {}) : columns_(std::move(columns)) {}

  /// Adds a row.
  /// @param line   line of the list, from 1, in which the row begins
  /// @param cells  one per column
  void addRow(std::uint32_t line, std::span<const std::string> cells);

  const std::vector<std::string>& columns() const { return columns_; }
  std::optional<std::size_t> find(std::string_view column) const;
  std::size_t size() const { return lines_.size(); }
  std::uint32_t line(std::size_t row) const { return lines_[row]; }
  std::string_view cell(std::size_t row, std::size_t column) const;

 private:
  std::vector<std::string> columns_;
  std::string cells_;
  std::vector<std::size_t> ends_;  // end of each cell in cells_
  std::vector<std::uint32_t> lines_;
};

/// Limit for a cell. Longer cells cannot be the text of a code: the largest symbol holds 7,089 digits.
inline constexpr std::size_t kMostCellBytes = 16384;

/// Limit for columns. A list with more is not a list of parts, and every row keeps a cell for each column.
inline constexpr std::size_t kMostColumns = 1000;

/// Limit for a line. Longer lines are not rows.
inline constexpr std::size_t kMostLineBytes = 1 << 20;

/// Reads a list in one of two formats: CSV [RFC 4180], separated by commas, semicolons or tabs, with the columns' names
/// in the first row; or JSON lines, with one object per line, whose keys are columns and whose values are texts,
/// numbers, switches or lists of numbers (a missing key gives an empty cell). The first character tells which format it
/// is. UTF-8, with or without a byte order mark. Skips spaces around cells and empty lines.
///
/// Cost: linear.
/// @returns BadInput, with line and column, for a malformed list; for cells that hold a formula instead of its value;
///          for a list without rows
Result<BatchList> readBatchList(std::span<const std::uint8_t> bytes);

/// Returns rows without cells, for templates that need only the row's number.
BatchList countedBatchList(std::size_t rows);

}  // namespace qrelief
