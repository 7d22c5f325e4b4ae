// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/first_spots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace qrelief {
namespace {

constexpr int kTexels = 160;
constexpr int kStride = 5;            // texels between candidates
constexpr int kGrid = 8;              // cells along the square's edge
constexpr double kLeastFacing = 0.5;  // cosine to the line of sight: the spot should be visible at once
// Weights of the defects that hinder decoding; a flat, covered square scores 0.
constexpr double kTiltWeight = 0.3;  // weight of the mean of 1 - cos(normal, mean normal)
constexpr double kUncoveredWeight = 0.5;
constexpr double kApart = 0.3;             // least distance of two spots, as a fraction of the square's edge
constexpr double kOffCentreWeight = 0.01;  // weight of the distance from the picture's middle, in half pictures

struct Sample {
  Vec3 position, normal;  // in axes of the rendering's frame, origin at its centre
  bool isCandidate = false;
};

std::vector<Sample> visibleSamples(const std::vector<float>& surface, const MapWindow& window, double eyeDistance) {
  std::vector<Sample> samples;
  for (int row = 0; row < kTexels; ++row) {
    for (int column = 0; column < kTexels; ++column) {
      const auto i = 4 * static_cast<std::size_t>(row * kTexels + column);
      Sample sample;
      sample.normal = {surface[i], surface[i + 1], surface[i + 2]};
      if (glm::dot(sample.normal, sample.normal) < 0.5) continue;
      const double height = surface[i + 3];
      sample.position = Vec3(window.planePoint(column, row) * (1 - height / eyeDistance), height);
      sample.isCandidate = row % kStride == 0 && column % kStride == 0 && sample.normal.z >= kLeastFacing;
      samples.push_back(sample);
    }
  }
  return samples;
}

struct Rated {
  std::size_t sample = 0;
  Vec3 normal{0};
  double badness = std::numeric_limits<double>::infinity();
};

Rated rate(const std::vector<Sample>& samples, std::size_t index, double sizeMm) {
  const Sample& centre = samples[index];
  Rated rated;
  rated.sample = index;
  Vec3 normal(0);
  for (const Sample& s : samples)
    if (glm::length(s.position - centre.position) < sizeMm / 2) normal += s.normal;
  if (glm::length(normal) == 0) return rated;
  const ProjectionFrame square = makeFrame(centre.position, normal, {0, 1, 0}, 1);

  std::array<bool, kGrid * kGrid> covered{};
  double count = 0, sum = 0, sumSquares = 0, tilt = 0;
  for (const Sample& s : samples) {
    const Vec3 offset = s.position - square.centre;
    const Vec2 at = Vec2(glm::dot(offset, square.right), glm::dot(offset, square.up)) / sizeMm + 0.5;
    const double height = glm::dot(offset, square.normal);
    const double facing = glm::dot(s.normal, square.normal);
    if (at.x < 0 || at.y < 0 || at.x >= 1 || at.y >= 1 || std::abs(height) > sizeMm / 2 || facing < 0) continue;
    covered[static_cast<int>(at.y * kGrid) * kGrid + static_cast<int>(at.x * kGrid)] = true;
    count += 1;
    sum += height;
    sumSquares += height * height;
    tilt += 1 - facing;
  }
  const double uncovered = static_cast<double>(std::count(covered.begin(), covered.end(), false)) / (kGrid * kGrid);
  const double variance = std::max(0.0, sumSquares / count - (sum / count) * (sum / count));
  rated.normal = square.normal;
  rated.badness = variance / (sizeMm * sizeMm) + kTiltWeight * tilt / count + kUncoveredWeight * uncovered;
  return rated;
}

}  // namespace

Result<std::vector<OrientedPoint>> firstSpots(const SurfaceRenderer& surface, const ProjectionFrame& view,
                                              double widthMm, double sizeMm, std::size_t most) {
  const MapWindow window{widthMm, kTexels};
  const auto map = surface.render(view, window);
  QRELIEF_TRY(map);
  const std::vector<Sample> samples = visibleSamples(*map, window, view.eyeDistance);
  std::vector<Rated> ranked;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!samples[i].isCandidate) continue;
    ranked.push_back(rate(samples, i, sizeMm));
    ranked.back().badness += kOffCentreWeight * glm::length(Vec2(samples[i].position)) / (widthMm / 2);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const Rated& a, const Rated& b) { return a.badness < b.badness; });

  const auto inModel = [&](Vec3 v) { return view.right * v.x + view.up * v.y + view.normal * v.z; };
  std::vector<OrientedPoint> spots;
  for (const Rated& rated : ranked) {
    if (spots.size() == most || !std::isfinite(rated.badness)) break;
    const OrientedPoint spot{view.centre + inModel(samples[rated.sample].position), inModel(rated.normal)};
    const bool isApart = std::all_of(spots.begin(), spots.end(), [&](const OrientedPoint& other) {
      return glm::length(other.position - spot.position) >= kApart * sizeMm;
    });
    if (isApart) spots.push_back(spot);
  }
  return spots;
}

}  // namespace qrelief
