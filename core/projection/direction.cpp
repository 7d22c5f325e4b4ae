// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/direction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/halton.h"
#include "math/principal_axes.h"

namespace qrelief {
namespace {

Vec3 unitOrZero(Vec3 v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Vec3(0);
}

/// A map with the replaced normals of the texels outside the silhouette.
class NormalMap {
 public:
  NormalMap(std::span<const float> texel, int texels, const DirectionOptions& options)
      : texel_(texel), texels_(texels), window_{options.sizeMm, texels}, eyeDistance_(options.eyeDistanceMm) {}

  int texels() const { return texels_; }

  bool inside(int column, int row) const { return distance(column, row) > 0; }
  double distance(int column, int row) const { return texel_[index(column, row) + 3]; }
  Vec3 normal(int column, int row) const {
    const std::size_t i = index(column, row);
    if (inside(column, row)) return {texel_[i], texel_[i + 1], texel_[i + 2]};
    const auto acrossHalf = [this](int k) { return (2 * k + 1.0) / texels_ - 1; };
    return glm::normalize(Vec3(acrossHalf(column), acrossHalf(row), -1));
  }
  /// Returns the unit vector from the texel's surface point to the eye.
  Vec3 towardsEye(int column, int row) const {
    return glm::normalize(Vec3(-window_.planePoint(column, row), eyeDistance_));
  }
  Vec3 surfacePoint(int column, int row) const {
    return Vec3(0, 0, eyeDistance_) - towardsEye(column, row) * distance(column, row);
  }

 private:
  std::size_t index(int column, int row) const { return 4 * static_cast<std::size_t>(row * texels_ + column); }
  std::span<const float> texel_;
  int texels_;
  MapWindow window_;
  double eyeDistance_;
};

/// Fraction of the square that counts as the most oblique part.
constexpr double kWorstFraction = 0.05;

/// Fraction of the range of distances within which cells tie with the second. On a symmetrical surface four cells lie
/// alike; two of them alone would tilt the direction.
constexpr double kTieFraction = 0.05;

/// Sums over one cell of the depth grid.
struct Cell {
  Vec3 normals{0};
  double distances = 0;
  int inside = 0;
  int outside = 0;
};

std::vector<Cell> sumCells(const NormalMap& map, int texels, int grid) {
  std::vector<Cell> cells(static_cast<std::size_t>(grid * grid));
  for (int row = 0; row < texels; ++row) {
    for (int column = 0; column < texels; ++column) {
      Cell& cell = cells[row * grid / texels * grid + column * grid / texels];
      cell.normals += map.normal(column, row);
      if (map.inside(column, row)) {
        cell.distances += map.distance(column, row);
        ++cell.inside;
      } else {
        ++cell.outside;
      }
    }
  }
  return cells;
}

Vec3 extremeCellsMean(const std::vector<Cell>& cells) {
  std::vector<const Cell*> ranked;
  for (const Cell& cell : cells)
    if (cell.inside > 0) ranked.push_back(&cell);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Cell* a, const Cell* b) { return a->distances / a->inside < b->distances / b->inside; });
  if (ranked.empty()) return Vec3(0);
  const auto meanDistance = [&](std::size_t i) { return ranked[i]->distances / ranked[i]->inside; };
  const std::size_t last = ranked.size() - 1;
  const std::size_t second = std::min<std::size_t>(1, last);
  const double tie = kTieFraction * (meanDistance(last) - meanDistance(0));
  Vec3 near(0), far(0);
  for (std::size_t i = 0; i <= last; ++i) {
    if (meanDistance(i) <= meanDistance(second) + tie) near += unitOrZero(ranked[i]->normals);
    if (meanDistance(i) >= meanDistance(last - second) - tie) far += unitOrZero(ranked[i]->normals);
  }
  return unitOrZero(unitOrZero(near) + unitOrZero(far));
}

