// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/light_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/light_rows.cpp"
#include <hwy/foreach_target.h>  // includes this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace qrelief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, kMostLanes>;
using Floats = hn::Vec<Lanes>;
constexpr float kPi = 3.14159265f;
constexpr float kSteepestCotangent = 100;
constexpr std::size_t kStepsBetweenChecks = 4;
constexpr float kFarLuminance = 0.91f;  // luminance of the model's farther surface, as in received.cpp

// Products and sums stay separate everywhere: fused, they would differ between machines.
HWY_INLINE Floats number(float value) { return hn::Set(Lanes(), value); }
HWY_INLINE Floats timesPlus(Floats a, Floats b, Floats c) { return hn::Add(hn::Mul(a, b), c); }

/// Computes the arc tangent of x in [−1, 1], to 1e-5 [Abramowitz and Stegun 1964, 4.4.49].
HWY_INLINE Floats arcTangentNearZero(Floats x) {
  const Floats square = hn::Mul(x, x);
  Floats sum = number(0.0208351f);
  sum = timesPlus(sum, square, number(-0.0851330f));
  sum = timesPlus(sum, square, number(0.1801410f));
  sum = timesPlus(sum, square, number(-0.3302995f));
  sum = timesPlus(sum, square, number(0.9998660f));
  return hn::Mul(sum, x);
}

/// Returns the angle in (0, π) of a cotangent.
HWY_INLINE Floats arcCotangent(Floats cotangent) {
  const auto isNear = hn::Le(hn::Abs(cotangent), number(1));
  const Floats x = hn::IfThenElse(isNear, cotangent, hn::Div(number(1), cotangent));
  const Floats angle = arcTangentNearZero(x);
  const Floats beyond = hn::IfThenElse(hn::Lt(cotangent, number(0)), hn::Add(number(kPi), angle), angle);
  return hn::IfThenElse(isNear, hn::Sub(number(kPi / 2), angle), beyond);
}

/// Returns the cosine-weighted light from between the line of sight and a horizon, per radian of direction, times 2.
/// The surface's own horizon is `tangent`, and its normal has the cosine 1 to the line of sight.
HWY_INLINE Floats skyOver(Floats horizon, Floats tangent) {
  const Floats sineSquare = hn::Div(number(1), timesPlus(horizon, horizon, number(1)));
  const Floats beside = hn::Sub(arcCotangent(horizon), hn::Mul(horizon, sineSquare));
  return hn::Sub(sineSquare, hn::Mul(tangent, beside));
}

/// A vector of points: their places, and the factors that turn slopes into cotangents.
struct Points {
  Floats x, y, height;
  Floats perSlope;        // A·L of LightRow: (eyeDistance² + x² + y²)/(height + eyeDistance)
  Floats sightSquare;     // eyeDistance² + x² + y²
  Floats slopeX, slopeY;  // of their receivers
};

HWY_INLINE Points pointsOf(const LightRow& row, int column) {
  const Lanes lanes;
  Points points;
  points.slopeX = hn::LoadU(lanes, row.receivers.slopeX + column);
  points.slopeY = hn::LoadU(lanes, row.receivers.slopeY + column);
  points.height = hn::Add(hn::LoadU(lanes, row.receivers.height + column),
                          timesPlus(points.slopeX, number(row.rightMm), hn::Mul(points.slopeY, number(row.upMm))));
  points.x = timesPlus(hn::Iota(lanes, static_cast<float>(column)), number(row.patchMm), number(row.firstX));
  points.y = number(row.y);
  const Floats across = timesPlus(points.x, points.x, hn::Mul(points.y, points.y));
  points.sightSquare = hn::Add(across, number(row.eyeDistance * row.eyeDistance));
  points.perSlope = hn::Div(points.sightSquare, hn::Add(points.height, number(row.eyeDistance)));
  return points;
}

/// Positions of points on lines of a direction.
struct OnLine {
  Floats forward;   // s of LightRow
  Floats perAside;  // 1/L
  Floats ownSlope;  // of the points' own receivers
};

HWY_INLINE OnLine onLine(const LightRow& row, const Points& points, float cosine, float sine) {
  OnLine line;
  line.forward = timesPlus(points.x, number(cosine), hn::Mul(points.y, number(sine)));
  const Floats aside = hn::Sub(hn::Mul(points.y, number(cosine)), hn::Mul(points.x, number(sine)));
  line.perAside = hn::Div(number(1), hn::Sqrt(timesPlus(aside, aside, number(row.eyeDistance * row.eyeDistance))));
  line.ownSlope = timesPlus(points.slopeX, number(cosine), hn::Mul(points.slopeY, number(sine)));
  return line;
}

