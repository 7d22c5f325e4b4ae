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

/// The rows of a batch as their list has them: cells of text by column. A million rows take the list's own size and 8
/// bytes a cell.
class BatchList {
 public:
  /// @param columns  no name twice
  explicit BatchList(std::vector<std::string> columns = {}) : columns_(std::move(columns)) {}

  /// @param line   of the list, from 1, in which the row begins
  /// @param cells  one a column
  void addRow(std::uint32_t line, std::span<const std::string> cells);

  const std::vector<std::string>& columns() const { return columns_; }
  std::optional<std::size_t> find(std::string_view column) const;
  std::size_t size() const { return lines_.size(); }
  std::uint32_t line(std::size_t row) const { return lines_[row]; }
  std::string_view cell(std::size_t row, std::size_t column) const;

 private:
  std::vector<std::string> columns_;
  std::string cells_;
  std::vector<std::size_t> ends_;  // of each cell in cells_
  std::vector<std::uint32_t> lines_;
};

/// Longer cells are no text of a code: the largest symbol takes 7,089 digits.
inline constexpr std::size_t kMostCellBytes = 16384;

/// More columns are no list of parts; rows are kept with a cell for each.
inline constexpr std::size_t kMostColumns = 1000;

/// Longer lines are no rows but something else.
inline constexpr std::size_t kMostLineBytes = 1 << 20;

/// Reads a list: CSV [RFC 4180], separated by commas, semicolons or tabs, its first row naming the columns; or JSON
/// lines, an object a line whose keys are columns and whose values are texts, numbers, switches or lists of numbers
/// (what is missing is an empty cell). Which of them it is, its first character says. UTF-8, with or without a byte
/// order mark; spaces round a cell and empty lines are passed over.
///
/// Cost: linear.
/// @returns BadInput for what cannot be read so, with line and column; for cells that hold a formula in place of its
///          value; for a list without rows
Result<BatchList> readBatchList(std::span<const std::uint8_t> bytes);

/// Rows without cells, for templates that need nothing but the number.
BatchList countedBatchList(std::size_t rows);

}  // namespace qrelief
