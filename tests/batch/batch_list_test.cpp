// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages/sentences.h"

namespace qrelief {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using namespace std::string_literals;

Result<BatchList> read(const std::string& text, const BatchListOptions& options = {}) {
  return readBatchList(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), options);
}

/// Returns the cells of a row, or the code of the refusal.
std::vector<std::string> row(const Result<BatchList>& list, std::size_t index) {
  if (!list) return {list.error().message.code};
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < list->columns().size(); ++i) cells.emplace_back(list->cell(index, i));
  return cells;
}

TEST(BatchList, ReadsTablesWithEachSeparatorAndLineEnd) {
  for (const std::string separator : {",", ";", "\t"})
    for (const std::string end : {"\n", "\r\n", "\r"})
      for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
        const auto list = read(mark + "id" + separator + "text" + end + "7" + separator + "a b" + end + end + "8" +
                               separator + "\"c" + separator + "\"\"d\"\"\"" + end);
        ASSERT_TRUE(list) << list.error().message;
        EXPECT_THAT(list->columns(), ElementsAre("id", "text"));
        ASSERT_EQ(list->size(), 2u);
        EXPECT_THAT(row(list, 0), ElementsAre("7", "a b"));
        EXPECT_THAT(row(list, 1), ElementsAre("8", "c" + separator + "\"d\""));
        EXPECT_EQ(list->line(0), 2u);
        EXPECT_EQ(list->line(1), 4u);
      }
}

TEST(BatchList, EndsBeforePadding) {
  for (const std::string list : {"id,text\n7,a\n", "{\"id\": \"7\", \"text\": \"a\"}\n"})
    for (const std::string& padding : {"\x1A"s, "\0\0\0"s, "\r\n\x1A\r\n"s}) {
      const auto padded = read(list + padding);
      EXPECT_THAT(row(padded, 0), ElementsAre("7", "a")) << list;
      EXPECT_EQ(padded ? padded->size() : 0, 1u);
    }
}

TEST(BatchList, CountsTheLinesOfMultilineTexts) {
  const auto list = read("text\n\"one\ntwo\n\nthree\"\nfour\n");
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_THAT(row(list, 0), ElementsAre("one\ntwo\n\nthree"));
  EXPECT_EQ(list->line(0), 2u);
  EXPECT_EQ(list->line(1), 6u);
}

TEST(BatchList, IgnoresSpacesAroundCellsAndEmptyRows) {
  const auto list = read("id , text\n 7 , a \n,\n , \n8,\n");
  ASSERT_TRUE(list) << list.error().message;
  ASSERT_EQ(list->size(), 2u);
  EXPECT_THAT(row(list, 0), ElementsAre("7", "a"));
  EXPECT_THAT(row(list, 1), ElementsAre("8", ""));
}

/// Returns the warnings about a list, in words.
std::vector<std::string> warningsOf(const std::string& text) {
  const auto list = read(text);
  if (!list) return {list.error().message.code};
  std::vector<std::string> warnings;
  for (const Message& warning : list->warnings()) warnings.push_back(sentence(warning));
  return warnings;
}

TEST(BatchList, WarnsOfLinesOfSpaces) {
  EXPECT_THAT(warningsOf("text\na\n  \nb\n"), ElementsAre("Line 3: There are only spaces, so this is not a row"));
  EXPECT_THAT(warningsOf("text\na\n \t\n\nb\n   "),
              ElementsAre("Line 3 and 1 more: There are only spaces, so this is not a row"));
  EXPECT_THAT(warningsOf("id\ttext\n1\ta\n\t\n"), IsEmpty()) << "an empty row of a spreadsheet";
  EXPECT_THAT(warningsOf("text\n\na\n\"b\n \nc\"\n\n"), IsEmpty()) << "empty lines, and one within a cell";
}

TEST(BatchList, KeepsAQuotedEmptyCellOfOneColumn) {
  const auto list = read("text\na\n\"\"\n\" \"\n\n");
  ASSERT_TRUE(list) << list.error().message.code;
  ASSERT_EQ(list->size(), 3u);
  EXPECT_THAT(row(list, 1), ElementsAre(""));
  EXPECT_THAT(row(list, 2), ElementsAre(" "));
  EXPECT_EQ(list->line(1), 3u);
}

