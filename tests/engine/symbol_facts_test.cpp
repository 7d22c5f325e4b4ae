// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/symbol_facts.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "label/label_layout.h"
#include "qr/symbol.h"
#include "settings/engrave_request.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

EngraveRequest requestFor(const std::string& text) {
  EngraveRequest request;
  request.code.text = text;
  request.code.symbol.raiseErrorCorrection = true;
  return request;
}

Json facts(const EngraveRequest& request) { return Json::parse(describeSymbol(request))["symbol"]; }

TEST(SymbolFacts, DescribeTheEngravedSymbol) {
  const EngraveRequest request = requestFor("https://example.org/a/longer/text/x");
  const auto symbol = encodeSymbol(request.code.text, request.code.symbol);
  ASSERT_TRUE(symbol.has_value());
  const Json described = facts(request);
  EXPECT_EQ(described["version"], symbol->version);
  EXPECT_EQ(described["ecc"], errorCorrectionName(symbol->errorCorrection));
  EXPECT_EQ(described["mask"], symbol->mask);
  EXPECT_EQ(described["size"], symbol->size);
  EXPECT_EQ(described["bytes"], 35);
  ASSERT_EQ(described["rows"].size(), static_cast<std::size_t>(symbol->size));
  for (int row = 0; row < symbol->size; ++row) {
    const auto text = described["rows"][static_cast<std::size_t>(row)].get<std::string>();
    ASSERT_EQ(text.size(), static_cast<std::size_t>(symbol->size));
    for (int column = 0; column < symbol->size; ++column)
      EXPECT_EQ(text[static_cast<std::size_t>(column)] == '1', symbol->isDark(row, column));
  }
}

TEST(SymbolFacts, TheRoomIsTheRestOfTheVersionsCapacity) {
  // Texts of digits, capitals and bytes; versions on both sides of 9|10, where length fields grow; the last version.
  for (const std::string& text :
       {std::string("a"), std::string("12345678901234567890"), std::string("HTTPS://QR.ORG/x"),
        std::string("Gr\u00FC\u00DFe"), std::string(150, 'b'), std::string(190, 'C'), std::string(1200, 'd')}) {
    const EngraveRequest request = requestFor(text);
    const Json described = facts(request);
    const int version = described["version"], room = described["room"];
    const auto versionWith = [&](int more) {
      const auto symbol = encodeSymbol(text + std::string(static_cast<std::size_t>(more), 'a'), request.code.symbol);
      return symbol ? symbol->version : 99;
    };
    EXPECT_EQ(versionWith(room), version) << text;
    EXPECT_GT(versionWith(room + 1), version) << text;
  }
}

TEST(SymbolFacts, TheRoomMatchesTheTableOfTheStandard) {
  // 14 bytes in 1-M, 26 in 2-M, 17 in 1-L, 2331 in 40-M [ISO/IEC 18004, table 7].
  EXPECT_EQ(facts(requestFor("abcde"))["room"], 14 - 5);
  EXPECT_EQ(facts(requestFor(std::string(15, 'a')))["room"], 26 - 15);
  EXPECT_EQ(facts(requestFor(std::string(2331, 'a')))["room"], 0);
  EngraveRequest weak = requestFor("abcde");
  weak.code.symbol.errorCorrection = ErrorCorrection::L;
  weak.code.symbol.raiseErrorCorrection = false;
  EXPECT_EQ(facts(weak)["room"], 17 - 5);
}

TEST(SymbolFacts, TheSmallestModuleFollowsFromPatternAndNozzle) {
  const std::pair<ModulePattern, double> published[] = {{ModulePattern::Square, 0.9},
                                                        {ModulePattern::Diamond, 0.9},
                                                        {ModulePattern::ThickPlus, 0.6},
                                                        {ModulePattern::None, 1.2},
                                                        // pockets a fifth of the module wide need at least 0.9 nozzle
                                                        // widths
                                                        {ModulePattern::ThinPlus, 1.8}};
  for (const auto& [pattern, moduleMm] : published)
    for (const double factor : {1.0, 2.0}) {
      EngraveRequest request = requestFor("https://example.org/");
      request.code.modulePattern = pattern;
      request.print.printer.nozzleMm = 0.4 * factor;
      EXPECT_NEAR(facts(request)["leastModuleMm"], moduleMm * factor, 1e-9) << modulePatternName(pattern);
    }
}

TEST(SymbolFacts, OmitsTheSmallestModuleForAnInvalidNozzle) {
  for (const double nozzle : {0.0, -1.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
    EngraveRequest request = requestFor("x");
    request.print.printer.nozzleMm = nozzle;
    EXPECT_TRUE(facts(request)["leastModuleMm"].is_null()) << nozzle;
  }
}

TEST(SymbolFacts, OfATextAloneAreItsLetters) {
  EngraveRequest request = requestFor("HI");
  request.code.content = Content::Text;
  const Json letters = facts(request)["letters"];
  const auto layout = layOutLabel(request.code.lettering(), letters["size"]);
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(letters["capital"], layout->capitalModules);
  EXPECT_NEAR(letters["leastMm"].get<double>() / letters["size"].get<double>() * layout->thinnestStrokeModules, 0.45,
              1e-9);
  const auto path = letters["path"].get<std::string>();
  EXPECT_EQ(std::count(path.begin(), path.end(), 'Z'), 2);  // an H and an I
  // The H begins at the square's left edge.
  EXPECT_TRUE(path.starts_with("M0.00 ") || path.find("L0.00 ") != std::string::npos) << path;
}

TEST(SymbolFacts, RefusesATextThatFitsNoSymbol) {
  const Json tooLong = Json::parse(describeSymbol(requestFor(std::string(3000, 'a'))));
  EXPECT_EQ(tooLong["ok"], false);
  EXPECT_EQ(tooLong["error"]["kind"], "BadInput");
  const Json empty = Json::parse(describeSymbol(requestFor("")));
  EXPECT_EQ(empty["ok"], false);
  EXPECT_EQ(empty["error"]["kind"], "BadInput");
}

}  // namespace
}  // namespace qrelief
