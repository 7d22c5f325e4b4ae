// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GLES3/gl3.h>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/clock.h"

namespace qrelief::gl {

/// Time spent in all passes of one name.
struct PassTime {
  std::string_view name;  ///< static
  int count = 0;
  double cpuMs = 0;  ///< until the calls returned; the GPU may begin only then
  int gpuCount = 0;  ///< passes whose time the GPU measured
  double gpuMs = 0;  ///< sum of those times
};

/// Returns true if the current context offers EXT_disjoint_timer_query. In a browser the extension must have been
/// enabled first, under its WebGL 2 name.
bool hasTimerQueries();

/// Measures the passes that TimedPass marks while this listens; one object listens at a time. Without timer queries it
/// measures CPU time only. Needs its own context to be current.
class PassTimings {
 public:
  using Now = Clock::time_point (*)();
  /// @param now  clock of the CPU times
  explicit PassTimings(bool withTimerQueries, Now now = Clock::now) : withTimerQueries_(withTimerQueries), now_(now) {}
  ~PassTimings();
  PassTimings(const PassTimings&) = delete;
  PassTimings& operator=(const PassTimings&) = delete;

  void listen();
  void stopListening();
  /// Collects the times of passes that the GPU has finished. Browsers deliver them only after the present task has
  /// ended.
  void collect();
  bool hasGpuTimes() const { return withTimerQueries_; }
  /// Returns the times in the order in which their names first occurred.
  std::span<const PassTime> times() const { return times_; }

 private:
  friend class TimedPass;
  struct Pending {
    GLuint query = 0;
    std::size_t pass = 0;
  };
  std::size_t indexOf(std::string_view name);

  bool withTimerQueries_ = false;
  Now now_;
  bool queryRuns_ = false;  // queries cannot be nested
  std::vector<PassTime> times_;
  std::vector<Pending> pending_;
};

/// Marks the work during its lifetime as one pass; costs nothing while nobody listens. Within another TimedPass, only
/// CPU time is measured.
class TimedPass {
 public:
  /// @param name  static
  explicit TimedPass(std::string_view name);
  ~TimedPass();
  TimedPass(const TimedPass&) = delete;
  TimedPass& operator=(const TimedPass&) = delete;

 private:
  PassTimings* timings_ = nullptr;
  std::size_t pass_ = 0;
  bool ownsQuery_ = false;
  Clock::time_point start_;
};

}  // namespace qrelief::gl