/// Computes the mean normal and the axis of least variance from the Halton samples.
void sampleHalton(MapSample& sample, const NormalMap& map, int samples) {
  std::vector<Vec3> points;
  const auto at = [&](double unit) { return std::min(map.texels() - 1, static_cast<int>(unit * map.texels())); };
  for (int i = 1; i <= samples; ++i) {
    const auto [x, y] = halton23(static_cast<std::uint32_t>(i));
    sample.mean += map.normal(at(x), at(y));
    if (map.inside(at(x), at(y))) points.push_back(map.surfacePoint(at(x), at(y)));
  }
  sample.mean = unitOrZero(sample.mean);
  sample.leastVariance = leastVarianceAxis(points);
  if (sample.leastVariance.z < 0) sample.leastVariance = -sample.leastVariance;
}

double worstAngleOf(const NormalMap& map) {
  std::vector<double> cosines;
  for (int row = 0; row < map.texels(); ++row)
    for (int column = 0; column < map.texels(); ++column)
      cosines.push_back(map.inside(column, row)
                            ? std::clamp(glm::dot(map.normal(column, row), map.towardsEye(column, row)), 0.0, 1.0)
                            : 0.0);
  const auto count = std::max<std::ptrdiff_t>(1, std::lround(kWorstFraction * static_cast<double>(cosines.size())));
  std::nth_element(cosines.begin(), cosines.begin() + count - 1, cosines.end());
  std::sort(cosines.begin(), cosines.begin() + count);  // so that the sum is the same with every standard library
  double sum = 0;
  for (auto cosine = cosines.begin(); cosine != cosines.begin() + count; ++cosine) sum += *cosine;
  return std::acos(std::min(1.0, sum / static_cast<double>(count)));
}

/// Computes the variance of the distance over the texels inside, the outside fraction, and the values derived from
/// them.
void rate(MapSample& sample, const NormalMap& map, const std::vector<Cell>& cells, double sizeMm) {
  double sum = 0;
  int inside = 0;
  for (const Cell& cell : cells) {
    sum += cell.distances;
    inside += cell.inside;
  }
  const double mean = inside > 0 ? sum / inside : 0;
  double squares = 0;
  for (int row = 0; row < map.texels(); ++row)
    for (int column = 0; column < map.texels(); ++column)
      if (map.inside(column, row)) squares += std::pow(map.distance(column, row) - mean, 2);
  sample.varianceMm2 = inside > 0 ? squares / inside : 0;
  sample.outsideFraction = 1 - static_cast<double>(inside) / (map.texels() * map.texels());
  sample.worstAngle = worstAngleOf(map);
  const double insideVariance = sample.varianceMm2 / (sizeMm * sizeMm) * (1 - sample.outsideFraction);
  sample.measure = insideVariance + sample.outsideFraction / 4 + kObliqueWeight * (1 - std::cos(sample.worstAngle));
}

/// Tests if nothing hides the centre. The texels around the middle are half a texel's diagonal away, so a surface seen
/// at up to 80° is nearer by up to four texels.
bool seesCentre(const NormalMap& map, const DirectionOptions& options) {
  const double nearest = options.eyeDistanceMm - 4 * options.sizeMm / map.texels();
  for (const int row : {map.texels() / 2 - 1, map.texels() / 2})
    for (const int column : {map.texels() / 2 - 1, map.texels() / 2})
      if (map.inside(column, row) && map.distance(column, row) >= nearest) return true;
  return false;
}

constexpr std::array<const char*, 5> kMethodNames = {"mean-normal", "depth-balanced", "pca", "optimal", "largest"};

}  // namespace

const char* directionMethodName(DirectionMethod method) { return kMethodNames[static_cast<std::size_t>(method)]; }

