// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "projection/plane_shapes.h"

namespace qrelief {

/// Uniform bins over the QR plane that find the shapes near a given shape.
///
/// Shapes are entered row by row into the cells they cross, not by their boxes, so long slanted shapes cost no more
/// than their length. Memory: about four cells per shape.
class PlaneGrid {
 public:
  /// @param shapes     finite coordinates; may be empty
  /// @param halfWidth  the bins cover at most the square |u|, |v| ≤ halfWidth (> 0, may be infinite); shapes farther
  ///                   out fall into the outermost bins, where searches are correct but slower
  PlaneGrid(std::span<const Triangle2> shapes, double halfWidth);

  /// Returns the indices of all shapes that may meet `shape`, each once, in no particular order; valid until the next
  /// call.
  std::span<const std::uint32_t> near(const Triangle2& shape);

  /// Returns true if near() finds a shape. Cost: the cells before the first with a shape.
  bool anyNear(const Triangle2& shape) const;

  /// Returns the number of entries that near() has looked at so far: shapes, once for each cell.
  std::size_t looked() const { return looked_; }

 private:
  template <class Visit>
  void visitCells(const Triangle2& shape, Visit&& visit) const;
  int column(double u) const;
  int row(double v) const;

  int size_ = 0;  // cells along an edge; 0 = empty
  Vec2 min_{0};
  Vec2 cell_{1};
  std::vector<std::uint32_t> begin_;  // per cell, into items_
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> lastQuery_;  // per shape
  std::uint32_t query_ = 0;
  std::size_t looked_ = 0;
  std::vector<std::uint32_t> found_;
};

}  // namespace qrelief
