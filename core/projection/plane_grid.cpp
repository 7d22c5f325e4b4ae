// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/plane_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/triangle_bands.h"

namespace qrelief {
namespace {

constexpr int kMaxCells = 512;       // along an edge: 1 MB of cells
constexpr double kCellSlack = 1e-6;  // of a cell: shapes on a cell's border belong to both sides

int clampedCell(double position, int size) {
  return static_cast<int>(std::clamp(std::floor(position), 0.0, static_cast<double>(size - 1)));
}

}  // namespace

int PlaneGrid::column(double u) const { return clampedCell((u - min_.x) / cell_.x, size_); }
int PlaneGrid::row(double v) const { return clampedCell((v - min_.y) / cell_.y, size_); }

/// Calls visit(cell) for the cells that a shape crosses, until one returns false.
template <class Visit>
void PlaneGrid::visitCells(const Triangle2& shape, Visit&& visit) const {
  const Vec2 slack = cell_ * kCellSlack;
  const Vec2 low = glm::min(glm::min(shape[0], shape[1]), shape[2]) - slack;
  const Vec2 high = glm::max(glm::max(shape[0], shape[1]), shape[2]) + slack;
  const int firstRow = row(low.y);
  const int lastRow = row(high.y);
  const int firstColumn = column(low.x);
  const int lastColumn = column(high.x);
  const auto visitRow = [&](int j, int from, int to) {
    for (int i = from; i <= to; ++i)
      if (!visit(static_cast<std::size_t>(j * size_ + i))) return false;
    return true;
  };
  if (firstRow == lastRow || firstColumn == lastColumn) {
    for (int j = firstRow; j <= lastRow; ++j)
      if (!visitRow(j, firstColumn, lastColumn)) return;
    return;
  }
  const TriangleBands<double> bands(shape[0], shape[1], shape[2]);
  for (int j = firstRow; j <= lastRow; ++j) {
    // The outermost rows extend to infinity.
    const double bottom = j == 0 ? low.y : min_.y + j * cell_.y - slack.y;
    const double top = j == size_ - 1 ? high.y : min_.y + (j + 1) * cell_.y + slack.y;
    const auto [least, greatest] = bands.between(bottom, top);
    if (least <= greatest && !visitRow(j, column(least - slack.x), column(greatest + slack.x))) return;
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
  for (const Triangle2& shape : shapes)
    visitCells(shape, [&](std::size_t cell) {
      ++begin_[cell + 1];
      return true;
    });
  for (std::size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
  items_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t item = 0; item < shapes.size(); ++item)
    visitCells(shapes[item], [&](std::size_t cell) {
      items_[next[cell]++] = item;
      return true;
    });
}

std::span<const std::uint32_t> PlaneGrid::near(const Triangle2& shape) {
  found_.clear();
  if (size_ == 0) return found_;
  ++query_;
  visitCells(shape, [&](std::size_t cell) {
    looked_ += begin_[cell + 1] - begin_[cell];
    for (std::uint32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) {
      const std::uint32_t item = items_[k];
      if (lastQuery_[item] == query_) continue;
      lastQuery_[item] = query_;
      found_.push_back(item);
    }
    return true;
  });
  return found_;
}

bool PlaneGrid::anyNear(const Triangle2& shape) const {
  bool isAny = false;
  if (size_ > 0) visitCells(shape, [&](std::size_t cell) { return !(isAny = begin_[cell] < begin_[cell + 1]); });
  return isAny;
}

}  // namespace qrelief
