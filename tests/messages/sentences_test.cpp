// SPDX-License-Identifier: GPL-3.0-or-later
// Uses the same cases as the page's renderer (web/i18n/messages.test.js), so that the two agree.
#include "messages/sentences.h"

#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/message_json.h"
#include "math/vec.h"
#include "support/paths.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

Json cases() {
  std::ifstream stream(sourceFolder() / "tests/messages/cases.json");
  return Json::parse(stream);
}

Message messageOf(const Json& json);

MessageValue valueOf(const char* name, const Json& json) {
  using Kind = MessageValue::Kind;
  const std::string kind = json.begin().key();
  const Json& value = json.begin().value();
  if (kind == "cause") return with::caused(name, messageOf(value));
  if (kind == "choice")
    return with::chosen(name, value.at("key").get<std::string>(), value.at("value").get<std::string>());
  if (value.is_string())
    return with::textual(name,
                         kind == "quoted" ? Kind::Quoted
                         : kind == "term" ? Kind::Term
                                          : Kind::Setting,
                         value.get<std::string>());
  static const std::map<std::string, Kind> kNumeric = {{"count", Kind::Count},       {"index", Kind::Index},
                                                       {"number", Kind::Number},     {"lengthMm", Kind::LengthMm},
                                                       {"angleDeg", Kind::AngleDeg}, {"fraction", Kind::Fraction}};
  if (const auto numeric = kNumeric.find(kind); numeric != kNumeric.end())
    return with::numeric(name, numeric->second, value.get<double>());
  const auto list = value.get<std::vector<double>>();
  return {name, kind == "place" ? Kind::Place : kind == "extentMm" ? Kind::ExtentMm : Kind::Indices, list, {}};
}

Message messageOf(const Json& json) {
  Message message{json.at("code").get<std::string>(), {}};
  for (const auto& [name, value] : json.at("values").items()) message.values.push_back(valueOf(name.c_str(), value));
  return message;
}

/// Replaces typographic quotes by plain ones; the page uses the quotes of its language.
std::string withPlainQuotes(std::string text) {
  for (const char* quote : {"“", "”"})
    for (std::size_t at; (at = text.find(quote)) != std::string::npos;)
      text.replace(at, std::string(quote).size(), "\"");
  return text;
}

TEST(Sentences, MatchTheSharedCases) {
  const Json shared = cases();
  ASSERT_GT(shared.at("cases").size(), 20U);
  for (const Json& one : shared.at("cases")) {
    const Message message = messageOf(one.at("message"));
    EXPECT_EQ(Json(jsonOf(message)), one.at("message"));
    EXPECT_EQ(sentence(message, shared.at("words").at("en")), withPlainQuotes(one.at("en").get<std::string>()));
    if (!one.contains("hint")) continue;
    EXPECT_EQ(hint(message, shared.at("words").at("en")), withPlainQuotes(one.at("hint").get<std::string>()))
        << message;
  }
}

TEST(Sentences, ProgramsWriteCountsAndLengthsLikeThem) {
  EXPECT_EQ(counted(0, "row", "rows"), "0 rows");
  EXPECT_EQ(counted(1, "row", "rows"), "1 row");
  EXPECT_EQ(counted(2, "row", "rows"), "2 rows");
  EXPECT_EQ(lengthInWords(0.2437), "0.244 mm");
  EXPECT_EQ(lengthInWords(25.437, 4), "25.44 mm");
  EXPECT_EQ(lengthInWords(123.4), "123 mm");
  EXPECT_EQ(lengthInWords(2.73e-16), "0 mm");
  EXPECT_EQ(extentInWords(12345.6, 40, 2e-9, 4), "12346 × 40 × 0 mm");
}

TEST(Sentences, NameFlagsAndPreferTheCommandsWords) {
  const Json words =
      Json::parse(R"({"thin": {"says": "Raise {@minWallMm}", "hint": "Less", "command": {"hint": "Else"}},
      "busy": {"says": "Press Engrave", "command": {"says": "Run it again"}}})");
  EXPECT_EQ(sentence(Message("thin", {}), words), "Raise --min-wall");
  EXPECT_EQ(hint(Message("thin", {}), words), "Else");
  EXPECT_EQ(sentence(Message("busy", {}), words), "Run it again");
}

}  // namespace
}  // namespace qrelief
