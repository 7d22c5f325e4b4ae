// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/guarded.h"

#include <gtest/gtest.h>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace qrelief {
namespace {

using nlohmann::json;

TEST(Guarded, AnAnswerGoesThroughAsItIs) {
  EXPECT_EQ(guarded([] { return std::string("answer"); }), "answer");
}

TEST(Guarded, MemoryThatRunsOutHasACodeOfItsOwn) {
  const json answer = json::parse(guarded([]() -> std::string { throw std::bad_alloc(); }));
  EXPECT_EQ(answer["ok"], false);
  EXPECT_EQ(answer["error"]["code"], "OutOfMemory");
}

TEST(Guarded, AnyOtherExceptionIsAFaultOfTheProgramAndSaysWhatItSaid) {
  const json answer = json::parse(guarded([]() -> std::string { throw std::runtime_error("no such edge"); }));
  EXPECT_EQ(answer["ok"], false);
  EXPECT_EQ(answer["error"]["code"], "Internal");
  EXPECT_EQ(answer["error"]["message"], "no such edge");
}

}  // namespace
}  // namespace qrelief