TEST(BatchList, ReadsJsonLinesWithAnyKeysInAnyOrder) {
  const auto list = read(R"({"id": 7, "text": "a"}

{"text": "ü", "quietZone": true, "minWallMm": 1.5, "direction": [0, 0, 1], "id": null})");
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_THAT(list->columns(), ElementsAre("id", "text", "quietZone", "minWallMm", "direction"));
  EXPECT_THAT(row(list, 0), ElementsAre("7", "a", "", "", ""));
  EXPECT_THAT(row(list, 1), ElementsAre("", "ü", "true", "1.5", "0,0,1"));
  EXPECT_EQ(list->line(1), 3u);
}

TEST(BatchList, JsonNumbersKeepTheirCharacters) {
  const auto list = read(R"({"iccid": 89490200001234567890, "gtin": 4006381333931, "x": 1.50, "y": 1e3, "z": -0.0})");
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_THAT(row(list, 0), ElementsAre("89490200001234567890", "4006381333931", "1.50", "1e3", "-0.0"));
}

TEST(BatchList, ReadsAnArrayOfObjects) {
  const auto list = read("[{\"id\":\"A1\",\"text\":\"a ] , \\\" }\"},\n {\"id\":\"A2\",\n  \"text\":[1, 2.50]}\n]\n");
  ASSERT_TRUE(list) << list.error().message.code;
  EXPECT_THAT(list->columns(), ElementsAre("id", "text"));
  EXPECT_THAT(row(list, 0), ElementsAre("A1", "a ] , \" }"));
  EXPECT_THAT(row(list, 1), ElementsAre("A2", "1,2.50"));
  EXPECT_EQ(list->line(0), 1u);
  EXPECT_EQ(list->line(1), 2u);
}

TEST(BatchList, ReadsObjectsHoweverTheyAreSeparated) {
  for (const std::string text :
       {"{\n \"id\": \"A1\",\n \"text\": \"a, }\"\n}\n{\"id\": \"A2\", \"text\": \"b\"}\n",  // over several lines
        "{\"id\": \"A1\", \"text\": \"a, }\"},\r\n\r\n\r\n\r\n{\"id\": \"A2\", \"text\": \"b\"},\r\n",
        "[{\"id\": \"A1\", \"text\": \"a, }\"},\r\r\r\r {\"id\": \"A2\", \"text\": \"b\"},\r]\r",
        "[{\"id\": \"A1\", \"text\": \"a, }\"}\n\n\n\n{\"id\": \"A2\", \"text\": \"b\"}]"}) {
    const auto list = read(text);
    ASSERT_TRUE(list) << text << list.error().message.code;
    ASSERT_EQ(list->size(), 2u) << text;
    EXPECT_THAT(row(list, 0), ElementsAre("A1", "a, }"));
    EXPECT_THAT(row(list, 1), ElementsAre("A2", "b"));
    EXPECT_EQ(list->line(1), 5u) << text;
  }
}

TEST(BatchList, ReadsTheSeparatorThatAFirstLineNames) {
  for (const std::string separator : {",", ";", "\t", "|", ":"}) {
    const auto list = read("\xEF\xBB\xBFsep=" + separator + "\r\nid" + separator + "text\r\n1" + separator + "a b\r\n");
    ASSERT_TRUE(list) << list.error().message.code;
    EXPECT_THAT(list->columns(), ElementsAre("id", "text"));
    EXPECT_THAT(row(list, 0), ElementsAre("1", "a b"));
    EXPECT_EQ(list->line(0), 3u);
  }
  EXPECT_THAT(read("\"sep=|\"\nid|text\n1|a,b,c\n")->columns(), ElementsAre("id", "text")) << "in quotation marks";
  EXPECT_THAT(read("sep=x\na\n")->columns(), ElementsAre("sep=x")) << "a name";
}

TEST(BatchList, IgnoresEmptyColumnsWithoutANameAndBars) {
  const auto trailing = read("id;text;;\r\nA1;a;;\r\nA2;b\r\nA3;c;;;;\r\n");
  ASSERT_TRUE(trailing) << trailing.error().message.code;
  EXPECT_THAT(trailing->columns(), ElementsAre("id", "text"));
  EXPECT_THAT(row(trailing, 1), ElementsAre("A2", "b"));
  EXPECT_THAT(row(trailing, 2), ElementsAre("A3", "c"));
  const auto within = read("id,,text\n1,,a\n");
  ASSERT_TRUE(within) << within.error().message.code;
  EXPECT_THAT(row(within, 0), ElementsAre("1", "a"));
  EXPECT_THAT(row(read("id|text\n1|a,b\n"), 0), ElementsAre("1", "a,b"));
}