HWY_INLINE Floats cotangentOf(const Points& points, const OnLine& line, Floats slope) {
  const Floats cotangent = hn::Mul(hn::Sub(hn::Mul(points.perSlope, slope), line.forward), line.perAside);
  return hn::Min(hn::Max(cotangent, number(-kSteepestCotangent)), number(kSteepestCotangent));
}

/// Heights at the borders that points pass on their way outwards.
template <bool Continuous>
class Borders {
 public:
  HWY_INLINE Borders(const LightRow& row, int column)
      : row_(row), column_(column), before_(hn::LoadU(Lanes(), row.patches.height + column)) {}

  HWY_INLINE Floats heightAt(const HorizonStep& step) {
    const Lanes lanes;
    const int at = column_ + step.patch;
    const Floats middle = hn::LoadU(lanes, row_.patches.height + at);
    if constexpr (Continuous) {
      const Floats border = timesPlus(hn::Sub(middle, before_), number(step.fromBefore), before_);
      before_ = middle;
      return border;
    } else {
      const Floats right = hn::Mul(hn::LoadU(lanes, row_.patches.slopeX + at), number(step.rightMm));
      const Floats up = hn::Mul(hn::LoadU(lanes, row_.patches.slopeY + at), number(step.upMm));
      return hn::Add(middle, hn::Add(right, up));
    }
  }

 private:
  const LightRow& row_;
  int column_;
  Floats before_;  // height at the middle of the previous patch
};

/// Returns the number of steps that stay in the map for some patches: once outside, steps never come back.
HWY_INLINE std::size_t stepsInMap(const LightRow& row, const HorizonDirection& direction, int column) {
  const auto isInMap = [&](std::size_t k) {
    const int atRow = row.row + direction.steps[k].row, atColumn = column + direction.steps[k].column;
    return atRow >= 0 && atRow < row.size && atColumn > -kMostLanes && atColumn < row.size;
  };
  std::size_t inside = 0, outside = direction.steps.size();
  if (outside == 0 || isInMap(outside - 1)) return outside;
  while (inside < outside) {
    const std::size_t middle = inside + (outside - inside) / 2;
    if (isInMap(middle))
      inside = middle + 1;
    else
      outside = middle;
  }
  return inside;
}

HWY_INLINE Floats farCotangent(const LightRow& row, const HorizonDirection& direction, int column) {
  const hn::CappedTag<std::int32_t, kMostLanes> integers;
  const Lanes lanes;
  const auto places = hn::LoadU(integers, row.farPlace + column);
  const float* const from = row.farCotangents + static_cast<std::size_t>(direction.farSector) * row.farPlaces;
  const float* const to = row.farCotangents + static_cast<std::size_t>((direction.farSector + 1) % 16) * row.farPlaces;
  const Floats first = hn::GatherIndex(lanes, from, places), second = hn::GatherIndex(lanes, to, places);
  return timesPlus(hn::Sub(second, first), number(direction.farFraction), first);
}

/// Returns the cosines between the points' normals and their lines of sight.
HWY_INLINE Floats facingCosine(const LightRow& row, const Points& points) {
  const Floats perEye = number(1 / row.eyeDistance);
  const Floats right = hn::Mul(hn::Sub(hn::Mul(points.perSlope, points.slopeX), points.x), perEye);
  const Floats up = hn::Mul(hn::Sub(hn::Mul(points.perSlope, points.slopeY), points.y), perEye);
  return hn::Div(number(1), hn::Sqrt(hn::Add(number(1), timesPlus(right, right, hn::Mul(up, up)))));
}

