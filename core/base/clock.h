// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace qrelief {

/// The clock of all timings: it never goes back and never jumps.
using Clock = std::chrono::steady_clock;

inline double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Returns the clock's own reading, ms; only differences mean anything.
inline double nowMs() { return millisecondsSince({}); }

}  // namespace qrelief
