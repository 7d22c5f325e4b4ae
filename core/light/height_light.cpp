// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/height_light.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "light/light_rows.h"
#include "math/angle.h"

namespace qrelief {
namespace {

constexpr double kGrowth = 1.15;  // growth of a step: surface narrower than a seventh of its distance may be missed
// See HorizonStep::fromBefore: edges between sample points are higher than the middles.
constexpr float kBorder = 0.75f;
constexpr int kPad = kMostLanes;
constexpr int kLeastDirections = 4;
constexpr int kStretch = 4 * kMostLanes;  // patches that share one direction to a lamp
constexpr int kTurnsOfSinglePoints = 4;
// Fitted to path tracing (bench/light_truth.cpp). kAround is the luminance around an occluder that is a continuous
// surface, kBeforeWall the luminance in front of a wall; points without sky have the fraction kDarkFraction of it.
// kWallFraction is the fraction of the sky at its foot and its rim that a wall sees.
constexpr float kAround = 0.67f, kBeforeWall = 0.8f, kDarkFraction = 0.3f, kWallFraction = 0.45f;
constexpr double kLowestClimb = 0.05;  // least climb of a ray to a lamp: shadows of lower rays have wider edges

/// Returns the position of one of `points`² points in its patch, 0 … 1: two by two points form a turned grid, one in
/// each quarter.
Vec2 pointInPatch(int points, int column, int row) {
  if (points == 2) return {(2 * column + row + 0.5) / 4, (2 * row + (1 - column) + 0.5) / 4};
  return {(column + 0.5) / points, (row + 0.5) / points};
}

/// Finds the patch borders on a path through the map, and, beyond `everyPatch`, places at growing distances.
/// @param from  in the receiver's patch, 0 … 1
/// @param reach, everyPatch  in patches
std::vector<HorizonStep> stepsAlong(Vec2 from, Vec2 along, double reach, double everyPatch, double patchMm,
                                    int stride) {
  const Vec2 speed = glm::max(glm::abs(along), Vec2(1e-9));
  Vec2 next;
  for (int axis = 0; axis < 2; ++axis) next[axis] = (along[axis] > 0 ? 1 - from[axis] : from[axis]) / speed[axis];
  std::vector<HorizonStep> steps;
  for (;;) {
    const double travelled = std::min(next.x, next.y);
    if (travelled > reach) return steps;
    const bool isBorder = steps.empty() || travelled <= everyPatch * kGrowth;
    for (int axis = 0; axis < 2; ++axis) {
      if (next[axis] <= travelled) next[axis] += 1 / speed[axis];
      if (travelled > everyPatch) next[axis] = std::max(next[axis], travelled * kGrowth);
    }
    if (travelled <= 0) continue;
    const Vec2 point = from + along * travelled;
    const Vec2 patch = glm::floor(point + along * 1e-6);
    const Vec2 fromMiddle = (point - patch - 0.5) * patchMm;
    const int column = static_cast<int>(patch.x), row = static_cast<int>(patch.y);
    steps.push_back({row * stride + column, column, row, static_cast<float>(fromMiddle.x),
                     static_cast<float>(fromMiddle.y), static_cast<float>(1 / (travelled * patchMm)),
                     isBorder ? kBorder : 1.0f});
  }
}

struct Reach {
  double patches = 0, everyPatch = 0;  // see stepsAlong
  double patchMm = 0;
  int stride = 0;
};

HorizonDirection directionOf(Vec2 from, double angle, const Reach& reach) {
  HorizonDirection direction;
  const Vec2 along(std::cos(angle), std::sin(angle));
  direction.cosine = static_cast<float>(along.x);
  direction.sine = static_cast<float>(along.y);
  direction.steps = stepsAlong(from, along, reach.patches, reach.everyPatch, reach.patchMm, reach.stride);
  double sector = angle * FarHorizon::kDirections / (2 * std::numbers::pi);
  sector -= std::floor(sector / FarHorizon::kDirections) * FarHorizon::kDirections;
  direction.farSector = static_cast<int>(sector) % FarHorizon::kDirections;
  direction.farFraction = static_cast<float>(sector - std::floor(sector));
  return direction;
}

/// Receiving points at one position in their patches, with the directions they look in.
struct PointClass {
  Vec2 inPatch{0.5};
  std::vector<HorizonDirection> directions;
};

/// Returns the classes, indexed by row % (result.size() / points²), then point.
std::vector<PointClass> pointClasses(const LightSampling& sampling, const Reach& reach) {
  constexpr std::array<int, kTurnsOfSinglePoints> kOrder = {0, 2, 1, 3};  // near rows take far turns
  const int points = sampling.points, turns = points == 1 ? kTurnsOfSinglePoints : points * points;
  std::vector<PointClass> classes;
  for (int k = 0; k < turns; ++k) {
    const int order = turns == kTurnsOfSinglePoints ? kOrder[k] : k;
    PointClass point{points == 1 ? Vec2(0.5) : pointInPatch(points, k % points, k / points), {}};
    for (int d = 0; d < sampling.directions; ++d) {
      const double angle = 2 * std::numbers::pi * (d + (order + 0.5) / turns) / sampling.directions;
      point.directions.push_back(directionOf(point.inPatch, angle, reach));
    }
    classes.push_back(std::move(point));
  }
  return classes;
}

/// @param middle  of the stretch on the QR plane
LampStretch stretchOf(const DirectionalLight& lamp, double radiusDeg, Vec2 middle, Vec2 inPatch, int points,
                      double eyeDistance, const Reach& reach) {
  const Vec3 to = towards(lamp);
  const Vec2 way = Vec2(to.x, to.y) + middle * (to.z / eyeDistance);
  const double climb = to.z / std::max(glm::length(way), 1e-6);
  LampStretch stretch{static_cast<float>(to.x),
                      static_cast<float>(to.y),
                      static_cast<float>(to.z),
                      static_cast<float>(lamp.strength),
                      directionOf(inPatch, std::atan2(way.y, way.x), reach),
                      {}};
  const double widening = 2 * std::tan(toRadians(radiusDeg)) * (1 + climb * climb) / climb;
  const double least = reach.patchMm / (2 * points) * std::max(1.0, kLowestClimb / climb);
  for (const HorizonStep& step : stretch.direction.steps)
    stretch.perShadowEdge.push_back(static_cast<float>(1 / (least + widening / static_cast<double>(step.perMm))));
  return stretch;
}

/// Light received so far by the points of a row.
struct RowSums {
  std::vector<float> sky, pastWalls, lamps, lampsUncarved;

