// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/answers.h"

#include <gtest/gtest.h>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace qrelief {
namespace {

using nlohmann::json;

TEST(Guarded, PassesAnAnswerOnUnchanged) {
  EXPECT_EQ(guarded([] { return std::string("answer"); }), "answer");
}

TEST(Guarded, ReportsExhaustedMemoryWithItsOwnCode) {
  const json answer = json::parse(guarded([]() -> std::string { throw std::bad_alloc(); }));
  EXPECT_EQ(answer["ok"], false);
  EXPECT_EQ(answer["error"]["code"], "out-of-memory");
}

TEST(Guarded, ReportsAnyOtherExceptionAsABugWithItsText) {
  const json answer = json::parse(guarded([]() -> std::string { throw std::runtime_error("no such edge"); }));
  EXPECT_EQ(answer["ok"], false);
  EXPECT_EQ(answer["error"]["code"], "internal-fault");
  EXPECT_EQ(answer["error"]["values"]["detail"]["term"], "no such edge");
}

}  // namespace
}  // namespace qrelief
