// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/xml_tags.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(XmlTags, FindsTagsAndTheirAttributes) {
  const std::string text = "<?xml version=\"1.0\"?><!-- <a> --><m:a x = '1>2'\n p:y=\"\"><![CDATA[<b>]]><b/></m:a  >";
  XmlTags tags(text);
  const auto a = tags.next();
  ASSERT_TRUE(a);
  EXPECT_TRUE(a->starts("a"));
  EXPECT_FALSE(a->isEmpty);
  EXPECT_EQ(a->attribute("x"), "1>2");
  EXPECT_EQ(a->attribute("p:y"), "");
  EXPECT_FALSE(a->attribute("y"));
  const auto x = a->attributes().at(0);
  EXPECT_EQ(text.substr(x.begin, x.end - x.begin), "x = '1>2'");
  EXPECT_EQ(text.substr(x.valueBegin, x.value.size()), "1>2");
  const auto b = tags.next();
  ASSERT_TRUE(b);
  EXPECT_TRUE(b->starts("b"));
  EXPECT_TRUE(b->isEmpty);
  const auto end = tags.next();
  ASSERT_TRUE(end);
  EXPECT_TRUE(end->ends("a"));
  EXPECT_EQ(end->end, text.size());
  EXPECT_FALSE(tags.next());
}

TEST(XmlTags, SurvivesTextThatIsCutOff) {
  const std::string text = "<a x=\"1\"><!-- c --><b y='2'/></a>";
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string part = text.substr(0, length);
    std::size_t count = 0;
    for (XmlTags tags(part); const auto tag = tags.next(); ++count) EXPECT_LE(tag->end, length);
    EXPECT_LT(count, 3u);
  }
}

TEST(EditedText, ReplacesPiecesInAnyOrder) {
  EXPECT_EQ(edited("abcdef", {{4, 5, "E"}, {0, 2, ""}, {6, 6, "!"}, {6, 6, "?"}}), "cdEf!?");
  EXPECT_EQ(edited("abc", {}), "abc");
}

}  // namespace
}  // namespace qrelief