  explicit RowSums(int size) {
    for (std::vector<float>* sum : {&sky, &pastWalls, &lamps, &lampsUncarved})
      sum->assign(static_cast<std::size_t>(size + kMostLanes), 0.0f);
  }
};

/// Returns the wanted parts of a row, as [begin, end), in whole vectors.
std::vector<std::array<int, 2>> wantedParts(std::span<const std::uint8_t> mask, int row, int size) {
  if (mask.empty()) return {{0, size}};
  const auto first = mask.begin() + static_cast<std::ptrdiff_t>(row) * size;
  std::vector<std::array<int, 2>> parts;
  for (int column = 0; column < size; column += kMostLanes) {
    const int end = std::min(column + kMostLanes, size);
    if (std::none_of(first + column, first + end, [](std::uint8_t one) { return one != 0; })) continue;
    if (!parts.empty() && parts.back()[1] == column)
      parts.back()[1] = end;
    else
      parts.push_back({column, end});
  }
  return parts;
}

}  // namespace

HeightLight::HeightLight(const HeightMap& map, std::optional<FarHorizon> far, const std::optional<HeightMap>& quarters)
    : size_(map.size),
      stride_(map.size + 2 * kPad),
      patchMm_(map.patchMm),
      eyeDistance_(map.eyeDistance),
      isContinuous_(map.isContinuous),
      far_(std::move(far)) {
  assert(!far_ || far_->places > 0);
  patches_ = piecesOf(map, Vec2(0.5), [&](int row, int column) { return row * size_ + column; });
  highest_ = *std::max_element(map.height.begin(), map.height.end());
  if (!quarters) return;
  assert(quarters->size == 2 * size_);
  for (int k = 0; k < 4; ++k) {
    const int right = k % 2, up = k / 2;
    Pieces quarter = piecesOf(*quarters, {0.25 + 0.5 * right, 0.25 + 0.5 * up}, [&](int row, int column) {
      return (2 * row + up) * quarters->size + 2 * column + right;
    });
    for (std::size_t at = 0; at < quarter.height.size(); ++at) {
      if (quarter.height[at] > HeightMap::kNothing) continue;
      quarter.uncarved[at] = quarter.height[at] = patches_.height[at];  // beyond the model's rim
      quarter.slopeX[at] = patches_.slopeX[at];
      quarter.slopeY[at] = patches_.slopeY[at];
    }
    quarters_.push_back(std::move(quarter));
  }
}

/// @param middle   of the pieces in their patches
/// @param pieceOf  index in `map` of the piece in a patch (row, column)
template <class Piece>
HeightLight::Pieces HeightLight::piecesOf(const HeightMap& map, Vec2 middle, const Piece& pieceOf) const {
  const std::size_t count = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(size_);
  Pieces pieces{middle,
                std::vector<float>(count, HeightMap::kNothing),
                {},
                std::vector<float>(count, 0.0f),
                std::vector<float>(count, 0.0f)};
  for (int row = 0; row < size_; ++row)
    for (int column = 0; column < size_; ++column) {
      const auto from = static_cast<std::size_t>(pieceOf(row, column));
      const auto at = static_cast<std::size_t>(row * stride_ + kPad + column);
      pieces.uncarved[at] = map.height[from];
      pieces.slopeX[at] = map.slopeX[from];
      pieces.slopeY[at] = map.slopeY[from];
    }
  pieces.height = pieces.uncarved;
  return pieces;
}

void HeightLight::carve(std::span<const float> depthsMm) {
  assert(depthsMm.size() == static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_));
  isCarved_.clear();
  for (const float depth : depthsMm) isCarved_.push_back(depth > 0 ? 1 : 0);
  carve(patches_, depthsMm);
  for (Pieces& quarter : quarters_) carve(quarter, depthsMm);
}

