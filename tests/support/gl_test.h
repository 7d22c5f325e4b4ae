// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <memory>

#include "native/egl_context.h"

namespace qrelief {

/// Fixture with a current GL context, created once for the whole program. On a machine without one the test fails: a GL
/// test that silently did not run would hide every fault of the renderer.
class GlTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    static const Result<std::unique_ptr<EglContext>> context = EglContext::create();
    ASSERT_TRUE(context.has_value()) << context.error().message;
  }
};

}  // namespace qrelief
