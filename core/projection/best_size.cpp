// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/best_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "projection/size.h"

namespace qrelief {
namespace {

/// Sizes that differ by no more than this fraction count as equal: an allowance for rounding only.
constexpr double kEqualFraction = 1e-12;

double squaredSecant(double t) { return 1 + t * t; }

/// Half the edge of the square that touches one end, or one line, for t = tan(rotation) in [from, to].
struct Curve {
  bool isLine = false;  // √(1 + t²)/(a + b·t); an end: (a + b·t)/√(1 + t²)
  double a = 0, b = 0;
  double from = -1, to = 1;

  double at(double t) const {
    const double linear = a + b * t;
    const double secant = std::sqrt(squaredSecant(t));
    return isLine ? secant / linear : linear / secant;
  }
};

constexpr std::uint32_t kNoCurve = 0xffffffffu;

/// A stretch of the lower envelope; it begins where the one before it ends, the first at t = -1.
struct Stretch {
  double end = 1;
  std::uint32_t curve = kNoCurve;
};

using Envelope = std::vector<Stretch>;

Vec2 quarterTurnBack(Vec2 p) { return {p.y, -p.x}; }

/// Adds the curves of a segment's end: one side of the square meets it, and the next side where the first has turned
/// 45° away.
void addEnd(std::vector<Curve>& curves, Vec2 p) {
  while (!(std::abs(p.y) <= p.x)) p = quarterTurnBack(p);
  if (p.y >= 0) {
    const double change = (p.y - p.x) / (p.x + p.y);
    curves.push_back({false, p.y, -p.x, -1, change});
    curves.push_back({false, p.x, p.y, change, 1});
  } else {
    const double change = (p.x + p.y) / (p.x - p.y);
    curves.push_back({false, p.x, p.y, -1, change});
    curves.push_back({false, -p.y, p.x, change, 1});
  }
}

/// Returns the part of a segment in the first quadrant, as the range of t in which the corner at (1 - t, 1 + t) points
/// at it. The borders are t = -1 and t = 1 to the last bit, so the ranges of neighbouring quadrants leave no gap.
std::optional<std::array<double, 2>> cornerRange(const Segment2& segment) {
  double enter = 0, leave = 1;
  std::optional<double> atEnter, atLeave;
  for (int axis = 0; axis < 2; ++axis) {
    const double from = segment[0][axis];
    const double to = segment[1][axis];
    const double border = axis == 0 ? 1 : -1;
    if (from <= 0 && to <= 0) return {};
    if (from < 0 && from / (from - to) > enter) {
      enter = from / (from - to);
      atEnter = border;
    }
    if (to < 0 && from / (from - to) < leave) {
      leave = from / (from - to);
      atLeave = border;
    }
  }
  if (enter >= leave) return {};
  const auto tangent = [](Vec2 p) { return std::clamp((p.y - p.x) / (p.x + p.y), -1.0, 1.0); };
  const double first = atEnter.value_or(tangent(segment[0]));
  const double last = atLeave.value_or(tangent(segment[1]));
  return std::array{std::min(first, last), std::max(first, last)};
}

/// Adds the curves of a segment's line: each corner of the square sweeps one quadrant, and meets the part of the
/// segment in it.
void addLine(std::vector<Curve>& curves, Segment2 segment) {
  const double area = cross2(segment[0], segment[1]);
  if (area == 0) return;
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const Vec2 along = segment[1] - segment[0];
    if (const auto range = cornerRange(segment))
      curves.push_back({true, (along.y - along.x) / area, -(along.x + along.y) / area, (*range)[0], (*range)[1]});
    segment = {quarterTurnBack(segment[0]), quarterTurnBack(segment[1])};
  }
}

/// Solves (a + b·t)(c + d·t) = 1 + t².
std::vector<double> crossingsWithLine(double a, double b, double c, double d) {
  const double second = b * d - 1;
  const double first = a * d + b * c;
  const double constant = a * c - 1;
  const double discriminant = first * first - 4 * second * constant;
  if (discriminant < 0) return {};
  const double root = -0.5 * (first + std::copysign(std::sqrt(discriminant), first));
  std::vector<double> solutions;
  if (second != 0) solutions.push_back(root / second);
  if (root != 0) solutions.push_back(constant / root);
  std::sort(solutions.begin(), solutions.end());
  return solutions;
}

std::vector<double> crossings(const Curve& p, const Curve& q) {
  if (p.isLine != q.isLine) return crossingsWithLine(p.a, p.b, q.a, q.b);
  if (p.b == q.b) return {};
  return {(p.a - q.a) / (q.b - p.b)};
}

std::vector<double> crossingsWithLevel(const Curve& curve, double half) {
  const double scale = curve.isLine ? half : 1 / half;
  return crossingsWithLine(curve.a * scale, curve.b * scale, curve.a * scale, curve.b * scale);
}

void append(Envelope& envelope, double end, std::uint32_t curve) {
  if (!envelope.empty() && envelope.back().curve == curve)
    envelope.back().end = end;
  else
    envelope.push_back({end, curve});
}

class EnvelopeBuilder {
 public:
  explicit EnvelopeBuilder(std::span<const Curve> curves) : curves_(curves) {}

