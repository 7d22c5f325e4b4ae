// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/carving_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "qr/module_pattern.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr int kWindow = 2;               // modules on each side of a window's middle
constexpr std::size_t kTerms = 7;        // 1, x, y, x², xy, y², dark
constexpr double kEvenMm = 1e-3;         // windows no more uneven than this are bare
constexpr double kMinFit = 0.5;          // a symbol with other content shares the finder patterns but explains less
constexpr double kCarvedFraction = 0.3;  // submodules deeper than this fraction of the module's deepest count as carved

using System = std::array<std::array<double, kTerms + 1>, kTerms>;
using Terms = std::array<double, kTerms>;

/// Solves by Gaussian elimination with pivots; terms that the data do not determine become 0.
Terms solved(System a, std::size_t terms) {
  Terms x{};
  std::array<bool, kTerms> known{};
  std::array<std::size_t, kTerms> rowOf{};
  std::size_t row = 0;
  for (std::size_t c = 0; c < terms; ++c) {
    std::size_t best = row;
    for (std::size_t r = row; r < terms; ++r)
      if (std::abs(a[r][c]) > std::abs(a[best][c])) best = r;
    if (row >= terms || std::abs(a[best][c]) < 1e-9) continue;
    std::swap(a[row], a[best]);
    for (std::size_t r = 0; r < terms; ++r) {
      if (r == row) continue;
      const double k = a[r][c] / a[row][c];
      for (std::size_t i = c; i <= kTerms; ++i) a[r][i] -= k * a[row][i];
    }
    known[c] = true;
    rowOf[c] = row++;
  }
  for (std::size_t c = 0; c < terms; ++c)
    if (known[c]) x[c] = a[rowOf[c]][kTerms] / a[rowOf[c]][c];
  return x;
}

/// Returns the module at a place in the picture if the symbol has this pose: 0 … 3 turned, 4 … 7 mirrored. The user
/// sees all four mirrored poses as one.
bool isDarkIn(const Symbol& symbol, int pose, int row, int column) {
  const int last = symbol.size - 1;
  if (row < 0 || column < 0 || row > last || column > last) return false;
  if (pose >= 4) column = last - column;
  for (int turn = 0; turn < pose % 4; ++turn) {
    const int r = row;
    row = column;
    column = last - r;
  }
  return symbol.isDark(row, column);
}

SymbolPose nameOf(int pose) {
  constexpr std::array<SymbolPose, 4> kTurned = {SymbolPose::AsWanted, SymbolPose::Turned90, SymbolPose::Turned180,
                                                 SymbolPose::Turned270};
  return pose >= 4 ? SymbolPose::Mirrored : kTurned[pose];
}

/// The surface seen from the eye over symbol and quiet zone, one point per submodule.
class DistanceGrid {
 public:
  DistanceGrid(const RayTree& tree, const ProjectionFrame& frame, int modules, double moduleMm)
      : points_(kN * (modules + 2 * kQuietZoneModules), kN * (modules + 2 * kQuietZoneModules)) {
    const double step = moduleMm / kN, middle = points_.rows() / 2.0;
    parallelFor(points_.rows(), [&](int row) {
      for (int column = 0; column < points_.columns(); ++column) {
        const Vec2 at{(column + 0.5 - middle) * step, (middle - row - 0.5) * step};
        const auto hit = tree.firstHit(frame.eye(), frame.rayDirection(at));
        points_.at(row, column) =
            hit.value_or(SurfacePoint{Vec3(0), kNoTriangle, std::numeric_limits<double>::quiet_NaN()});
      }
    });
  }

  /// @param row, column  submodules from the symbol's top left; negative in the quiet zone
  const SurfacePoint& at(int row, int column) const {
    return points_.at(row + kQuietZoneSubmodules, column + kQuietZoneSubmodules);
  }
  /// Returns the distance at a module's middle.
  double middleOf(int row, int column) const { return at(kN * row + kN / 2, kN * column + kN / 2).distance; }
  bool inside(int row, int column) const {
    return points_.contains(kN * (row + kQuietZoneModules), kN * (column + kQuietZoneModules));
  }

 private:
  Grid<SurfacePoint> points_;
};

Terms termsAt(double x, double y, bool dark) { return {1, x, y, x * x, x * y, y * y, dark ? 1.0 : 0.0}; }

struct WindowFit {
  Terms terms{};
  double left = 0;        // sum of squared residuals of the surface alone
  double leftByBoth = 0;  // the same with a step between dark and light
};

