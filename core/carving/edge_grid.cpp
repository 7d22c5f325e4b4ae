// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/edge_grid.h"

#include <algorithm>
#include <cmath>

namespace qrelief {

EdgeGrid::EdgeGrid(std::vector<Edge> edges) : edges_(std::move(edges)), lastQuery_(edges_.size(), 0) {
  if (edges_.empty()) {
    firstEntry_.assign(2, 0);
    return;
  }
  Vec2 lo = edges_[0][0], hi = edges_[0][0];
  for (const Edge& e : edges_) {
    lo = glm::min(lo, glm::min(e[0], e[1]));
    hi = glm::max(hi, glm::max(e[0], e[1]));
  }
  const Vec2 extent = hi - lo;
  const double longest = std::max(extent.x, extent.y);
  const double perEdge = std::sqrt(extent.x * extent.y / static_cast<double>(edges_.size()));
  origin_ = lo;
  binMm_ = std::max({perEdge, longest / static_cast<double>(edges_.size()), longest / 4096, 1e-9});
  bins_ = {static_cast<int>(extent.x / binMm_) + 1, static_cast<int>(extent.y / binMm_) + 1};

  firstEntry_.assign(static_cast<std::size_t>(bins_[0]) * static_cast<std::size_t>(bins_[1]) + 1, 0);
  for (const Edge& e : edges_) visitBins(e, [&](std::size_t bin) { ++firstEntry_[bin + 1]; });
  for (std::size_t bin = 1; bin < firstEntry_.size(); ++bin) firstEntry_[bin] += firstEntry_[bin - 1];
  entries_.resize(firstEntry_.back());
  std::vector<std::uint32_t> next(firstEntry_.begin(), firstEntry_.end() - 1);
  for (std::uint32_t k = 0; k < edges_.size(); ++k)
    visitBins(edges_[k], [&](std::size_t bin) { entries_[next[bin]++] = k; });
}

EdgeGrid::BinRange EdgeGrid::binsAlong(int axis, double lo, double hi) const {
  const double last = bins_[axis] - 1;
  return {static_cast<int>(std::clamp(std::floor((lo - origin_[axis]) / binMm_), 0.0, last)),
          static_cast<int>(std::clamp(std::floor((hi - origin_[axis]) / binMm_), 0.0, last))};
}

template <class Visit>
void EdgeGrid::visitBins(const Edge& edge, const Visit& visit) const {
  // Visit column by column. The slack is far more than the rounding of the clip and far less than a bin.
  const double slack = binMm_ * 1e-6;
  const Vec2 a = edge[0].x <= edge[1].x ? edge[0] : edge[1];
  const Vec2 b = edge[0].x <= edge[1].x ? edge[1] : edge[0];
  const BinRange columns = binsAlong(0, a.x - slack, b.x + slack);
  for (int column = columns.first; column <= columns.last; ++column) {
    const double left = origin_.x + column * binMm_ - slack;
    const double right = left + binMm_ + 2 * slack;
    const auto heightAt = [&](double x) {
      return b.x > a.x ? a.y + (b.y - a.y) * std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0) : a.y;
    };
    double y0 = heightAt(left), y1 = heightAt(right);
    if (b.x - a.x <= 2 * slack) y0 = a.y, y1 = b.y;  // upright edge: clipping by columns is meaningless
    const BinRange rows = binsAlong(1, std::min(y0, y1) - slack, std::max(y0, y1) + slack);
    for (int row = rows.first; row <= rows.last; ++row)
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(bins_[0]) + static_cast<std::size_t>(column));
  }
}

std::span<const std::uint32_t> EdgeGrid::near(Vec2 lo, Vec2 hi) {
  found_.clear();
  ++query_;
  const BinRange columns = binsAlong(0, lo.x, hi.x);
  const BinRange rows = binsAlong(1, lo.y, hi.y);
  for (int row = rows.first; row <= rows.last; ++row)
    for (int column = columns.first; column <= columns.last; ++column) {
      const std::size_t bin =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(bins_[0]) + static_cast<std::size_t>(column);
      for (std::uint32_t k = firstEntry_[bin]; k < firstEntry_[bin + 1]; ++k) {
        const std::uint32_t e = entries_[k];
        if (lastQuery_[e] == query_) continue;
        lastQuery_[e] = query_;
        found_.push_back(e);
      }
    }
  return found_;
}

}  // namespace qrelief