  Envelope build(std::uint32_t begin, std::uint32_t end) const {
    if (end - begin == 1) return single(begin);
    const std::uint32_t middle = begin + (end - begin) / 2;
    return merged(build(begin, middle), build(middle, end));
  }

 private:
  Envelope single(std::uint32_t index) const {
    const Curve& curve = curves_[index];
    Envelope envelope;
    if (curve.from > -1) envelope.push_back({curve.from, kNoCurve});
    if (curve.from < curve.to) envelope.push_back({curve.to, index});
    if (curve.to < 1 || envelope.empty()) append(envelope, 1, kNoCurve);
    return envelope;
  }

  Envelope merged(const Envelope& p, const Envelope& q) const {
    Envelope lower;
    double begin = -1;
    for (std::size_t i = 0, j = 0; i < p.size() && j < q.size();) {
      const double end = std::min(p[i].end, q[j].end);
      addLower(lower, begin, end, p[i].curve, q[j].curve);
      begin = end;
      if (p[i].end <= end) ++i;
      if (q[j].end <= end) ++j;
    }
    return lower;
  }

  void addLower(Envelope& lower, double begin, double end, std::uint32_t p, std::uint32_t q) const {
    if (p == kNoCurve || q == kNoCurve) return append(lower, end, p == kNoCurve ? q : p);
    std::vector<double> cuts = crossings(curves_[p], curves_[q]);
    cuts.push_back(end);
    for (const double cut : cuts) {
      if (!(cut > begin && cut <= end)) continue;
      const double middle = (begin + cut) / 2;
      append(lower, cut, curves_[p].at(middle) <= curves_[q].at(middle) ? p : q);
      begin = cut;
    }
  }

  std::span<const Curve> curves_;
};

/// Half the edge that fits at a rotation, and t = tan(rotation).
struct Candidate {
  double half = 0;
  double t = 0;
};

/// Adds the candidates of a stretch: its ends, its maximum, the points where it passes the greatest size, and its
/// smallest rotation.
void addCandidates(std::vector<Candidate>& candidates, const Curve* curve, double begin, double end, double mostHalf) {
  const auto add = [&](double t) {
    if (t >= begin && t <= end) candidates.push_back({curve ? std::min(mostHalf, curve->at(t)) : mostHalf, t});
  };
  add(begin);
  add(end);
  add(0);
  if (!curve) return;
  if (!curve->isLine && curve->a > 0) add(curve->b / curve->a);
  for (const double t : crossingsWithLevel(*curve, mostHalf)) add(t);
}

/// Returns tan of the rotation at which the largest square fits.
double bestTangent(std::span<const Curve> curves, double mostHalf) {
  const Envelope envelope = EnvelopeBuilder(curves).build(0, static_cast<std::uint32_t>(curves.size()));
  std::vector<Candidate> candidates;
  double begin = -1;
  for (const Stretch& stretch : envelope) {
    addCandidates(candidates, stretch.curve == kNoCurve ? nullptr : &curves[stretch.curve], begin, stretch.end,
                  mostHalf);
    begin = stretch.end;
  }
  double most = 0;
  for (const Candidate& candidate : candidates) most = std::max(most, candidate.half);
  double best = 2;
  for (const Candidate& candidate : candidates)
    if (candidate.half >= most * (1 - kEqualFraction) && std::abs(candidate.t) < std::abs(best)) best = candidate.t;
  return best;
}

}  // namespace

TurnedSquare bestSize(std::span<const Segment2> silhouette, double maxMm) {
  const std::optional<Vec2> nearest = nearestSilhouettePoint(silhouette);
  if (!nearest) return {maxMm, 0};
  const double distance = glm::length(*nearest);
  if (distance == 0) return {0, 0};

  // A square whose inscribed circle reaches beyond the nearest point does not fit. A square within √2 of that meets
  // none of the skipped segments.
  const double reach = std::numbers::sqrt2 * std::min(distance, maxMm / 2) * (1 + kEqualFraction);
  std::vector<Curve> curves;
  for (const Segment2& segment : silhouette) {
    if (distanceToSegment(Vec2(0), segment) > reach) continue;
    addEnd(curves, segment[0]);
    addEnd(curves, segment[1]);
    addLine(curves, segment);
  }
  const double straight = std::min(maxMm, orientedSize(silhouette));
  if (curves.empty()) return {straight, 0};
  const double rotation = std::atan(bestTangent(curves, maxMm / 2));
  const double turned = std::min(maxMm, orientedSize(inTurnedAxes(silhouette, rotation)));
  return turned > straight ? TurnedSquare{turned, rotation} : TurnedSquare{straight, 0};
}

std::vector<Segment2> inTurnedAxes(std::span<const Segment2> segments, double rotation) {
  const Vec2 right(std::cos(rotation), std::sin(rotation));
  const auto turned = [&](Vec2 p) { return Vec2(glm::dot(right, p), cross2(right, p)); };
  std::vector<Segment2> result;
  result.reserve(segments.size());
  for (const Segment2& segment : segments) result.push_back({turned(segment[0]), turned(segment[1])});
  return result;
}

}  // namespace qrelief
