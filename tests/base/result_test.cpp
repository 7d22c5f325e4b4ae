// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/result.h"

#include <gtest/gtest.h>

#include "message_codes/pipeline.h"
#include "message_codes/text.h"
#include "messages/sentences.h"

namespace qrelief {
namespace {

Result<int> half(int n) {
  if (n % 2 != 0) return badInput(message<"text-no-utf8">(with::index<"byte">(n)));
  return n / 2;
}

TEST(Result, CarriesTheValueOrTheWholeError) {
  EXPECT_EQ(*half(8), 4);
  const auto failed = half(7);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().kind, ErrorKind::BadInput);
  EXPECT_EQ(failed.error().message, message<"text-no-utf8">(with::index<"byte">(7)));
  EXPECT_EQ(sentence(failed.error().message), "The text is not valid UTF-8 at byte 7");
}

TEST(Status, IsSuccessUnlessFailed) {
  EXPECT_TRUE(Status());
  EXPECT_FALSE(Status(fail(ErrorKind::NoSolution, message<"no-surface">())));
}

}  // namespace
}  // namespace qrelief
