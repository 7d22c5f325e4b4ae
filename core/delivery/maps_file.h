// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "pipeline/engrave.h"

namespace qrelief {

/// Encodes the maps of a carved code as NPZ, a ZIP archive of NumPy arrays [NEP 1], for people who compare methods. All
/// are float32; row 0 is at the symbol's top. N: texels along the edge of the code's picture (symbol and
/// kPictureMarginModules), S: submodules along the symbol's edge, P: passes of the depth search.
///
///     normal          N × N × 3  unit normals of the model before carving: right, up, towards the eye
///     height          N × N      its height over the QR plane, mm
///     luminance       N × N      of the carved model, 1 = unoccluded
///     depth           S × S      mm
///     pass_depth      P × S × S  depths that each pass tried, mm
///     pass_luminance  P × S × S  luminances measured at these depths, 1 = unoccluded
///
/// NaN: no surface, or not carved. Codes in colour have no pass.
/// @param result  with DepthRequest::recordSearch; not of a text alone
Result<std::vector<std::uint8_t>> encodeMaps(const EngravableModel& model, const EngraveResult& result);

}  // namespace qrelief
