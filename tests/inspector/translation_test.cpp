// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/translation.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

class TranslationTest : public testing::Test {
 protected:
  void SetUp() override { setTranslation({{"depth", "Tiefe"}, {"row {}, column {}", "Zeile {}, Spalte {}"}}); }
  void TearDown() override { setTranslation({}); }
};

TEST_F(TranslationTest, UntranslatedTextsStayEnglish) {
  EXPECT_STREQ(translated("depth"), "Tiefe");
  EXPECT_STREQ(translated("sky"), "sky");
  const char* const both[] = {"sky", "depth"};
  const std::vector<const char*> texts = translated(both);
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_STREQ(texts[0], "sky");
  EXPECT_STREQ(texts[1], "Tiefe");
}

TEST_F(TranslationTest, InsertsValues) {
  EXPECT_EQ(phrase("row {}, column {}", 3, 4), "Zeile 3, Spalte 4");
  EXPECT_EQ(phrase("{} values", 5), "5 values");
}

TEST_F(TranslationTest, WithoutATranslationTextsAreEnglish) {
  setTranslation({});
  EXPECT_STREQ(translated("depth"), "depth");
}

}  // namespace
}  // namespace qrelief
