// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/shard.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(Shard, AssignsEveryItemToExactlyOneShard) {
  for (const std::size_t count : {1u, 2u, 7u})
    for (std::size_t item = 0; item < 20; ++item) {
      int owners = 0;
      for (std::size_t index = 0; index < count; ++index) owners += Shard{index, count}.has(item);
      EXPECT_EQ(owners, 1);
    }
}

TEST(Shard, ReadsIndexAndCount) {
  const auto shard = Shard::parse("2/8");
  ASSERT_TRUE(shard);
  EXPECT_EQ(shard->index, 2u);
  EXPECT_EQ(shard->count, 8u);
  EXPECT_EQ(shard->name(), "2-of-8");
}

TEST(Shard, RefusesAnyOtherText) {
  for (const char* text : {"", "/", "1", "1/", "/2", "8/8", "9/8", "-1/8", "1/8 ", " 1/8", "1/8/9", "a/b", "0/0",
                           "99999999999999999999/8"})
    EXPECT_FALSE(Shard::parse(text)) << text;
}

}  // namespace
}  // namespace qrelief
