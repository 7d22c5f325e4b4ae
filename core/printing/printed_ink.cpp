// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/printed_ink.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/parallel.h"
#include "label/ring_coverage.h"

namespace qrelief {
namespace {

constexpr int kNodesPerLine = 13;  // odd: a node is the middle of a line
constexpr int kMaxNodes = 2000;    // along an edge
constexpr int kMargin = 2 * kNodesPerLine;
constexpr int kRowsAtOnce = 16;  // a cache line of the transposed map
constexpr int kSamples = 3;      // of a pixel, along its edge
constexpr double kRounding = 1e-9;
constexpr double kBlurReach = 3;   // in standard deviations
constexpr int kRingPixels = 1500;  // along the edge of the picture of the outlines

/// A set of nodes of a row, with a margin beyond its ends. Node c is bit kMargin + c.
using NodeRow = std::bitset<2 * kMargin + kMaxNodes>;
/// Rows from the bottom up.
using NodeSet = std::vector<NodeRow>;

/// A square grid whose rows are horizontal in the printer, centred on the code.
struct Nodes {
  double stepMm = 0;
  NodeSet dark;

  int edge() const { return static_cast<int>(dark.size()); }
  Vec2 at(int column, int row) const { return stepMm * (Vec2(column, row) + 0.5 - edge() / 2.0); }
};

/// How the QR plane lies in the printer.
struct Slope {
  Vec2 across{1, 0}, uphill{0, 1};  ///< unit vectors on the plane: level, and up the slope
  double sine = 0, cosine = 1;      ///< of the angle θ between plane and horizontal
  double centreMm = 0;              ///< height of the code's centre over the bed

  explicit Slope(const PrintedInkRequest& request) {
    const Vec3 up = glm::normalize(request.buildUp);
    const Vec2 rise(glm::dot(request.frame.right, up), glm::dot(request.frame.up, up));
    sine = std::min(1.0, glm::length(rise));
    cosine = std::sqrt(1 - sine * sine);
    centreMm = glm::dot(request.frame.centre, up) - request.bedMm;
    if (sine < 1e-9) return;
    uphill = rise / glm::length(rise);
    across = {uphill.y, -uphill.x};
  }

  /// Returns the place up the slope whose material a strip shows.
  double visiblePlace(double uphillMm, double layerMm) const {
    if (sine < 1e-9) return uphillMm;
    const double height = centreMm + uphillMm * sine, strip = layerMm / sine;
    const double bottomMm = (std::floor(height / layerMm) * layerMm - centreMm) / sine;
    const double within = uphillMm - bottomMm;
    // Below: the riser of this layer, seen layer·sin θ high, then its tread.
    const double riser = std::min(strip, layerMm * sine);
    return (within < riser ? bottomMm + riser : uphillMm) - layerMm / 2 * sine;
  }
};

bool isDark(const Symbol& symbol, double symbolMm, Vec2 onPlane) {
  const double moduleMm = symbolMm / symbol.size;
  const double column = std::floor((onPlane.x + symbolMm / 2) / moduleMm);
  const double row = std::floor((symbolMm / 2 - onPlane.y) / moduleMm);
  if (column < 0 || row < 0 || column >= symbol.size || row >= symbol.size) return false;
  return symbol.isDark(static_cast<int>(row), static_cast<int>(column));
}

/// The outlines around the symbol as pixels.
struct Around {
  double edgeMm = 0;
  std::vector<std::uint8_t> coverage;

