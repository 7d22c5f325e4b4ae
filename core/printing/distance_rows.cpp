// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/distance_rows.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "printing/distance_rows.cpp"
#include <hwy/foreach_target.h>  // includes this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace qrelief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Lowers the distances of a row's nodes from `column` on, a vector at a time; returns the first node left over.
template <class Lanes>
HWY_INLINE int lowerFrom(Lanes lanes, const SegmentRows& in, float* held, float y, float perLength, int column) {
  const auto number = [&](float value) { return hn::Set(lanes, value); };
  const auto fromY = number(y), towardsY = number(y * in.alongY);
  for (; column + static_cast<int>(hn::Lanes(lanes)) <= in.columns; column += static_cast<int>(hn::Lanes(lanes))) {
    // Products and sums stay separate: fused, they would differ between machines.
    const auto steps = hn::Mul(hn::Iota(lanes, static_cast<float>(column)), number(in.step));
    const auto x = hn::Sub(steps, number(in.x));
    const auto along = hn::Mul(hn::Add(hn::Mul(x, number(in.alongX)), towardsY), number(perLength));
    const auto t = hn::Min(hn::Max(along, number(0)), number(1));
    const auto dx = hn::Sub(x, hn::Mul(t, number(in.alongX))), dy = hn::Sub(fromY, hn::Mul(t, number(in.alongY)));
    const auto square = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
    hn::StoreU(hn::Min(hn::LoadU(lanes, held + column), square), lanes, held + column);
  }
  return column;
}

void lowerRowsOfSegment(const SegmentRows& in) {
  const float length = in.alongX * in.alongX + in.alongY * in.alongY;
  const float perLength = 1 / (length > std::numeric_limits<float>::min() ? length : std::numeric_limits<float>::min());
  for (int row = 0; row < in.rows; ++row) {
    float* const held = in.held + static_cast<std::size_t>(row) * in.stride;
    const float y = in.step * static_cast<float>(row) - in.y;
    const int last = lowerFrom(hn::CappedTag<float, 8>(), in, held, y, perLength, 0);
    const int left = lowerFrom(hn::CappedTag<float, 4>(), in, held, y, perLength, last);
    lowerFrom(hn::CappedTag<float, 1>(), in, held, y, perLength, left);
  }
}

/// Calls visit(lanes, i) for 0 … count − 1, a vector at a time, and one by one at the end.
template <class Visit>
HWY_INLINE void forVectors(std::size_t count, const Visit& visit) {
  const hn::CappedTag<float, 8> lanes;
  std::size_t i = 0;
  for (; i + hn::Lanes(lanes) <= count; i += hn::Lanes(lanes)) visit(lanes, i);
  for (; i < count; ++i) visit(hn::CappedTag<float, 1>(), i);
}

void signedDistancesOfRows(float* held, const float* inside, float lessThan, float lessMm, std::size_t count) {
  forVectors(count, [&](auto lanes, std::size_t i) {
    const auto distance = hn::Sqrt(hn::LoadU(lanes, held + i));
    const auto isInside = hn::Lt(hn::LoadU(lanes, inside + i), hn::Set(lanes, lessThan));
    const auto signedDistance = hn::IfThenElse(isInside, hn::Neg(distance), distance);
    hn::StoreU(hn::Sub(signedDistance, hn::Set(lanes, lessMm)), lanes, held + i);
  });
}

int nextCrossedInRow(const float* lower, const float* upper, float value, int column, int columns) {
  const hn::CappedTag<float, 8> lanes;
  const auto at = hn::Set(lanes, value);
  for (; column + static_cast<int>(hn::Lanes(lanes)) <= columns; column += static_cast<int>(hn::Lanes(lanes))) {
    const auto a = hn::LoadU(lanes, lower + column), b = hn::LoadU(lanes, lower + column + 1);
    const auto c = hn::LoadU(lanes, upper + column), d = hn::LoadU(lanes, upper + column + 1);
    const auto least = hn::Min(hn::Min(a, b), hn::Min(c, d)), most = hn::Max(hn::Max(a, b), hn::Max(c, d));
    if (!hn::AllFalse(lanes, hn::And(hn::Lt(least, at), hn::Ge(most, at)))) return column;
  }
  return column;
}

bool anyThinInRow(const float* extruded, const float* solid, float deepest, std::size_t count) {
  bool any = false;
  forVectors(count, [&](auto lanes, std::size_t i) {
    const auto isOpen = hn::Gt(hn::LoadU(lanes, extruded + i), hn::Zero(lanes));
    const auto isDeep = hn::Le(hn::LoadU(lanes, solid + i), hn::Set(lanes, deepest));
    any = any || !hn::AllFalse(lanes, hn::And(isOpen, isDeep));
  });
  return any;
}

}  // namespace qrelief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace qrelief {

HWY_EXPORT(lowerRowsOfSegment);

HWY_EXPORT(signedDistancesOfRows);
HWY_EXPORT(nextCrossedInRow);
HWY_EXPORT(anyThinInRow);

void lowerRows(const SegmentRows& rows) { HWY_DYNAMIC_DISPATCH(lowerRowsOfSegment)(rows); }

void signedDistances(float* held, const float* inside, float lessThan, float lessMm, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(signedDistancesOfRows)(held, inside, lessThan, lessMm, count);
}

int nextCrossed(const float* lower, const float* upper, float value, int column, int columns) {
  return HWY_DYNAMIC_DISPATCH(nextCrossedInRow)(lower, upper, value, column, columns);
}

bool anyThin(const float* extruded, const float* solid, float deepest, std::size_t count) {
  return HWY_DYNAMIC_DISPATCH(anyThinInRow)(extruded, solid, deepest, count);
}

}  // namespace qrelief
#endif
