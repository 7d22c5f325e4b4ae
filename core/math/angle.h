// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace qrelief {

constexpr double toRadians(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double toDegrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace qrelief