  /// @param edge  of the square that is looked at, mm
  Around(const std::vector<Ring>& rings, double edge) : edgeMm(edge) {
    if (!rings.empty()) coverage = ringCoverage(rings, kRingPixels, edge);
  }
  bool isDark(Vec2 onPlane) const {
    if (coverage.empty()) return false;
    const Vec2 pixel = static_cast<double>(kRingPixels) * (Vec2(0.5) + Vec2(onPlane.x, -onPlane.y) / edgeMm);
    if (!(pixel.x >= 0 && pixel.y >= 0 && pixel.x < kRingPixels && pixel.y < kRingPixels)) return false;
    return coverage[static_cast<std::size_t>(pixel.y) * kRingPixels + static_cast<std::size_t>(pixel.x)] > 127;
  }
};

/// @param pictureMm  edge of the picture that is made of it
Nodes slicedCode(const PrintedInkRequest& request, const Slope& slope, double pictureMm) {
  const double lineMm = 2 * request.process.cornerRadiusMm;
  const double shownMm = request.around.empty() ? request.symbolMm : std::max(request.symbolMm, pictureMm);
  const double edgeMm = std::numbers::sqrt2 * shownMm + 4 * lineMm;
  const Around around(request.around, edgeMm);
  const int edge = static_cast<int>(std::ceil(std::min<double>(kMaxNodes, edgeMm / lineMm * kNodesPerLine)));
  Nodes nodes{edgeMm / edge, NodeSet(edge)};
  parallelFor(edge, [&](int row) {
    for (int column = 0; column < edge; ++column) {
      const Vec2 at = nodes.at(column, row);
      const Vec2 onPlane = slope.across * at.x + slope.uphill * slope.visiblePlace(at.y, request.process.layerMm);
      if (isDark(request.symbol, request.symbolMm, onPlane) || around.isDark(onPlane))
        nodes.dark[row].set(kMargin + column);
    }
  });
  return nodes;
}

/// Returns the nodes around which the set holds a whole ellipse [erosion]. Beyond the lowest and the highest row it
/// holds everything.
/// @param halfWidths  of the ellipse in each row from its middle, in nodes, the widest first
NodeSet eroded(const NodeSet& set, const std::vector<int>& halfWidths) {
  const int edge = static_cast<int>(set.size()), reach = static_cast<int>(halfWidths.size()) - 1;
  std::vector<NodeSet> narrowed(halfWidths[0] + 1, NodeSet(edge));  // by each width
  parallelFor(edge, [&](int row) {
    NodeRow whole = narrowed[0][row] = set[row];
    for (int width = 1; width <= halfWidths[0]; ++width)
      narrowed[width][row] = whole &= (set[row] << width) & (set[row] >> width);
  });
  NodeSet result(edge, ~NodeRow());
  parallelFor(edge, [&](int row) {
    for (int k = -reach; k <= reach; ++k)
      if (row + k >= 0 && row + k < edge) result[row] &= narrowed[halfWidths[std::abs(k)]][row + k];
  });
  return result;
}

NodeSet complement(NodeSet set) {
  for (NodeRow& row : set) row.flip();
  return set;
}

/// Returns the nodes of a set that an elliptical line covers without leaving the set [opening].
NodeSet opened(const NodeSet& set, const std::vector<int>& halfWidths) {
  return complement(eroded(complement(eroded(set, halfWidths)), halfWidths));  // dilation of the erosion
}

std::vector<int> lineOutline(const Nodes& nodes, double radiusMm, double cosine) {
  std::vector<int> halfWidths;
  const double radius = radiusMm / nodes.stepMm, height = radius * cosine;
  for (int k = 0; k <= height; ++k) {
    const double share = height > 0 ? k / height : 0;
    const double reach = radius * std::sqrt(1 - share * share) - 0.5;
    halfWidths.push_back(std::max(0, static_cast<int>(std::floor(reach + kRounding))));
  }
  return halfWidths;
}

/// Blurs along the rows and transposes; two calls blur both ways.
BottomUp<float> blurredAcross(const BottomUp<float>& map, double sigma) {
  const int edge = map.rows();
  const int reach = static_cast<int>(std::ceil(kBlurReach * sigma));
  std::vector<float> weights;
  double sum = 0;
  for (int k = -reach; k <= reach; ++k) sum += std::exp(-k * k / (2 * sigma * sigma));
  for (int k = -reach; k <= reach; ++k)
    weights.push_back(static_cast<float>(std::exp(-k * k / (2 * sigma * sigma)) / sum));
  BottomUp<float> blurred(edge, edge);
  parallelFor((edge + kRowsAtOnce - 1) / kRowsAtOnce, [&](int block) {
    const int first = block * kRowsAtOnce, rows = std::min(kRowsAtOnce, edge - first);
    std::vector<float> padded;  // a row, continued by the values at its ends
    std::vector<float> sums(static_cast<std::size_t>(rows * edge), 0.0f);
    for (int row = 0; row < rows; ++row) {
      padded.assign(reach, map.at(first + row, 0));
      for (int column = 0; column < edge; ++column) padded.push_back(map.at(first + row, column));
      padded.insert(padded.end(), reach, map.at(first + row, edge - 1));
      float* const blurredRow = sums.data() + static_cast<std::size_t>(row * edge);
      for (std::size_t k = 0; k < weights.size(); ++k)
        for (int column = 0; column < edge; ++column) blurredRow[column] += weights[k] * padded[k + column];
    }
    for (int column = 0; column < edge; ++column)
      for (int row = 0; row < rows; ++row)
        blurred.at(column, first + row) = sums[static_cast<std::size_t>(row * edge + column)];
  });
  return blurred;
}

}  // namespace

BottomUp<float> printedInk(const PrintedInkRequest& request, const InkGrid& grid) {
  const Slope slope(request);
  const Nodes nodes = slicedCode(request, slope, grid.pixelMm * grid.pixels);
  const std::vector<int> line = lineOutline(nodes, request.process.cornerRadiusMm, slope.cosine);
  const NodeSet dark = opened(nodes.dark, line), light = opened(complement(nodes.dark), line);
  BottomUp<float> shares(nodes.edge(), nodes.edge());
  for (int row = 0; row < nodes.edge(); ++row) {
    const NodeRow inked = dark[row] | (~nodes.dark[row] & ~light[row]);
    for (int column = 0; column < nodes.edge(); ++column)
      shares.at(row, column) = inked[kMargin + column] ? 1.0f : 0.0f;
  }
  const double sigma = kBleedLines * 2 * request.process.cornerRadiusMm / nodes.stepMm;
  shares = blurredAcross(blurredAcross(shares, sigma), sigma);

  BottomUp<float> picture(grid.pixels, grid.pixels);
  parallelFor(grid.pixels, [&](int row) {
    for (int column = 0; column < grid.pixels; ++column) {
      float sum = 0;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const int right = k % kSamples, above = k / kSamples;
        const Vec2 pixel(column + (right + 0.5) / kSamples, row + (above + 0.5) / kSamples);
        const Vec2 onPlane = grid.pixelMm * (pixel - grid.pixels / 2.0);
        const Vec2 node =
            Vec2(glm::dot(onPlane, slope.across), glm::dot(onPlane, slope.uphill)) / nodes.stepMm + nodes.edge() / 2.0;
        if (!(node.x >= 0 && node.y >= 0 && node.x < nodes.edge() && node.y < nodes.edge())) continue;
        sum += shares.at(static_cast<int>(node.y), static_cast<int>(node.x));
      }
      picture.at(row, column) = sum / (kSamples * kSamples);
    }
  });
  return picture;
}

}  // namespace qrelief