WindowFit fitWindow(const DistanceGrid& grid, const Symbol& symbol, int pose, int row, int column) {
  System normal{};
  std::vector<std::pair<Terms, double>> samples;
  for (int r = row - kWindow; r <= row + kWindow; ++r) {
    for (int c = column - kWindow; c <= column + kWindow; ++c) {
      if (!grid.inside(r, c) || std::isnan(grid.middleOf(r, c))) continue;
      samples.emplace_back(termsAt(c - column, r - row, isDarkIn(symbol, pose, r, c)), grid.middleOf(r, c));
    }
  }
  if (samples.size() <= kTerms) return {};
  const double origin = samples.front().second;
  for (auto& [terms, distance] : samples) {
    distance -= origin;
    for (std::size_t i = 0; i < kTerms; ++i) {
      for (std::size_t k = 0; k < kTerms; ++k) normal[i][k] += terms[i] * terms[k];
      normal[i][kTerms] += terms[i] * distance;
    }
  }
  WindowFit fit;
  fit.terms = solved(normal, kTerms);
  const Terms surface = solved(normal, kTerms - 1);
  for (const auto& [terms, distance] : samples) {
    double both = -distance, alone = -distance;
    for (std::size_t i = 0; i < kTerms; ++i) {
      both += fit.terms[i] * terms[i];
      alone += surface[i] * terms[i];
    }
    fit.left += alone * alone;
    fit.leftByBoth += both * both;
  }
  fit.terms[0] += origin;
  return fit;
}

/// Returns the mean over the windows, so that a crease of the surface counts only in the windows it crosses.
double explainedBy(const DistanceGrid& grid, const Symbol& symbol, int pose) {
  double sum = 0;
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) {
      const WindowFit fit = fitWindow(grid, symbol, pose, row, column);
      if (fit.left > kEvenMm * kEvenMm) sum += 1 - fit.leftByBoth / fit.left;
    }
  return sum / (symbol.size * symbol.size);
}

/// Measures the depth of each submodule of one dark module.
void measureModule(const DistanceGrid& grid, const WindowFit& fit, int row, int column, Grid<double>& depths) {
  for (int k = 0; k < kN * kN; ++k) {
    const int down = k / kN, right = k % kN, middle = kN / 2;
    const int r = kN * row + down, c = kN * column + right;
    const Terms terms =
        termsAt((right - middle) / static_cast<double>(kN), (down - middle) / static_cast<double>(kN), false);
    double surface = 0;
    for (std::size_t i = 0; i + 1 < kTerms; ++i) surface += fit.terms[i] * terms[i];
    depths.at(r, c) = grid.at(r, c).distance - surface;
  }
}

/// Separates the carved submodules of one dark module from those that its pattern leaves.
void markCarved(CarvingProfile& profile, int row, int column) {
  const auto index = [&](int k) { return profile.carved.index(kN * row + k / kN, kN * column + k % kN); };
  double most = 0;
  for (int k = 0; k < kN * kN; ++k)
    if (std::abs(profile.depthMm[index(k)]) > std::abs(most)) most = profile.depthMm[index(k)];
  for (int k = 0; k < kN * kN; ++k)
    profile.carved[index(k)] = most != 0 && profile.depthMm[index(k)] / most > kCarvedFraction;
}

}  // namespace

CarvingProfile profileCarving(const RayTree& tree, const ProjectionFrame& frame, const Symbol& symbol,
                              double symbolMm) {
  const DistanceGrid grid(tree, frame, symbol.size, symbolMm / symbol.size);
  std::array<double, 8> explained{};
  parallelFor(explained.size(),
              [&](std::size_t pose) { explained[pose] = explainedBy(grid, symbol, static_cast<int>(pose)); });
  const auto best = std::max_element(explained.begin(), explained.end());
  const int pose = static_cast<int>(best - explained.begin());
  CarvingProfile profile;
  profile.fit = *best;
  const int edge = kN * symbol.size;
  profile.points = {edge, edge};
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column) profile.points.at(row, column) = grid.at(row, column);
  if (profile.fit < kMinFit) return profile;
  profile.pose = nameOf(pose);
  profile.depthMm = {edge, edge};
  profile.carved = {edge, edge};
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) {
      if (!isDarkIn(symbol, pose, row, column)) continue;
      measureModule(grid, fitWindow(grid, symbol, pose, row, column), row, column, profile.depthMm);
      markCarved(profile, row, column);
    }
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < profile.carved.size(); ++i)
    if (profile.carved[i]) sum += profile.depthMm[i], ++count;
  profile.meanDepthMm = count > 0 ? sum / count : 0;
  return profile;
}

}  // namespace qrelief
