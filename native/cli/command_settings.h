// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace qrelief {

// Settings of `place` and `verify`: `text`, whole groups, and single keys in addition. The commands add their flags,
// and docs/options.md lists them.

inline constexpr std::array<const char*, 2> kPlaceGroups = {"symbol", "placement"};
inline constexpr std::array<const char*, 13> kPlaceKeys = {
    "mark",  "markDepthMm", "pattern", "patternMask", "finderPattern", "minWallMm", "light",
    "label", "frame",       "process", "nozzleMm",    "layerMm",       "buildUp"};

inline constexpr std::array<const char*, 2> kVerifyGroups = {"symbol", "printing"};
// The report can supply these:
inline constexpr std::array<const char*, 4> kVerifyPlaceKeys = {"direction", "up", "size", "eyeDistanceMm"};
inline constexpr std::array<const char*, 4> kVerifyMarkKeys = {"mark", "markDepthMm", "albedo", "darkReflectance"};
inline constexpr std::array<const char*, 2> kVerifyKeys = {"minWallMm", "light"};

}  // namespace qrelief
