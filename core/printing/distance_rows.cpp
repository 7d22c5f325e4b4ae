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

/// Of the nodes of a row from `column` on, a vector of them at a time while they last.
template <class Lanes>
HWY_INLINE int lowerFrom(Lanes lanes, const SegmentRows& in, float* held, float y, float perLength, int column) {
  const auto number = [&](float value) { return hn::Set(lanes, value); };
  const auto fromY = number(y), towardsY = number(y * in.alongY);
  for (; column + static_cast<int>(hn::Lanes(lanes)) <= in.columns; column += static_cast<int>(hn::Lanes(lanes))) {
    // Products and sums stay apart: fused, they would differ between machines.
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

}  // namespace qrelief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace qrelief {

HWY_EXPORT(lowerRowsOfSegment);

void lowerRows(const SegmentRows& rows) { HWY_DYNAMIC_DISPATCH(lowerRowsOfSegment)(rows); }

}  // namespace qrelief
#endif
