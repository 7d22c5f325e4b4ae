// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/floor_horizons.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "depth/floor_horizons.cpp"
#include <hwy/foreach_target.h>  // includes this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace qrelief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

SkySeen skySeenFromFloor(const float* own, float depthMm, const FloorSteps& steps) {
  const hn::CappedTag<float, kFloorDirections> lanes;
  const hn::RebindToSigned<decltype(lanes)> integers;
  const auto depth = hn::Set(lanes, depthMm), one = hn::Set(lanes, 1);
  float seen[kFloorDirections], falls[kFloorDirections];
  for (std::size_t k = 0; k < kFloorDirections; k += hn::Lanes(lanes)) {
    auto steepest = hn::Zero(lanes), steepestPerMm = hn::Zero(lanes);  // tangent of the horizon's elevation
    for (std::size_t i = k; i < steps.perMm.size(); i += kFloorDirections) {
      const auto perMm = hn::LoadU(lanes, &steps.perMm[i]);
      // Farther on nothing can rise above the horizon so far: no cell is higher than a light one, of depth 0.
      if (hn::AllTrue(lanes, hn::Le(hn::Mul(depth, perMm), steepest))) break;
      const auto top = hn::GatherIndex(lanes, own, hn::LoadU(integers, &steps.offset[i]));
      const auto steep = hn::Mul(hn::Sub(depth, top), perMm);
      steepestPerMm = hn::IfThenElse(hn::Gt(steep, steepest), perMm, steepestPerMm);
      steepest = hn::Max(steepest, steep);
    }
    // Products and sums stay separate: fused, they would differ between machines.
    const auto fraction = hn::Div(one, hn::Add(one, hn::Mul(steepest, steepest)));
    hn::StoreU(fraction, lanes, seen + k);
    hn::StoreU(hn::Mul(hn::Mul(steepest, steepestPerMm), hn::Mul(fraction, fraction)), lanes, falls + k);
  }
  SkySeen sum;
  for (int k = 0; k < kFloorDirections; ++k) {
    sum.fraction += static_cast<double>(seen[k]) / kFloorDirections;
    sum.perMm -= 2 * static_cast<double>(falls[k]) / kFloorDirections;
  }
  return sum;
}

}  // namespace qrelief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace qrelief {

HWY_EXPORT(skySeenFromFloor);

SkySeen skySeenFrom(const float* own, float depthMm, const FloorSteps& steps) {
  return HWY_DYNAMIC_DISPATCH(skySeenFromFloor)(own, depthMm, steps);
}

}  // namespace qrelief
#endif