void HeightLight::carve(Pieces& pieces, std::span<const float> depthsMm) const {
  for (int row = 0; row < size_; ++row)
    for (int column = 0; column < size_; ++column) {
      const auto at = static_cast<std::size_t>(row * stride_ + kPad + column);
      const auto depth = static_cast<double>(depthsMm[static_cast<std::size_t>(row * size_ + column)]);
      const float uncarved = pieces.uncarved[at];
      pieces.height[at] = uncarved;
      if (depth <= 0 || uncarved <= HeightMap::kNothing) continue;
      const Vec2 plane = (Vec2(column, row) + pieces.middle - size_ / 2.0) * patchMm_;
      const double way = std::sqrt(glm::dot(plane, plane) + eyeDistance_ * eyeDistance_);  // to the QR plane
      const double share = eyeDistance_ / (static_cast<double>(uncarved) + eyeDistance_) + depth / way;
      pieces.height[at] = static_cast<float>(eyeDistance_ / share - eyeDistance_);
    }
}

/// Calls `visit(row, parts, points)` for every row with wanted patches, on all cores; `points(with)` calls
/// `with(LightRow, inPatch)` for each receiving point of a patch.
template <class Visit>
void HeightLight::forEachRow(const LightOptions& options, std::span<const std::uint8_t> mask,
                             const Visit& visit) const {
  const int points = options.sampling.points;
  assert(points >= 1 && options.sampling.directions >= kLeastDirections);
  const Reach reach{options.reachMm / patchMm_, options.everyPatchMm / patchMm_, patchMm_, stride_};
  const std::vector<PointClass> classes = pointClasses(options.sampling, reach);
  std::vector<std::int32_t> farPlace(static_cast<std::size_t>(size_ + kMostLanes), 0);
  const auto placeOf = [&](int patch) {
    return static_cast<int>(static_cast<std::int64_t>(patch) * far_->places / size_);
  };
  if (far_)
    for (int column = 0; column < size_ + kMostLanes; ++column) farPlace[column] = placeOf(std::min(column, size_ - 1));

  parallelFor(static_cast<std::size_t>(size_), [&](std::size_t number) {
    const int row = static_cast<int>(number);
    const std::vector<std::array<int, 2>> parts = wantedParts(mask, row, size_);
    if (parts.empty()) return;
    const auto first = static_cast<std::size_t>(row * stride_ + kPad);
    visit(row, parts, [&](const auto& with) {
      for (int point = 0; point < points * points; ++point) {
        const PointClass& at = classes[points == 1 ? row % kTurnsOfSinglePoints : point];
        const Pieces& receivers = points == 2 && !quarters_.empty() ? quarters_[point] : patches_;
        const Vec2 fromMiddle = (at.inPatch - receivers.middle) * patchMm_;
        const auto rowOf = [&](const Pieces& pieces) {
          return PieceRow{&pieces.height[first], &pieces.slopeX[first], &pieces.slopeY[first]};
        };
        LightRow in;
        in.patches = rowOf(patches_);
        in.receivers = rowOf(receivers);
        in.row = row;
        in.size = size_;
        in.patchMm = static_cast<float>(patchMm_);
        in.eyeDistance = static_cast<float>(eyeDistance_);
        in.rightMm = static_cast<float>(fromMiddle.x);
        in.upMm = static_cast<float>(fromMiddle.y);
        in.firstX = static_cast<float>((at.inPatch.x - size_ / 2.0) * patchMm_);
        in.y = static_cast<float>((row + at.inPatch.y - size_ / 2.0) * patchMm_);
        in.highest = highest_;
        in.isContinuous = isContinuous_;
        in.directions = at.directions;
        if (far_) {
          const auto places = static_cast<std::size_t>(far_->places);
          in.farCotangents = &far_->cotangents[static_cast<std::size_t>(placeOf(row)) * places];
          in.farPlaces = places * places;
          in.farPlace = farPlace.data();
        }
        with(in, at.inPatch);
      }
    });
  });
}

