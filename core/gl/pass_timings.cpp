// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/pass_timings.h"

#include <algorithm>

namespace qrelief::gl {
namespace {

// EXT_disjoint_timer_query and EXT_disjoint_timer_query_webgl2 share these.
constexpr GLenum kTimeElapsed = 0x88BF;
constexpr GLenum kDisjoint = 0x8FBB;  // true if the clock has jumped since the last call: all measurements are void

PassTimings* listening = nullptr;

}  // namespace

bool hasTimerQueries() {
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const GLubyte* name = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (name && std::string_view(reinterpret_cast<const char*>(name)) == "GL_EXT_disjoint_timer_query") return true;
  }
  return false;
}

PassTimings::~PassTimings() {
  stopListening();
  for (const Pending& pending : pending_) glDeleteQueries(1, &pending.query);
}

void PassTimings::listen() { listening = this; }

void PassTimings::stopListening() {
  if (listening == this) listening = nullptr;
}

void PassTimings::collect() {
  if (pending_.empty()) return;
  GLint disjoint = 0;
  glGetIntegerv(kDisjoint, &disjoint);
  const auto isDone = [&](const Pending& pending) {
    GLuint available = disjoint ? GL_TRUE : GL_FALSE;
    if (!disjoint) glGetQueryObjectuiv(pending.query, GL_QUERY_RESULT_AVAILABLE, &available);
    if (!available) return false;
    GLuint nanoseconds = 0;
    if (!disjoint) {
      glGetQueryObjectuiv(pending.query, GL_QUERY_RESULT, &nanoseconds);
      times_[pending.pass].gpuMs += nanoseconds * 1e-6;
      ++times_[pending.pass].gpuCount;
    }
    glDeleteQueries(1, &pending.query);
    return true;
  };
  pending_.erase(std::remove_if(pending_.begin(), pending_.end(), isDone), pending_.end());
}

std::size_t PassTimings::indexOf(std::string_view name) {
  const auto it = std::find_if(times_.begin(), times_.end(), [&](const PassTime& time) { return time.name == name; });
  const auto index = static_cast<std::size_t>(it - times_.begin());
  if (it == times_.end()) times_.push_back({.name = name});
  return index;
}

TimedPass::TimedPass(std::string_view name) : timings_(listening) {
  if (!timings_) return;
  pass_ = timings_->indexOf(name);
  if (timings_->withTimerQueries_ && !timings_->queryRuns_) {
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(kTimeElapsed, query);
    timings_->pending_.push_back({query, pass_});
    timings_->queryRuns_ = ownsQuery_ = true;
  }
  start_ = timings_->now_();
}

TimedPass::~TimedPass() {
  if (!timings_) return;
  PassTime& time = timings_->times_[pass_];
  time.cpuMs += std::chrono::duration<double, std::milli>(timings_->now_() - start_).count();
  ++time.count;
  if (!ownsQuery_) return;
  glEndQuery(kTimeElapsed);
  timings_->queryRuns_ = false;
}

}  // namespace qrelief::gl
