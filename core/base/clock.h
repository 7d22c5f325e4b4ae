// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace qrelief {

/// Never goes back and never jumps.
using Clock = std::chrono::steady_clock;

inline double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// On the clock's own scale, for differences.
inline double nowMs() { return millisecondsSince({}); }

}  // namespace qrelief