MapSample sampleMap(std::span<const float> normals, int texels, const DirectionOptions& options) {
  const NormalMap map(normals, texels, options);
  MapSample sample;
  sampleHalton(sample, map, options.samples);
  const std::vector<Cell> cells = sumCells(map, texels, options.grid);
  sample.depthBalance = extremeCellsMean(cells);
  for (const Cell& cell : cells)
    if (cell.inside == 0) sample.outside += unitOrZero(cell.normals);
  sample.outside = unitOrZero(sample.outside);
  rate(sample, map, cells, options.sizeMm);
  sample.centreIsSeen = seesCentre(map, options);
  return sample;
}

Result<MapSample> lookFrom(const SurfaceRenderer& surface, const ProjectionFrame& frame,
                           const DirectionOptions& options) {
  const MapWindow window{options.sizeMm, options.mapTexels};
  auto rendered = surface.render(frame, window);
  QRELIEF_TRY(rendered);
  // Uses facet normals where the paper interpolates vertex normals. Over a sampled square both average to the same, but
  // next to a crease interpolation leans away from the face by up to half the angle.
  std::vector<float> map = std::move(*rendered);
  const std::vector<float> distances = rayDistances(map, frame, window);
  for (std::size_t texel = 0; texel < distances.size(); ++texel) map[4 * texel + 3] = distances[texel];
  DirectionOptions fromFrame = options;
  fromFrame.eyeDistanceMm = frame.eyeDistance;
  return sampleMap(map, options.mapTexels, fromFrame);
}

DirectionSearch::DirectionSearch(const SurfaceRenderer& surface, Vec3 centre, Vec3 surfaceNormal, Vec3 upHint,
                                 double eyeDistance, const DirectionOptions& options)
    : surface_(&surface),
      centre_(centre),
      upHint_(upHint),
      current_(glm::normalize(surfaceNormal)),
      best_(current_),
      eyeDistance_(eyeDistance),
      options_(options) {}

Result<bool> DirectionSearch::step() {
  const ProjectionFrame frame = makeFrame(centre_, current_, upHint_, eyeDistance_);
  const Result<MapSample> looked = lookFrom(*surface_, frame, options_);
  QRELIEF_TRY(looked);
  const MapSample& sample = *looked;
  iterations_.push_back({current_, sample.varianceMm2, sample.outsideFraction, sample.worstAngle, sample.measure});

  const bool once = options_.method == DirectionMethod::MeanNormal || options_.method == DirectionMethod::Pca;
  // The first direction comes from a single facet and says little, so it is never the answer.
  const bool updated = iterations_.size() > 1;
  if (updated) {
    const auto least = std::min_element(
        iterations_.begin() + 1, iterations_.end(),
        [](const DirectionIteration& a, const DirectionIteration& b) { return a.varianceMm2 < b.varianceMm2; });
    best_ = least->normal;
    if (once) return true;
    if (sample.varianceMm2 <= options_.variance * options_.sizeMm * options_.sizeMm) return true;
    if (static_cast<int>(iterations_.size()) > options_.maxIterations) return true;
  }
  const Vec3 inAxes = options_.method == DirectionMethod::MeanNormal ? sample.mean
                      : options_.method == DirectionMethod::Pca
                          ? sample.leastVariance
                          : unitOrZero(sample.mean + sample.depthBalance + sample.outside);
  const Vec3 next = frame.right * inAxes.x + frame.up * inAxes.y + frame.normal * inAxes.z;
  // Normals that cancel out, or a direction from behind the centre, lead nowhere: keep the direction found so far.
  if (glm::length(next) < 0.5 || glm::dot(next, iterations_.front().normal) <= 0) {
    if (!updated) best_ = current_;
    return true;
  }
  // The far cells lean away from the plane, so each full step overshoots: on a sphere it oscillates by ±4° for ever.
  // From the second update on it takes half a step, which converges at once.
  current_ = glm::normalize(updated ? glm::normalize(next) + current_ : next);
  best_ = updated ? best_ : current_;
  return false;
}

}  // namespace qrelief