TEST(BatchList, FindsColumnsWhateverTheirCapitalsAndUnseenSpaces) {
  const auto list = read("ID,\u00A0Text\u200B,GR\u00D6SSE\n1,a,5\n");
  ASSERT_TRUE(list) << list.error().message.code;
  EXPECT_EQ(list->find("id"), 0u);
  EXPECT_EQ(list->find("text"), 1u);
  EXPECT_EQ(list->find("gr\u00F6\u00DFe"), 2u);
  EXPECT_EQ(list->find("label"), std::nullopt);
}

TEST(BatchList, ReadsUtf16AsExcelWritesUnicodeText) {
  for (const bool isBigEndian : {false, true}) {
    std::string wide;
    for (const char16_t c : std::u16string(u"\uFEFFid\ttext\r\n7\tZ\u00FCrich\r\n")) {
      const char low = static_cast<char>(c & 0xFF), high = static_cast<char>(c >> 8);
      wide += isBigEndian ? std::string{high, low} : std::string{low, high};
    }
    const auto list = read(wide);
    ASSERT_TRUE(list) << list.error().message.code;
    EXPECT_THAT(row(list, 0), ElementsAre("7", "Z\u00FCrich"));
  }
}

TEST(BatchList, ReadsTheAnsiOfExcelAndShowsALineOfIt) {
  const auto list = read("id;text\r\n1;ok\r\n2;M\xFCller \x80 5\r\n");
  ASSERT_TRUE(list) << list.error().message.code;
  EXPECT_THAT(row(list, 1), ElementsAre("2", "M\u00FCller \u20AC 5"));
  ASSERT_EQ(list->warnings().size(), 1u);
  EXPECT_EQ(list->warnings()[0].code, "list-windows-1252");
  EXPECT_EQ(list->warnings()[0].values[0].numbers[0], 3);
  EXPECT_EQ(list->warnings()[0].values[1].text, "2;M\u00FCller \u20AC 5");
  EXPECT_TRUE(read("text\nM\u00FCller\n")->warnings().empty());
}

TEST(BatchList, TakesAFirstRowWithALinkAsARow) {
  const auto links = read("https://example.org/1\nhttps://example.org/2\n");
  ASSERT_TRUE(links) << links.error().message.code;
  EXPECT_THAT(links->columns(), ElementsAre("text"));
  ASSERT_EQ(links->size(), 2u);
  EXPECT_THAT(row(links, 0), ElementsAre("https://example.org/1"));
  EXPECT_EQ(links->line(0), 1u);
  ASSERT_EQ(links->warnings().size(), 1u);
  EXPECT_EQ(links->warnings()[0].code, "list-without-names");

  const auto table = read("7;M8;https://example.org/7;;\n8;M10;;\n");
  ASSERT_TRUE(table) << table.error().message.code;
  EXPECT_THAT(table->columns(), ElementsAre("column1", "column2", "text"));
  EXPECT_THAT(row(table, 1), ElementsAre("8", "M10", ""));
  const auto named = read("link (as http://...),text\na,b\n");
  ASSERT_TRUE(named) << named.error().message.code;
  EXPECT_THAT(named->columns(), ElementsAre("link (as http://...)", "text"));
  EXPECT_TRUE(named->warnings().empty());
}

TEST(BatchList, FollowsWhoSaysWhetherTheFirstRowHasNames) {
  const auto words = read("red\ngreen\n", {.hasNames = false});
  ASSERT_TRUE(words) << words.error().message.code;
  EXPECT_THAT(words->columns(), ElementsAre("text"));
  EXPECT_EQ(words->size(), 2u);
  EXPECT_TRUE(words->warnings().empty());
  const auto pairs = read("1,red\n2,green\n", {.hasNames = false});
  ASSERT_TRUE(pairs) << pairs.error().message.code;
  EXPECT_THAT(pairs->columns(), ElementsAre("column1", "column2"));
  const auto named = read("http://a\nb\n", {.hasNames = true});
  ASSERT_TRUE(named) << named.error().message.code;
  EXPECT_THAT(named->columns(), ElementsAre("http://a"));
}

