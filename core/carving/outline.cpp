// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace qrelief {
namespace {

constexpr std::uint32_t kNoNode = 0xffffffffu;

/// The four cells around a grid corner.
struct Corner {
  int nw, ne, se, sw;

  bool onOutline() const { return nw != ne || ne != se || se != sw; }
  bool straight() const { return (nw == ne && sw == se) || (nw == sw && ne == se); }
  bool fallingSaddle() const { return std::min(nw, se) > std::max(ne, sw); }  ///< deep along "\"
  bool risingSaddle() const { return std::min(ne, sw) > std::max(nw, se); }   ///< deep along "/"
};

class OutlineBuilder {
 public:
  OutlineBuilder(const DepthLevels& levels, double chamferMm, int maxCells, bool resampled)
      : levels_(levels),
        resampled_(resampled),
        chamferMm_(chamferMm),
        shift_(chamferMm / 2 / std::sqrt(2.0)),
        maxCells_(maxCells),
        side_(levels.size + 1) {
    assert(maxCells >= 1);
    northNode_.assign(static_cast<std::size_t>(side_ * side_), kNoNode);
    southNode_ = northNode_;
  }

  OutlineGraph build() {
    for (int row = 0; row < side_; ++row)
      for (int column = 0; column < side_; ++column) addNodes(row, column);
    for (int row = 0; row < side_; ++row)
      for (int column = 0; column < side_; ++column) {
        traceEast(row, column);
        traceSouth(row, column);
      }
    return std::move(graph_);
  }

 private:
  std::size_t index(int row, int column) const { return static_cast<std::size_t>(row * side_ + column); }

  Corner around(int row, int column) const {
    return {levels_.at(row - 1, column - 1), levels_.at(row - 1, column), levels_.at(row, column),
            levels_.at(row, column - 1)};
  }

  std::uint32_t addNode(Vec2 position, double leewayMm) {
    graph_.nodes.push_back(position);
    graph_.leewayMm.push_back(leewayMm);
    return static_cast<std::uint32_t>(graph_.nodes.size() - 1);
  }

  /// Adds an outline inside the square, or along its border with the square on one side.
  void addOutline(std::uint32_t from, std::uint32_t to, int left, int right, bool squareLeft, bool squareRight) {
    const Outline outline{from, to, left, right, resampled_ && squareLeft, resampled_ && squareRight};
    if (left != right || outline.boundsGrid()) graph_.outlines.push_back(outline);
  }

  /// Adds a corner's nodes. A saddle has two: a falling saddle's north and west arms end at the first and the others at
  /// the second; a rising saddle's north and east arms end at the first.
  void addNodes(int row, int column) {
    const Corner c = around(row, column);
    const Vec2 p = levels_.corner(row, column);
    const std::size_t k = index(row, column);
    const bool fixed = resampled_ && row > 0 && column > 0 && row < levels_.size && column < levels_.size;
    const double saddleLeeway = fixed ? 0 : 0.4 * chamferMm_;     // leaves a fifth of the band
    const double leeway = fixed ? 0 : levels_.submoduleMm() / 8;  // keeps outlines to the next corners apart
    if (c.fallingSaddle()) {
      northNode_[k] = addNode(p + Vec2(-shift_, shift_), saddleLeeway);
      southNode_[k] = addNode(p + Vec2(shift_, -shift_), saddleLeeway);
      addOutline(northNode_[k], southNode_[k], c.ne, c.sw, true, true);
    } else if (c.risingSaddle()) {
      northNode_[k] = addNode(p + Vec2(shift_, shift_), saddleLeeway);
      southNode_[k] = addNode(p + Vec2(-shift_, -shift_), saddleLeeway);
      addOutline(northNode_[k], southNode_[k], c.se, c.nw, true, true);
    } else if (resampled_ || (c.onOutline() && (!c.straight() || (row + column) % maxCells_ == 0))) {
      northNode_[k] = southNode_[k] = addNode(p, leeway);
    }
  }

  bool isNode(int row, int column) const { return northNode_[index(row, column)] != kNoNode; }

  std::uint32_t northArm(int row, int column) const { return northNode_[index(row, column)]; }
  std::uint32_t southArm(int row, int column) const { return southNode_[index(row, column)]; }
  std::uint32_t westArm(int row, int column) const {
    return (around(row, column).risingSaddle() ? southNode_ : northNode_)[index(row, column)];
  }
  std::uint32_t eastArm(int row, int column) const {
    return (around(row, column).risingSaddle() ? northNode_ : southNode_)[index(row, column)];
  }

  void traceEast(int row, int column) {
    const Corner c = around(row, column);
    const bool squareNorth = row > 0, squareSouth = row < levels_.size;
    const bool border = resampled_ && column < levels_.size && squareNorth != squareSouth;
    if (!isNode(row, column) || (c.ne == c.se && !border)) return;
    int end = column + 1;
    while (!isNode(row, end)) ++end;  // an outline ends in a node: its last corner turns
    addOutline(eastArm(row, column), westArm(row, end), c.ne, c.se, squareNorth, squareSouth);
  }

  void traceSouth(int row, int column) {
    const Corner c = around(row, column);
    const bool squareWest = column > 0, squareEast = column < levels_.size;
    const bool border = resampled_ && row < levels_.size && squareWest != squareEast;
    if (!isNode(row, column) || (c.sw == c.se && !border)) return;
    int end = row + 1;
    while (!isNode(end, column)) ++end;
    addOutline(southArm(row, column), northArm(end, column), c.se, c.sw, squareEast, squareWest);
  }

  const DepthLevels& levels_;
  const bool resampled_;
  const double chamferMm_;
  const double shift_;  // shift of a saddle's nodes along u and v
  const int maxCells_;
  const int side_;  // grid corners along an edge
  std::vector<std::uint32_t> northNode_, southNode_;
  OutlineGraph graph_;
};

}  // namespace

OutlineGraph buildOutlines(const DepthLevels& levels, double chamferMm, int maxCells) {
  return OutlineBuilder(levels, chamferMm, maxCells, false).build();
}

OutlineGraph buildGridOutlines(const DepthLevels& levels, double chamferMm) {
  return OutlineBuilder(levels, chamferMm, 1, true).build();
}

}  // namespace qrelief
