// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace qrelief {

/// The row that a grid begins with: the top one, as in symbols and images, or the bottom one, as in GL textures.
enum class RowOrder : bool { TopFirst, BottomFirst };

/// A value for each cell of a rectangle, row-major.
template <class T, RowOrder kOrder = RowOrder::TopFirst>
class Grid {
 public:
  Grid() = default;
  Grid(int rows, int columns, const T& value = T())
      : rows_(rows),
        columns_(columns),
        values_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns), value) {}
  /// @param values  rows · columns
  Grid(int rows, int columns, std::vector<T> values) : rows_(rows), columns_(columns), values_(std::move(values)) {
    assert(values_.size() == static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
  }

  /// Converts each value.
  template <class Other>
  explicit Grid(const Grid<Other, kOrder>& grid)
      : rows_(grid.rows()), columns_(grid.columns()), values_(grid.begin(), grid.end()) {}

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  bool contains(int row, int column) const { return row >= 0 && column >= 0 && row < rows_ && column < columns_; }

  T& at(int row, int column) { return values_[index(row, column)]; }
  const T& at(int row, int column) const { return values_[index(row, column)]; }

  // The cells in their order.
  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  std::size_t index(int row, int column) const {
    assert(contains(row, column));
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  T& operator[](std::size_t cell) { return values_[cell]; }
  const T& operator[](std::size_t cell) const { return values_[cell]; }
  auto begin() { return values_.begin(); }
  auto begin() const { return values_.begin(); }
  auto end() { return values_.end(); }
  auto end() const { return values_.end(); }
  const std::vector<T>& values() const& { return values_; }
  std::vector<T> values() && { return std::move(values_); }

  bool operator==(const Grid&) const = default;

 private:
  int rows_ = 0, columns_ = 0;
  std::vector<T> values_;
};

/// A grid whose row 0 is at the bottom.
template <class T>
using BottomUp = Grid<T, RowOrder::BottomFirst>;

/// Returns the same picture in the other order of rows.
template <class T>
BottomUp<T> bottomUp(const Grid<T>& grid) {
  BottomUp<T> turned(grid.rows(), grid.columns());
  for (int row = 0; row < grid.rows(); ++row)
    std::copy_n(grid.begin() + static_cast<std::ptrdiff_t>(grid.index(row, 0)), grid.columns(),
                turned.begin() + static_cast<std::ptrdiff_t>(turned.index(grid.rows() - 1 - row, 0)));
  return turned;
}

}  // namespace qrelief
