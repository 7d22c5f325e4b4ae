// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/spot_candidates.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/angle.h"
#include "projection/flatness.h"

namespace qrelief {
namespace {

constexpr double kSizeClass = 1.1;
constexpr double kSteeperFraction = 0.01;
constexpr double kSteepDeg = 50;
// Effective modules along the square's edge for aimToleranceDeg(), for version 3. With its quiet zone the square has 37
// modules, but the symbol alone (29) bends less, in proportion to the square of its edge.
constexpr double kUsualModules = 29.0 * 29 / 37;
constexpr std::size_t kFacetsRated = 4000;

double cosineOf(double deg) { return std::cos(toRadians(deg)); }

int sizeClassOf(double sizeMm) {
  return static_cast<int>(std::floor(std::log(std::max(sizeMm, 1e-6)) / std::log(kSizeClass)));
}

}  // namespace

double countedPart(const SquareQuality& quality, double aimDeg) {
  return std::min(1.0, cosineOf(quality.worstAngleDeg) / cosineOf(kSteepDeg)) *
         std::min(1.0, aimDeg / kForgivingTiltDeg);
}

SpotRank::SpotRank(double sizeMm, const SquareQuality& quality, double edgeMm, double aimDeg)
    : sizeClass(sizeClassOf(sizeMm * countedPart(quality, aimDeg))),
      badness(std::sqrt(quality.varianceMm2) / edgeMm + 1 - cosineOf(quality.worstAngleDeg)) {}

bool SpotRank::operator<(const SpotRank& other) const {
  return sizeClass != other.sizeClass ? sizeClass > other.sizeClass : badness < other.badness;
}

SquareQuality qualityOf(const SizeMap& map, const ProjectionFrame& frame, double edgeMm) {
  struct Slope {
    double cosine, area;
  };
  std::vector<Slope> slopes;
  PlaneFit fit;
  double area = 0, sum = 0, sumSquares = 0;
  Vec3 sumOfNormals(0);
  for (std::size_t t = 0; t < map.mesh.triangles.size(); ++t) {
    const Vec3 a = map.mesh.corner(t, 0), b = map.mesh.corner(t, 1), c = map.mesh.corner(t, 2);
    const Vec3 middle = (a + b + c) / 3.0 - frame.centre;
    const double height = glm::dot(middle, frame.normal);
    const Vec2 at(glm::dot(middle, frame.right), glm::dot(middle, frame.up));
    if (std::max({std::abs(at.x), std::abs(at.y), std::abs(height)}) > edgeMm / 2) continue;
    const Vec3 across = glm::cross(b - a, c - a) / 2.0;
    const double seen = glm::dot(across, frame.normal);
    if (!(seen > 0)) continue;
    slopes.push_back({seen / glm::length(across), seen});
    fit.add(at, height, seen);
    sumOfNormals += across;
    area += seen;
    sum += seen * height;
    sumSquares += seen * height * height;
  }
  SquareQuality quality;
  if (slopes.empty()) return quality;
  quality.varianceMm2 = std::max(0.0, sumSquares / area - (sum / area) * (sum / area));
  quality.bendMm = fit.rms();
  quality.normal = glm::normalize(sumOfNormals);  // each is seen from the front
  std::stable_sort(slopes.begin(), slopes.end(), [](const Slope& a, const Slope& b) { return a.cosine < b.cosine; });
  double steeper = 0;
  for (const Slope& slope : slopes) {
    quality.worstAngleDeg = toDegrees(std::acos(std::min(1.0, slope.cosine)));
    steeper += slope.area;
    if (steeper > kSteeperFraction * area) break;
  }
  return quality;
}

std::vector<float> countedSizes(const SizeMap& map, double edgeMm) {
  SizeMap sample;
  sample.mesh.positions = map.mesh.positions;
  const std::size_t step = 1 + map.mesh.triangles.size() / kFacetsRated;
  for (std::size_t t = 0; t < map.mesh.triangles.size(); t += step)
    sample.mesh.triangles.push_back(map.mesh.triangles[t]);
  std::vector<float> sizes;
  sizes.reserve(map.sizeMm.size());
  for (std::size_t v = 0; v < map.sizeMm.size(); ++v) {
    const double squareMm = std::min(static_cast<double>(map.sizeMm[v]), edgeMm);
    if (!(squareMm > 0)) {
      sizes.push_back(0);
      continue;
    }
    const ProjectionFrame frame = makeFrame(Vec3(map.mesh.positions[v]), Vec3(map.direction[v]), {0, 0, 1}, 1);
    const SquareQuality quality = qualityOf(sample, frame, squareMm);
    const double part = countedPart(quality, aimToleranceDeg(quality.bendMm, squareMm / kUsualModules));
    sizes.push_back(static_cast<float>(part * squareMm));
  }
  return sizes;
}

std::vector<SpotCandidate> spotCandidates(const SizeMap& map, const CandidateOptions& options) {
  std::vector<std::uint32_t> order(map.sizeMm.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto score = [&](std::uint32_t v) { return map.sizeMm[v] * glm::dot(map.direction[v], map.normals[v]); };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return score(a) > score(b); });
  std::vector<SpotCandidate> spots;
  for (const std::uint32_t v : order) {
    const double size = static_cast<double>(map.sizeMm[v]);
    if (spots.size() == options.maxCount) break;
    if (size <= 0 || size < options.minSizeMm) continue;
    SpotCandidate spot{Vec3(map.mesh.positions[v]), Vec3(map.direction[v]), size, {}};
    const bool isApart = std::all_of(spots.begin(), spots.end(), [&](const SpotCandidate& other) {
      return glm::dot(other.direction, spot.direction) < 0 ||
             glm::distance(other.position, spot.position) >= options.apart * options.edgeMm;
    });
    if (!isApart) continue;
    spot.quality =
        qualityOf(map, makeFrame(spot.position, spot.direction, {0, 0, 1}, 1), std::min(size, options.edgeMm));
    spots.push_back(spot);
  }
  const auto rank = [&](const SpotCandidate& spot) {
    const double edgeMm = std::min(spot.sizeMm, options.edgeMm);
    return SpotRank(std::min(spot.sizeMm, options.enoughMm), spot.quality, edgeMm,
                    aimToleranceDeg(spot.quality.bendMm, edgeMm / kUsualModules));
  };
  std::stable_sort(spots.begin(), spots.end(),
                   [&](const SpotCandidate& a, const SpotCandidate& b) { return rank(a) < rank(b); });
  return spots;
}

}  // namespace qrelief
