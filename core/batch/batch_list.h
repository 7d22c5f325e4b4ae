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
  /// @param columns  unique names, whatever their capitals
  explicit BatchList(std::vector<std::string> columns = {}) : columns_(std::move(columns)) {}

  /// Adds a row.
  /// @param line   line of the list, from 1, in which the row begins
  /// @param cells  one per column
  void addRow(std::uint32_t line, std::span<const std::string> cells);

  const std::vector<std::string>& columns() const { return columns_; }
  /// Returns the column of that name. Capitals do not count.
  std::optional<std::size_t> find(std::string_view column) const;
  std::size_t size() const { return lines_.size(); }
  std::uint32_t line(std::size_t row) const { return lines_[row]; }
  std::string_view cell(std::size_t row, std::size_t column) const;

  /// Says what the reader had to guess.
  const std::vector<Message>& warnings() const { return warnings_; }
  void warn(Message guess) { warnings_.push_back(std::move(guess)); }

 private:
  std::vector<std::string> columns_;
  std::string cells_;
  std::vector<std::size_t> ends_;  // end of each cell in cells_
  std::vector<std::uint32_t> lines_;
  std::vector<Message> warnings_;
};

/// Limit for a cell. Longer cells cannot be the text of a code: the largest symbol holds 7,089 digits.
inline constexpr std::size_t kMostCellBytes = 16384;

/// Limit for columns. A list with more is not a list of parts, and every row keeps a cell for each column.
inline constexpr std::size_t kMostColumns = 1000;

/// Limit for a line. Longer lines are not rows.
inline constexpr std::size_t kMostLineBytes = 1 << 20;

struct BatchListOptions {
  /// True if the first row of a CSV table names its columns. None: true unless that row has a link.
  std::optional<bool> hasNames = std::nullopt;
};

/// Reads a list as spreadsheets and programs write it. The first character tells which format it is:
///
/// - CSV [RFC 4180], separated by commas, semicolons, tabs or bars, or as a first line such as "sep=;" says. The first
///   row has the columns' names. Columns without a name must be empty. If the first row has a link, it is a row like
///   the others: the column of its first link, or the only column, is called `text`, and the others `column1`,
///   `column2` and so on.
/// - JSON lines, with one object per line, or a JSON array of objects. Keys are columns, and values are texts, numbers,
///   switches or lists of numbers; null or a missing key gives an empty cell. A number keeps its characters.
///
/// UTF-8, with or without a byte order mark, or UTF-16. CSV may be in Windows-1252 if nothing beyond ASCII in it is
/// valid UTF-8. Skips spaces around cells, empty lines and rows of empty cells; warns of lines that hold only spaces.
///
/// Cost: linear.
/// @returns BadInput, with line and column, for a malformed list; for cells that hold a formula instead of its value;
///          for a list without rows
Result<BatchList> readBatchList(std::span<const std::uint8_t> bytes, const BatchListOptions& options = {});

/// Returns rows without cells, for templates that need only the row's number.
BatchList countedBatchList(std::size_t rows);

}  // namespace qrelief
