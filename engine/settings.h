// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "base/result.h"
#include "pipeline/engrave.h"

namespace qrelief {

/// The page's settings as a request; what is missing has its default. Centre and up axis are not among them.
///
///     {"text", "ecc": "L|M|Q|H", "pattern": "none|square|…", "finderPattern": "none|as-modules|…",
///      "size": "free|oriented|best"|mm, "maxSizeMm", "quietZone": bool,
///      "direction": "mean-normal|depth-balanced|pca|optimal",
///      "rotateDeg", "contrast", "minWallMm", "maxDepthMm", "eyeDistanceMm"}
///
/// @returns BadUsage naming the setting whose value is of the wrong kind; ranges are EngraveJob's business
Result<EngraveRequest> readSettings(std::string_view json);

}  // namespace qrelief