void HeightLight::measure(const LightOptions& options, std::span<const std::uint8_t> mask,
                          std::vector<Received>& light) const {
  assert(options.lamps.size() <= kMaxLights);
  const auto count = static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_);
  assert(mask.empty() || mask.size() == count);
  light.resize(count);
  const int points = options.sampling.points;
  const Reach reach{options.reachMm / patchMm_, options.everyPatchMm / patchMm_, patchMm_, stride_};
  forEachRow(options, mask, [&](int row, const auto& parts, const auto& forEachPoint) {
    RowSums sums(size_);
    forEachPoint([&](const LightRow& in, Vec2 inPatch) {
      for (const auto& [begin, end] : parts) {
        addSky(in, begin, end, sums.sky.data(), sums.pastWalls.data());
        // Stretches begin at fixed patches, so that light does not depend on the other patches of the mask.
        for (std::size_t lamp = 0; lamp < options.lamps.size(); ++lamp)
          for (int from = begin / kStretch * kStretch; from < end; from += kStretch) {
            const int to = std::min(from + kStretch, size_);
            const Vec2 middle(static_cast<double>(in.firstX) + (from + to - 1) / 2.0 * patchMm_,
                              static_cast<double>(in.y));
            LampStretch stretch =
                stretchOf(options.lamps[lamp], options.lampRadiusDeg, middle, inPatch, points, eyeDistance_, reach);
            if (far_ && far_->hasLamps()) {
              stretch.direction.farSector = FarHorizon::kDirections + static_cast<int>(lamp);
              stretch.direction.farFraction = 0;
            }
            addLamp(in, stretch, std::max(from, begin), std::min(to, end), sums.lamps.data(),
                    sums.lampsUncarved.data());
          }
      }
    });
    const float mean = 1 / static_cast<float>(points * points);
    for (const auto& [begin, end] : parts)
      for (int column = begin; column < end; ++column) {
        const auto patch = static_cast<std::size_t>(row * size_ + column);
        const auto i = static_cast<std::size_t>(column);
        if (!mask.empty() && !mask[patch]) continue;
        if (patches_.height[static_cast<std::size_t>(row * stride_ + kPad) + i] <= HeightMap::kNothing) {
          light[patch] = {};
          continue;
        }
        light[patch] = {sums.sky[i] * mean, sums.pastWalls[i] * mean, sums.lamps[i] * mean,
                        sums.lampsUncarved[i] * mean};
        // Outside pockets the near surface is the model's own.
        if (!isCarved_.empty() && !isCarved_[patch]) light[patch].pastWalls = 1;
      }
  });
}

std::vector<float> HeightLight::luminance(const LightOptions& options, std::span<const Received> light,
                                          double albedo) const {
  const bool hasWalls = !isContinuous_;
  const auto count = static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_);
  assert(light.size() == count);
  const auto open = static_cast<float>(openIrradiance(options.lamps));
  // Luminance of the surface that hides the sky, from an estimate of the light it receives itself.
  std::vector<float> seen(patches_.height.size(), 0.0f);
  const auto again = static_cast<float>(albedo) * (hasWalls ? kBeforeWall : kAround);
  for (std::size_t patch = 0; patch < count; ++patch) {
    const Received& received = light[patch];
    const float own = (received.sky + received.lamps) / open;
    const float half = kWallFraction / 2 * own;  // a wall sees about half of what its foot and rim see
    seen[patch / static_cast<std::size_t>(size_) * static_cast<std::size_t>(stride_) + kPad +
         patch % static_cast<std::size_t>(size_)] =
        hasWalls ? half + again * (received.sky + kDarkFraction * (1 - received.sky)) * (0.5f - half)
                 : own + again * (1 - received.sky);
  }
  std::vector<float> luminance(count, 1.0f);
  LightOptions fewer = options;  // reflected light changes little from one direction to the next
  fewer.sampling.directions = std::max(options.sampling.directions / 2, kLeastDirections);
  const int points = options.sampling.points;
  forEachRow(fewer, {}, [&](int row, const auto& parts, const auto& forEachPoint) {
    std::vector<float> hidden(static_cast<std::size_t>(size_ + kMostLanes), 0.0f);
    const float* const first = &seen[row * stride_ + kPad];
    forEachPoint([&](const LightRow& in, Vec2) {
      for (const auto& [begin, end] : parts)
        addHidden(in, first, hasWalls ? first : nullptr, begin, end, hidden.data());
    });
    for (int column = 0; column < size_; ++column) {
      const auto patch = static_cast<std::size_t>(row * size_ + column);
      const float reflected = static_cast<float>(albedo) * hidden[column] / static_cast<float>(points * points);
      luminance[patch] = (light[patch].sky + light[patch].lamps) / open + reflected;
    }
  });
  return luminance;
}

}  // namespace qrelief
