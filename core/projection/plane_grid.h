// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "projection/plane_shapes.h"

namespace qrelief {

/// Uniform bins over the QR plane that answer "which of these shapes may meet that one?".
///
/// Shapes are entered row by row into the cells they cross, not by their boxes, so that long slanted ones cost no more
/// than their length. Memory: about four cells a shape.
class PlaneGrid {
 public:
  /// @param shapes     finite coordinates; may be empty
  /// @param halfWidth  the bins cover at most the square |u|, |v| ≤ halfWidth (> 0, may be infinite); what lies
  ///                   farther out falls into the outermost bins, found as surely but more slowly
  PlaneGrid(std::span<const Triangle2> shapes, double halfWidth);

  /// Indices of all shapes that may meet `shape`, each once, in no useful order; valid until the next call.
  std::span<const std::uint32_t> near(const Triangle2& shape);

 private:
  template <class Visit>
  void forEachCell(const Triangle2& shape, Visit&& visit) const;
  int column(double u) const;
  int row(double v) const;

  int size_ = 0;  // cells along an edge; 0 = nothing in it
  Vec2 min_{0};
  Vec2 cell_{1};
  std::vector<std::uint32_t> begin_;  // per cell, into items_
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> lastQuery_;  // per shape
  std::uint32_t query_ = 0;
  std::vector<std::uint32_t> found_;
};

}  // namespace qrelief
