// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "engine/loaded_model.h"
#include "pipeline/placement.h"
#include "viewer/viewer.h"

namespace qrelief {

/// Returns the picture of a simulated print as ink for the uncarved surface. The picture's light modules become the
/// surface itself, and its margin ends softly.
/// @param pixels  size² sRGB greys of the symbol from the front with kPictureMarginModules around it, row 0 at the top;
///                not empty
/// @param isShadow  the code is dark by its shadows, which the view exaggerates
/// @returns the errors of lookAround()
Result<Decal> printDecal(const LoadedModel& model, const Placement& placement, std::span<const std::uint8_t> pixels,
                         int size, bool isShadow);

}  // namespace qrelief