TEST(BatchList, ReadsBackAHundredThousandRows) {
  std::string text = "id,text\n";
  for (int i = 0; i < 100000; ++i) text += std::to_string(i) + ",https://example.org/" + std::to_string(i) + "\n";
  const auto list = read(text);
  ASSERT_TRUE(list);
  ASSERT_EQ(list->size(), 100000u);
  for (std::size_t i = 0; i < list->size(); i += 997)
    EXPECT_THAT(row(list, i), ElementsAre(std::to_string(i), "https://example.org/" + std::to_string(i)));
}

TEST(BatchList, MakesRowsWithoutCellsFromACount) {
  const BatchList list = countedBatchList(3);
  EXPECT_EQ(list.size(), 3u);
  EXPECT_EQ(list.line(2), 3u);
  EXPECT_TRUE(list.columns().empty());
}

/// Returns `count` column names, separated by commas.
std::string names(std::size_t count) {
  std::string line;
  for (std::size_t i = 0; i < count; ++i) line += (i == 0 ? "c" : ",c") + std::to_string(i);
  return line;
}

/// Returns `count` keys with values, as written in a JSON object.
std::string keys(std::size_t first, std::size_t count) {
  std::string list;
  for (std::size_t i = first; i < first + count; ++i)
    list += (i == first ? "\"c" : ",\"c") + std::to_string(i) + "\":1";
  return list;
}

struct Malformed {
  const char* what;
  std::string text;
  const char* code;
  double line = 0;  ///< line that the refusal names; 0: none
};