template <bool Continuous>
void addSkyTo(const LightRow& row, int begin, int end, float* sky, float* pastWalls) {
  const Lanes lanes;
  const float perDirection = 1 / static_cast<float>(row.directions.size());
  for (int column = begin; column < end; column += static_cast<int>(hn::Lanes(lanes))) {
    const Points points = pointsOf(row, column);
    const Floats below = hn::Sub(number(row.highest), points.height);
    const Floats sight = hn::Sqrt(points.sightSquare);
    Floats sum = number(0), sumPast = number(0);
    for (const HorizonDirection& direction : row.directions) {
      const OnLine line = onLine(row, points, direction.cosine, direction.sine);
      Floats highest = line.ownSlope;
      Borders<Continuous> borders(row, column);
      const std::size_t steps = stepsInMap(row, direction, column);
      for (std::size_t k = 0; k < steps;) {
        const std::size_t stop = k + kStepsBetweenChecks < steps ? k + kStepsBetweenChecks : steps;
        for (; k < stop; ++k) {
          const HorizonStep& step = direction.steps[k];
          const Floats rise = hn::Sub(borders.heightAt(step), points.height);
          highest = hn::Max(highest, hn::Mul(rise, number(step.perMm)));
        }
        // Beyond this step nothing can rise above the horizon so far.
        if (hn::AllTrue(lanes, hn::Le(hn::Mul(below, number(direction.steps[k - 1].perMm)), highest))) break;
      }
      const Floats tangent = cotangentOf(points, line, line.ownSlope);
      const Floats wall = cotangentOf(points, line, highest);
      // Directions are evenly spaced in the map; seen along the line of sight they are denser across its tilt.
      const Floats width = hn::Mul(hn::Mul(sight, number(row.eyeDistance)), hn::Mul(line.perAside, line.perAside));
      const Floats past = hn::Mul(width, skyOver(wall, tangent));
      sumPast = hn::Add(sumPast, past);
      if (row.farCotangents) {
        const Floats far = farCotangent(row, direction, column);
        const Floats horizon = hn::Max(hn::Max(far, tangent), wall);
        sum = hn::Add(sum, hn::Mul(width, skyOver(horizon, tangent)));
      } else {
        sum = hn::Add(sum, past);
      }
    }
    const Floats scale = hn::Mul(facingCosine(row, points), number(perDirection));
    hn::StoreU(timesPlus(sum, scale, hn::LoadU(lanes, sky + column)), lanes, sky + column);
    hn::StoreU(timesPlus(sumPast, scale, hn::LoadU(lanes, pastWalls + column)), lanes, pastWalls + column);
  }
}

template <bool Continuous>
void addHiddenTo(const LightRow& row, const float* climbing, const float* walls, int begin, int end, float* hidden) {
  const Lanes lanes;
  const float perDirection = 1 / static_cast<float>(row.directions.size());
  for (int column = begin; column < end; column += static_cast<int>(hn::Lanes(lanes))) {
    const Points points = pointsOf(row, column);
    const Floats below = hn::Sub(number(row.highest), points.height);
    const Floats sight = hn::Sqrt(points.sightSquare);
    Floats sum = number(0);
    for (const HorizonDirection& direction : row.directions) {
      const OnLine line = onLine(row, points, direction.cosine, direction.sine);
      Floats highest = line.ownSlope, climbed = number(0);
      Borders<Continuous> borders(row, column);
      const std::size_t steps = stepsInMap(row, direction, column);
      int before = column;
      for (std::size_t k = 0; k < steps;) {
        const std::size_t stop = k + kStepsBetweenChecks < steps ? k + kStepsBetweenChecks : steps;
        for (; k < stop; ++k) {
          const HorizonStep& step = direction.steps[k];
          const Floats rise = hn::Sub(borders.heightAt(step), points.height);
          const Floats more = hn::Max(hn::Sub(hn::Mul(rise, number(step.perMm)), highest), number(0));
          const int at = column + step.patch;
          Floats seen;
          if (walls)
            seen = hn::Add(hn::LoadU(lanes, walls + before), hn::LoadU(lanes, walls + at));
          else
            seen = hn::LoadU(lanes, climbing + before);
          climbed = timesPlus(more, seen, climbed);
          highest = hn::Add(highest, more);
          before = at;
        }
        if (hn::AllTrue(lanes, hn::Le(hn::Mul(below, number(direction.steps[k - 1].perMm)), highest))) break;
      }
      const Floats mean = hn::Div(climbed, hn::Max(hn::Sub(highest, line.ownSlope), number(1e-6f)));
      const Floats tangent = cotangentOf(points, line, line.ownSlope);
      const Floats wall = cotangentOf(points, line, highest);
      const Floats width = hn::Mul(hn::Mul(sight, number(row.eyeDistance)), hn::Mul(line.perAside, line.perAside));
      const Floats past = skyOver(wall, tangent);
      Floats share = hn::Mul(hn::Sub(skyOver(tangent, tangent), past), mean);
      if (row.farCotangents) {
        const Floats far = hn::Max(hn::Max(farCotangent(row, direction, column), tangent), wall);
        share = timesPlus(hn::Sub(past, skyOver(far, tangent)), number(kFarLuminance), share);
      }
      sum = timesPlus(width, share, sum);
    }
    const Floats scale = hn::Mul(facingCosine(row, points), number(perDirection));
    hn::StoreU(timesPlus(sum, scale, hn::LoadU(lanes, hidden + column)), lanes, hidden + column);
  }
}

