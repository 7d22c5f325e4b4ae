// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/plane_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qrelief {
namespace {

constexpr int kMaxCells = 512;       // along an edge: 1 MB of cells
constexpr double kCellSlack = 1e-6;  // of a cell: shapes on a cell's border belong to both sides

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Returns the range of u that a shape covers where bottom ≤ v ≤ top; empty if it covers none.
Range rangeBetween(const Triangle2& shape, double bottom, double top) {
  Range range;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 a = shape[k];
    const Vec2 b = shape[(k + 1) % 3];
    if (a.y >= bottom && a.y <= top) range.add(a.x);
    for (const double v : {bottom, top})
      if ((a.y < v) != (b.y < v)) range.add(a.x + (b.x - a.x) * ((v - a.y) / (b.y - a.y)));
  }
  return range;
}

int clampedCell(double position, int size) {
  return static_cast<int>(std::clamp(std::floor(position), 0.0, static_cast<double>(size - 1)));
}

}  // namespace

int PlaneGrid::column(double u) const { return clampedCell((u - min_.x) / cell_.x, size_); }
int PlaneGrid::row(double v) const { return clampedCell((v - min_.y) / cell_.y, size_); }

template <class Visit>
void PlaneGrid::forEachCell(const Triangle2& shape, Visit&& visit) const {
  const Vec2 slack = cell_ * kCellSlack;
  const Vec2 low = glm::min(glm::min(shape[0], shape[1]), shape[2]) - slack;
  const Vec2 high = glm::max(glm::max(shape[0], shape[1]), shape[2]) + slack;
  const int firstRow = row(low.y);
  const int lastRow = row(high.y);
  const int firstColumn = column(low.x);
  const int lastColumn = column(high.x);
  for (int j = firstRow; j <= lastRow; ++j) {
    int from = firstColumn;
    int to = lastColumn;
    if (firstRow != lastRow && firstColumn != lastColumn) {
      // The outermost rows extend to infinity.
      const double bottom = j == 0 ? low.y : min_.y + j * cell_.y - slack.y;
      const double top = j == size_ - 1 ? high.y : min_.y + (j + 1) * cell_.y + slack.y;
      const Range range = rangeBetween(shape, bottom, top);
      if (range.low > range.high) continue;
      from = column(range.low - slack.x);
      to = column(range.high + slack.x);
    }
    for (int i = from; i <= to; ++i) visit(static_cast<std::size_t>(j * size_ + i));
  }
}

PlaneGrid::PlaneGrid(std::span<const Triangle2> shapes, double halfWidth) : lastQuery_(shapes.size(), 0) {
  if (shapes.empty()) return;
  Vec2 low(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (const Triangle2& shape : shapes) {
    for (const Vec2 p : shape) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  min_ = glm::clamp(low, Vec2(-halfWidth), Vec2(halfWidth));
  const Vec2 extent = glm::clamp(high, Vec2(-halfWidth), Vec2(halfWidth)) - min_;
  size_ = std::clamp(static_cast<int>(2 * std::sqrt(static_cast<double>(shapes.size()))), 1, kMaxCells);
  for (int k = 0; k < 2; ++k) cell_[k] = extent[k] > 0 ? extent[k] / size_ : 1;

  // Counting sort by cell.
  begin_.assign(static_cast<std::size_t>(size_ * size_) + 1, 0);
  for (const Triangle2& shape : shapes) forEachCell(shape, [&](std::size_t cell) { ++begin_[cell + 1]; });
  for (std::size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
  items_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t item = 0; item < shapes.size(); ++item)
    forEachCell(shapes[item], [&](std::size_t cell) { items_[next[cell]++] = item; });
}

std::span<const std::uint32_t> PlaneGrid::near(const Triangle2& shape) {
  found_.clear();
  if (size_ == 0) return found_;
  ++query_;
  forEachCell(shape, [&](std::size_t cell) {
    for (std::uint32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) {
      const std::uint32_t item = items_[k];
      if (lastQuery_[item] == query_) continue;
      lastQuery_[item] = query_;
      found_.push_back(item);
    }
  });
  return found_;
}

}  // namespace qrelief