TEST(BatchList, RefusesMalformedListsAndReportsThePlace) {
  const std::string cell(kMostCellBytes + 1, 'x');
  const std::vector<Malformed> all = {
      {"nothing", "", "list-empty"},
      {"a mark alone", "\xEF\xBB\xBF", "list-no-rows"},
      {"blank lines", "\n\n  \n", "list-no-rows"},
      {"names alone", "id,text\n", "list-no-rows"},
      {"UTF-16, cut off", "\xFF\xFEi\0d\0\n\0x"s, "list-encoding"},
      {"UTF-16 with half a pair", "\xFF\xFEi\0d\0\n\0\0\xD8"s, "list-encoding"},
      {"a workbook", "PK\x03\x04 and more", "list-spreadsheet"},
      {"an old workbook", "\xD0\xCF\x11\xE0 and more", "list-spreadsheet"},
      {"UTF-8 with a damaged letter", "id,text\n1,\xC3\xBC\n2,caf\xE9\n", "list-no-utf8", 3},
      {"a byte that Windows-1252 lacks", "text\nok\nab\x81\n", "list-no-utf8", 3},
      {"a NUL", "text\na\0b\n"s, "list-holds-nul", 2},
      {"an open quotation", "id,text\n1,\"abc\n2,def\n", "list-quote-open", 2},
      {"a quotation mark within", "id,text\n1,a\"b\n", "list-quote", 2},
      {"text behind a quotation", "id,text\n1,\"a\"b\n", "list-quote", 2},
      {"an unnamed column", "id,,text\n1,2,3\n", "list-column-unnamed", 2},
      {"a cell beyond the names", "id,text,\n1,a,b\n", "list-column-unnamed", 2},
      {"two columns of one name but for capitals", "text,TEXT\n1,2\n", "list-column-twice"},
      {"two columns of one name", "text,text\n1,2\n", "list-column-twice"},
      {"too many cells", "id,text\n1,a,b\n", "list-row-length", 2},
      {"too few cells", "id,text\n1,a\n2\n", "list-row-length", 3},
      {"a formula", "id,text\n1,\"=HYPERLINK(\"\"x\"\")\"\n", "list-cell-formula", 2},
      {"a formula by hand", "id,text\n1,=A1\n", "list-cell-formula", 2},
      {"a long cell", "id,text\n1," + cell + "\n", "list-cell-too-long", 2},
      {"a quotation over many lines", "text\n\"" + std::string(3 * kMostCellBytes, '\n') + "\"\n", "list-cell-too-long",
       2},
      {"a line without end", "text\n" + std::string(3 << 20, 'x'), "list-line-too-long", 2},
      {"no object", "{\"text\": \"a\"}\n[1]\n", "list-no-object", 2},
      {"an object cut off", "{\"text\": \"a\"}\n{\"text\": \"b\n", "list-no-object", 2},
      {"a text after an object", "{\"text\": \"a\"}\nmore\n", "list-no-object", 2},
      {"a bracket too many", "{\"text\": \"a\"}}\n", "list-no-object", 1},
      {"two commas", "[{\"text\": \"a\"},\n,{\"text\": \"b\"}]", "list-no-object", 2},
      {"a web page", "\xEF\xBB\xBF\n<!DOCTYPE html>\n<html>", "list-web-page"},
      {"a table of a web page", "<TABLE><TR><TD>id", "list-web-page"},
      {"a value that is an object", "{\"text\": {\"a\": 1}}\n", "list-value-kind", 1},
      {"a list of texts", "{\"text\": [\"a\"]}\n", "list-value-kind", 1},
      {"a key twice", "{\"text\": \"a\"}\n{\"text\": \"b\", \"id\": 1, \"text\": \"c\"}\n", "list-line", 2},
      {"a hundred thousand brackets", "{\"text\": " + std::string(100'000, '[') + "\n", "list-line", 1},
      {"the same, closed", "{\"a\": " + std::string(100'000, '[') + std::string(100'000, ']') + "}\n", "list-line", 1},
      {"very many columns", names(kMostColumns + 1) + "\n", "list-too-many-columns"},
      {"very many keys", "{" + keys(0, kMostColumns + 1) + "}\n", "list-too-many-columns"},
      {"new keys in every line", "{" + keys(0, 600) + "}\n{" + keys(600, 600) + "}\n", "list-too-many-columns"},
      {"a key without name", "{\"text\": \"a\"}\n{\"\": \"a\"}\n", "list-name-empty", 2},
      {"a number beyond all", "{\"text\": 1e400}\n", "list-line", 1},
      {"an array that does not end", "[{\"text\": \"a\"}\n", "list-array", 2},
      {"an array of texts", "[\"a\",\n\"b\"]", "list-no-object", 1},
      {"an array with text behind it", "[{\"text\": \"a\"}]\nmore", "list-array", 2},
      {"an array with a damaged object", "[{\"text\": \"a\"},\n{\"text\" \"b\"}]", "list-no-object", 2},
      {"an empty array", "[]", "list-no-rows"},
      {"a long value", "{\"text\": \"" + cell + "\"}\n", "list-cell-too-long", 1},
      {"UTF-8 that is none, in an object", "{\"text\": \"\xFF\"}\n", "list-no-utf8", 1},
  };
  for (const auto& [what, text, code, line] : all) {
    const auto list = read(text);
    ASSERT_FALSE(list) << what;
    EXPECT_EQ(list.error().kind, ErrorKind::BadInput) << what;
    EXPECT_EQ(list.error().message.code, code) << what;
    if (line == 0) continue;
    ASSERT_FALSE(list.error().message.values.empty()) << what;
    EXPECT_EQ(list.error().message.values[0].name, "line") << what;
    EXPECT_EQ(list.error().message.values[0].numbers[0], line) << what;
  }
}

TEST(BatchList, AcceptsTheMaximumNumberOfColumns) {
  const auto list = read("{" + keys(0, kMostColumns) + "}\n");
  ASSERT_TRUE(list) << list.error().message.code;
  EXPECT_EQ(list->columns().size(), kMostColumns);
}

TEST(BatchList, NamesANumberThatIsTooLarge) {
  const auto list = read("{\"text\": 1e400}\n");
  ASSERT_FALSE(list);
  EXPECT_EQ(sentence(list.error().message), "Line 1: The number \"1e400\" is too large");
}

TEST(BatchList, NamesADuplicateKeyOfALine) {
  const auto list = read("{\"text\": \"a\", \"text\": \"b\"}\n");
  ASSERT_FALSE(list);
  const Message& cause = list.error().message.values[1].cause.front();
  EXPECT_EQ(cause.code, "json-key-twice");
  EXPECT_EQ(cause.values[0].text, "text");
}

TEST(BatchList, SurvivesEveryTruncationAndFlippedByte) {
  const std::string good = "id;text;minWallMm\r\n7;\"a;\"\"b\"\"\";1.5\r\n8;\"c\nd\";\r\n";
  ASSERT_TRUE(read(good));
  for (std::size_t i = 0; i < good.size(); ++i) {
    (void)read(good.substr(0, i));
    for (const int flip : {1, 2, 4, 8, 16, 32, 64, 128}) {
      std::string broken = good;
      broken[i] = static_cast<char>(broken[i] ^ flip);
      const auto list = read(broken);
      EXPECT_TRUE(!list || list->size() > 0);
    }
  }
}

}  // namespace
}  // namespace qrelief
