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
  double cpuMs = 0;  ///< until the calls returned; the graphics processor may only begin then
  int gpuCount = 0;  ///< how many of them have a time measured by the GPU
  double gpuMs = 0;  ///< sum of those times
};

/// Whether the current context offers EXT_disjoint_timer_query; in a browser its namesake must have been enabled, too.
bool hasTimerQueries();

/// Measures the passes that a TimedPass marks while it listens; one listens at a time. Without timer queries it knows
/// the processor's time of none. Needs the context current that it was made in.
class PassTimings {
 public:
  explicit PassTimings(bool withTimerQueries) : withTimerQueries_(withTimerQueries) {}
  ~PassTimings();
  PassTimings(const PassTimings&) = delete;
  PassTimings& operator=(const PassTimings&) = delete;

  void listen();
  void stopListening();
  /// Takes in what the graphics processor has finished; browsers tell only after the task that asked has ended.
  void collect();
  bool hasGpuTimes() const { return withTimerQueries_; }
  /// In the order in which the names first came.
  std::span<const PassTime> times() const { return times_; }

 private:
  friend class TimedPass;
  struct Pending {
    GLuint query = 0;
    std::size_t pass = 0;
  };
  std::size_t indexOf(std::string_view name);

  bool withTimerQueries_ = false;
  bool queryRuns_ = false;  // they cannot be nested
  std::vector<PassTime> times_;
  std::vector<Pending> pending_;
};

/// Marks what is done until its end as one pass; costs nothing while nobody listens. Within another one, only the CPU's
/// time is measured.
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