void addLampOfRow(const LightRow& row, const LampStretch& lamp, int begin, int end, float* carved, float* uncarved) {
  const Lanes lanes;
  const HorizonDirection& direction = lamp.direction;
  const float perEye = 1 / row.eyeDistance;
  for (int column = begin; column < end; column += static_cast<int>(hn::Lanes(lanes))) {
    const Points points = pointsOf(row, column);
    const Floats perScale = timesPlus(points.height, number(perEye), number(1));  // eyeDistance / depth
    // A ray to the lamp climbs in the map by this slope, along a line that turns slightly over the map.
    const Floats alongX = timesPlus(points.x, number(lamp.z * perEye), number(lamp.x));
    const Floats alongY = timesPlus(points.y, number(lamp.z * perEye), number(lamp.y));
    const Floats along = hn::Sqrt(timesPlus(alongX, alongX, hn::Mul(alongY, alongY)));
    const Floats climb = hn::Div(hn::Mul(number(lamp.z), perScale), hn::Max(along, number(1e-6f)));
    const Floats perClimb = hn::Div(number(1), climb);
    // The edge of a shadow must not reach so far before its occluder that a plane shades itself.
    const OnLine line = onLine(row, points, direction.cosine, direction.sine);
    const Floats overOwnPlane = hn::Sub(number(1), hn::Mul(line.ownSlope, perClimb));
    const Floats leastPerEdge = hn::Div(number(0.5f), hn::Max(overOwnPlane, number(1e-3f)));
    Floats over = number(-1e6f);
    Borders<false> borders(row, column);
    const std::size_t steps = stepsInMap(row, direction, column);
    for (std::size_t k = 0; k < steps; ++k) {
      const HorizonStep& step = direction.steps[k];
      // End of its shadow.
      const Floats shadow = hn::Mul(hn::Sub(borders.heightAt(step), points.height), perClimb);
      const Floats perEdge = hn::Max(number(lamp.perShadowEdge[k]), hn::Mul(leastPerEdge, number(step.perMm)));
      over = hn::Max(over, hn::Mul(hn::Sub(shadow, number(1 / step.perMm)), perEdge));
    }
    const Floats lit = hn::Min(hn::Max(hn::Sub(number(0.5f), over), number(0)), number(1));

    const Floats perPatch = hn::Div(number(1), perScale);
    const Floats right = hn::Mul(perPatch, points.slopeX), up = hn::Mul(perPatch, points.slopeY);
    const Floats towards =
        hn::Sub(number(1), hn::Mul(number(perEye), timesPlus(points.x, right, hn::Mul(points.y, up))));
    const Floats length = hn::Sqrt(hn::Add(hn::Mul(towards, towards), timesPlus(right, right, hn::Mul(up, up))));
    const Floats across = timesPlus(right, number(lamp.x), hn::Mul(up, number(lamp.y)));
    Floats facing = hn::Div(hn::Sub(hn::Mul(towards, number(lamp.z)), across), length);
    facing = hn::Mul(hn::Max(facing, number(0)), number(lamp.strength));
    if (row.farCotangents) {
      const auto isHidden = hn::Le(cotangentOf(points, line, climb), farCotangent(row, direction, column));
      facing = hn::IfThenZeroElse(isHidden, facing);
    }
    hn::StoreU(timesPlus(facing, lit, hn::LoadU(lanes, carved + column)), lanes, carved + column);
    hn::StoreU(hn::Add(facing, hn::LoadU(lanes, uncarved + column)), lanes, uncarved + column);
  }
}

void addSkyOfRow(const LightRow& row, int begin, int end, float* sky, float* pastWalls) {
  return row.isContinuous ? addSkyTo<true>(row, begin, end, sky, pastWalls)
                          : addSkyTo<false>(row, begin, end, sky, pastWalls);
}

void addHiddenOfRow(const LightRow& row, const float* climbing, const float* walls, int begin, int end, float* hidden) {
  return row.isContinuous ? addHiddenTo<true>(row, climbing, walls, begin, end, hidden)
                          : addHiddenTo<false>(row, climbing, walls, begin, end, hidden);
}

}  // namespace qrelief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace qrelief {

HWY_EXPORT(addSkyOfRow);
HWY_EXPORT(addHiddenOfRow);
HWY_EXPORT(addLampOfRow);

void addSky(const LightRow& row, int begin, int end, float* sky, float* pastWalls) {
  HWY_DYNAMIC_DISPATCH(addSkyOfRow)(row, begin, end, sky, pastWalls);
}

void addHidden(const LightRow& row, const float* climbing, const float* walls, int begin, int end, float* hidden) {
  HWY_DYNAMIC_DISPATCH(addHiddenOfRow)(row, climbing, walls, begin, end, hidden);
}

void addLamp(const LightRow& row, const LampStretch& lamp, int begin, int end, float* carved, float* uncarved) {
  HWY_DYNAMIC_DISPATCH(addLampOfRow)(row, lamp, begin, end, carved, uncarved);
}

}  // namespace qrelief
#endif
