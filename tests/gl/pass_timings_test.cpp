// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/pass_timings.h"

#include <gmock/gmock.h>
#include <utility>

#include "gl/objects.h"
#include "support/gl_test.h"

namespace qrelief {
namespace {

using namespace std::chrono_literals;
using testing::Field;

class PassTimingsTest : public GlTest {};

/// Gives the graphics processor some work.
void clearATexture() {
  const gl::Texture texture(512, 512, gl::Format::RGBA8);
  const gl::Texture* const colours[] = {&texture};
  const auto target = gl::Framebuffer::create(colours, false);
  ASSERT_TRUE(target.has_value());
  target->bind();
  glClear(GL_COLOR_BUFFER_BIT);
}

/// A clock that stands still until a test sets it.
Clock::time_point testTime;
Clock::time_point readTestTime() { return testTime; }

TEST_F(PassTimingsTest, AddsUpPassesByNameInOrderOfFirstUse) {
  gl::PassTimings timings(false, readTestTime);
  timings.listen();
  const std::pair<const char*, std::chrono::milliseconds> passes[] = {
      {"second letter", 2ms}, {"a", 3ms}, {"second letter", 5ms}};
  for (const auto& [name, duration] : passes) {
    const gl::TimedPass timed(name);
    testTime += duration;
  }
  timings.stopListening();
  ASSERT_THAT(timings.times(),
              testing::ElementsAre(Field(&gl::PassTime::name, "second letter"), Field(&gl::PassTime::name, "a")));
  EXPECT_EQ(timings.times()[0].count, 2);
  EXPECT_EQ(timings.times()[1].count, 1);
  EXPECT_EQ(timings.times()[0].cpuMs, 7);
  EXPECT_EQ(timings.times()[1].cpuMs, 3);
  EXPECT_FALSE(timings.hasGpuTimes());
  EXPECT_EQ(timings.times()[0].gpuCount, 0);
}

TEST_F(PassTimingsTest, CountsTheTimeOfANestedPassInBoth) {
  gl::PassTimings timings(false, readTestTime);
  timings.listen();
  {
    const gl::TimedPass outer("outer");
    testTime += 1ms;
    const gl::TimedPass inner("inner");
    testTime += 4ms;
  }
  timings.stopListening();
  ASSERT_THAT(timings.times(),
              testing::ElementsAre(Field(&gl::PassTime::name, "outer"), Field(&gl::PassTime::name, "inner")));
  EXPECT_EQ(timings.times()[0].cpuMs, 5);
  EXPECT_EQ(timings.times()[1].cpuMs, 4);
}

TEST_F(PassTimingsTest, IgnoresPassesBeforeAndAfterListening) {
  gl::PassTimings timings(false);
  { const gl::TimedPass before("before"); }
  timings.listen();
  timings.stopListening();
  { const gl::TimedPass after("after"); }
  EXPECT_TRUE(timings.times().empty());
}

TEST_F(PassTimingsTest, WritesNothingToADestroyedListener) {
  {
    gl::PassTimings gone(false);
    gone.listen();
  }
  { const gl::TimedPass timed("nobody hears this"); }  // must not write to freed memory
  gl::PassTimings next(false);
  next.listen();
  { const gl::TimedPass timed("heard by the next"); }
  ASSERT_THAT(next.times(), testing::ElementsAre(Field(&gl::PassTime::name, "heard by the next")));
}

TEST_F(PassTimingsTest, MeasuresGpuTimeOfOuterPassesOnlyIfTimerQueriesExist) {
  const bool known = gl::hasTimerQueries();
  while (glGetError() != GL_NO_ERROR) {  // clears errors of earlier tests
  }
  gl::PassTimings timings(known);
  timings.listen();
  {
    const gl::TimedPass outer("outer");
    clearATexture();
    const gl::TimedPass inner("inner");
    clearATexture();
  }
  timings.stopListening();
  glFinish();
  timings.collect();
  ASSERT_EQ(timings.times().size(), 2u);
  EXPECT_EQ(timings.hasGpuTimes(), known);
  EXPECT_EQ(timings.times()[0].count, 1);
  EXPECT_EQ(timings.times()[0].gpuCount, known ? 1 : 0);
  EXPECT_EQ(timings.times()[1].count, 1);
  EXPECT_EQ(timings.times()[1].gpuCount, 0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace qrelief
