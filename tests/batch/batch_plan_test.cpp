// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages/sentences.h"

namespace qrelief {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

BatchPlan planOf(const std::string& list, const std::string& text = "", const std::string& name = "") {
  BatchRequest request;
  request.all = defaultRequest();
  request.all.code.text = text;
  request.name = name;
  auto rows = readBatchList(std::span(reinterpret_cast<const std::uint8_t*>(list.data()), list.size()));
  return BatchPlan::make(rows ? std::move(*rows) : BatchList(), request);
}

/// Returns the codes of the problems. A problem in a line is its line number and code: "3 text-twice".
std::vector<std::string> problemsOf(const BatchPlan& plan) {
  std::vector<std::string> codes;
  for (const Message& problem : plan.problems()) {
    const bool ofLine = problem.code == "list-line";
    codes.push_back(ofLine ? std::to_string(static_cast<int>(problem.values[0].numbers[0])) + " " +
                                 problem.values[1].cause.front().code
                           : problem.code);
  }
  return codes;
}

TEST(BatchPlan, TakesIdTextAndFileFromTheirColumns) {
  const BatchPlan plan = planOf("file,id,text\na.stl,7,hello\nb.3mf,8,world\n");
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  ASSERT_EQ(plan.size(), 2u);
  const BatchRow row = plan.row(1);
  EXPECT_EQ(row.number, 2u);
  EXPECT_EQ(row.line, 3u);
  EXPECT_EQ(row.id, "8");
  EXPECT_EQ(row.file, "b.3mf");
  EXPECT_EQ(row.request.code.text, "world");
}

TEST(BatchPlan, FillsTemplatesFromColumnsAndNumbers) {
  const BatchPlan plan = planOf("id,lot\nx,A\ny,B\n", "https://example.org/{lot}/{n:03}", "{lot}-{id}.ply");
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_EQ(plan.row(1).request.code.text, "https://example.org/B/002");
  EXPECT_EQ(plan.row(1).file, "B-y.ply");
  EXPECT_THAT(plan.unusedColumns(), IsEmpty());
}

TEST(BatchPlan, FillsTheLabelFromItsTemplateOrItsColumn) {
  BatchRequest request;
  request.all = defaultRequest();
  request.all.code.text = "https://example.org/{id}";
  request.all.code.label.text = "No. {n:04} {id}";
  const BatchPlan plan = BatchPlan::make(countedBatchList(12), request);
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_EQ(plan.row(11).request.code.label.text, "No. 0012 12");
  const BatchPlan named = planOf("id,text,label\n7,hello,Seven\n8,world,\n");
  ASSERT_THAT(problemsOf(named), IsEmpty());
  EXPECT_EQ(named.row(0).request.code.label.text, "Seven");
  EXPECT_EQ(named.row(1).request.code.label.text, "");
}

TEST(BatchPlan, ReportsTheLineOfALabelThatTheFontLacks) {
  EXPECT_THAT(problemsOf(planOf("id,text,label\n7,hello,Seven\n8,world,漢\n")),
              ElementsAre("3 label-lacks-characters"));
}

TEST(BatchPlan, NumbersTheRowsWithoutAList) {
  BatchRequest request;
  request.all.code.text = "part {n:04}";
  request.firstNumber = 500;
  const BatchPlan plan = BatchPlan::make(countedBatchList(3), request);
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_EQ(plan.row(2).request.code.text, "part 0502");
  EXPECT_EQ(plan.row(2).file, "502.stl");
}

TEST(BatchPlan, AppliesColumnsOfSettings) {
  const BatchPlan plan = planOf("id,text,minWallMm,preset\n1,a,1.5,robust\n2,b,,\n");
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_EQ(plan.row(0).request.depth.minWallMm, 1.5);
  EXPECT_EQ(plan.row(0).request.depth.preset, Preset::Robust);
  EXPECT_EQ(plan.row(1).request.depth.minWallMm, defaultRequest().depth.minWallMm);
  EXPECT_EQ(plan.row(1).request.depth.preset, defaultRequest().depth.preset);
}

TEST(BatchPlan, CodesInColourNeedFilesThatHoldColours) {
  EXPECT_THAT(problemsOf(planOf("text,mark,file\na,shadow,a.stl\nb,paint,b.stl\nc,inlay,c.3mf\n")),
              ElementsAre("3 colour-has-no-file"));
  EXPECT_THAT(problemsOf(planOf("text,mark,file\na,inlay,a.ply\nb,inlay,b.stl\nc,paint,c.obj\n")),
              ElementsAre("2 colour-has-no-file"));
  BatchRequest request;
  request.all.code.text = "part {n}";
  request.all.marking.mark = Mark::Inlay;
  const BatchPlan plan = BatchPlan::make(countedBatchList(1), request);
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_EQ(plan.row(0).file, "1.3mf");
  const BatchPlan mixed = planOf("id,text,mark\na,x,paint\nb,y,shadow\nc,z,auto\n");
  ASSERT_THAT(problemsOf(mixed), IsEmpty());
  for (const auto& [row, file] : {std::pair(0, "a.3mf"), {1, "b.stl"}, {2, "c.3mf"}})
    EXPECT_EQ(mixed.row(static_cast<std::size_t>(row)).file, file);
}

TEST(BatchPlan, RefusesASecondFileWithTheNameOfAnotherRowsFile) {
  EXPECT_THAT(problemsOf(planOf("id,text,file,mark\n1,a,x.stl,inlay\n2,b,X-2.stl,shadow\n")),
              ElementsAre("3 name-twice"));
  EXPECT_THAT(problemsOf(planOf("id,text,file,mark\n1,a,x-2.stl,\n2,b,x.stl,\n")), IsEmpty());
  const BatchPlan plan = planOf("id,text,file,mark\n1,a,x.obj,inlay\n2,b,y.3mf,inlay\n");
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_THAT(plan.row(0).files(), ElementsAre("x.obj", "x.mtl"));
  EXPECT_THAT(plan.row(1).files(), ElementsAre("y.3mf"));
}

TEST(BatchPlan, UsesTheVersionOfTheLongestTextForAllRows) {
  const std::string longest(60, 'x');
  const BatchPlan plan = planOf("id,text,version\n1,a,\n2," + longest + ",\n3,c,7\n");
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  const auto symbol = encodeSymbol(longest);
  ASSERT_TRUE(symbol);
  EXPECT_EQ(plan.row(0).request.code.symbol.version, symbol->version);
  EXPECT_EQ(plan.row(1).request.code.symbol.version, symbol->version);
  EXPECT_EQ(plan.row(2).request.code.symbol.version, 7);
}

TEST(BatchPlan, ReportsUnusedColumns) {
  EXPECT_THAT(planOf("id,text,presett,note\n1,a,robust,x\n").unusedColumns(), ElementsAre("presett", "note"));
}

TEST(BatchPlan, RefusesTemplatesThatTheColumnsCannotFill) {
  EXPECT_THAT(problemsOf(planOf("id,name\n1,a\n")), ElementsAre("list-without-text"));
  EXPECT_THAT(problemsOf(planOf("id,text\n1,a\n", "{lot}")), ElementsAre("list-without-column"));
  EXPECT_THAT(problemsOf(planOf("id,text\n1,a\n", "", "{lot}.stl")), ElementsAre("list-without-column"));
  EXPECT_THAT(problemsOf(planOf("id,text\n1,a\n", "{text")), ElementsAre("template-brace"));
  BatchRequest request;
  request.all.code.text = "{id} {lot}";
  EXPECT_THAT(problemsOf(BatchPlan::make(countedBatchList(2), request)), ElementsAre("template-without-list"));
}

TEST(BatchPlan, RowsOfTextAloneMayRepeatATextAndNeedNoVersion) {
  const BatchPlan plan = planOf("id,text,content\n1,Anna,text\n2,Anna,text\n3,https://example.org,code\n");
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_TRUE(plan.row(1).request.code.isText());
  EXPECT_FALSE(plan.row(2).request.code.isText());
  EXPECT_EQ(plan.row(2).request.code.symbol.version, 2);
  EXPECT_THAT(problemsOf(planOf("id,text,content\n1,Anna,text\n2,\u6f22,text\n")),
              ElementsAre("3 label-lacks-characters"));
  EXPECT_THAT(problemsOf(planOf("id,text,content,label\n1,Anna,text,No. 7\n")), ElementsAre("2 text-alone-has-label"));
}

TEST(BatchPlan, RefusesDuplicateTextsNamesAndIds) {
  EXPECT_THAT(problemsOf(planOf("id,text\n1,a\n2,b\n3,a\n")), ElementsAre("4 text-twice"));
  EXPECT_THAT(problemsOf(planOf("id,text,file\n1,a,x.stl\n2,b,X.STL\n")), ElementsAre("3 name-twice"));
  EXPECT_THAT(problemsOf(planOf("id,text,file\n1,a,x.stl\n1,b,y.stl\n")), ElementsAre("3 id-twice"));
  EXPECT_THAT(problemsOf(planOf("id,text\n1,a\n1,b\n")), ElementsAre("3 id-twice")) << "1.stl twice follows from it";
  EXPECT_THAT(problemsOf(planOf("id,text\n1,a\n2,b\n", "the same")), ElementsAre("3 text-twice"));
}

TEST(BatchPlan, RefusesNamesThatAreOneFileOnMacOsAndWindows) {
  EXPECT_THAT(problemsOf(planOf("id,text\n\u00E9,a\ne\u0301,b\n")), ElementsAre("3 name-twice"));
  EXPECT_THAT(problemsOf(planOf("id,text\n\u0416,a\n\u0436,b\n")), ElementsAre("3 name-twice"));
  EXPECT_THAT(problemsOf(planOf("id,text\nSTRASSE,a\nstra\u00DFe,b\n")), ElementsAre("3 name-twice"));
  EXPECT_THAT(problemsOf(planOf("id,text\ne,a\n\u00E9,b\n")), IsEmpty());
}

TEST(BatchPlan, FindsColumnsAndSettingsWhateverTheirCapitals) {
  const BatchPlan plan = planOf("ID,Text,MinWallMM,Model\n7,a,1.5,b.stl\n");
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_EQ(plan.row(0).id, "7");
  EXPECT_EQ(plan.row(0).model, "b.stl");
  EXPECT_EQ(plan.row(0).request.depth.minWallMm, 1.5);
  EXPECT_THAT(plan.unusedColumns(), IsEmpty());
  EXPECT_EQ(planOf("LOT\n7\n", "lot {lot}").row(0).request.code.text, "lot 7");
}

TEST(BatchPlan, KnowsTheModelsThatRowsName) {
  const BatchPlan some = planOf("text,model\na,x.stl\nb,\nc,x.stl\nd,y.stl\n");
  EXPECT_THAT(some.models(), testing::UnorderedElementsAre(testing::Pair("x.stl", 0u), testing::Pair("y.stl", 3u)));
  EXPECT_TRUE(some.needsModel());
  EXPECT_FALSE(planOf("text,model\na,x.stl\n").needsModel());
  EXPECT_TRUE(planOf("text\na\n").needsModel());
}

TEST(BatchPlan, TakesTheTextsFromAColumnOfLinks) {
  EXPECT_EQ(planOf("id,URL\n1,https://example.org\n").row(0).request.code.text, "https://example.org");
  EXPECT_EQ(planOf("id,link\n1,https://example.org\n").row(0).request.code.text, "https://example.org");
  const BatchPlan both = planOf("url,text\nhttps://example.org,a\n");
  EXPECT_EQ(both.row(0).request.code.text, "a");
  EXPECT_THAT(both.unusedColumns(), ElementsAre("url"));
}

TEST(BatchPlan, TakesIdsFromTheColumnThatTheRequestNames) {
  const std::string list = "Part,text\nM8,a\nM10,b\n";
  auto rows = readBatchList(std::span(reinterpret_cast<const std::uint8_t*>(list.data()), list.size()));
  BatchRequest request;
  request.all = defaultRequest();
  request.idColumn = "Part";
  const BatchPlan plan = BatchPlan::make(std::move(*rows), request);
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_EQ(plan.row(1).id, "M10");
  EXPECT_EQ(plan.row(1).file, "M10.stl");
  EXPECT_THAT(plan.unusedColumns(), IsEmpty());
}

TEST(BatchPlan, SaysWhatTheReaderHadToGuess) {
  const BatchPlan plan = planOf("https://example.org/caf\xE9\nhttps://example.org/2\n");
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  EXPECT_EQ(plan.row(1).request.code.text, "https://example.org/2");
  std::vector<std::string> codes;
  for (const Message& warning : plan.warnings()) codes.push_back(warning.code);
  EXPECT_THAT(codes, testing::IsSupersetOf({"list-without-names", "list-windows-1252"}));
}

/// Returns the codes of the warnings about a column with these cells, used in the text.
std::vector<std::string> warningsOf(const std::vector<std::string>& cells) {
  std::string list = "v;unused\n";
  for (const std::string& cell : cells) list += cell + ";" + "9,52E+12\n";
  const BatchPlan plan = planOf(list, "{n} {v}");
  EXPECT_THAT(problemsOf(plan), IsEmpty());
  std::vector<std::string> codes;
  for (const Message& warning : plan.warnings()) codes.push_back(warning.code);
  return codes;
}

TEST(BatchPlan, WarnsOfValuesThatASpreadsheetHasChanged) {
  EXPECT_THAT(warningsOf({"9,52112E+12", "9,52113E+12"}), ElementsAre("cell-scientific"));
  EXPECT_THAT(warningsOf({"1.10E+03"}), ElementsAre("cell-scientific"));
  EXPECT_THAT(warningsOf({"5E-05"}), ElementsAre("cell-scientific"));
  EXPECT_THAT(warningsOf({"89490200001234500000"}), ElementsAre("cell-rounded"));
  EXPECT_THAT(warningsOf({"1001.0"}), ElementsAre("cell-decimal"));
  for (const char* date : {"02-Mar", "2. Mrz", "2-M\u00E4r", "Sep-07", "1-Dec"})
    EXPECT_THAT(warningsOf({date}), ElementsAre("cell-date")) << date;
  EXPECT_THAT(warningsOf({"12345", "1234", "54321", "67890"}), ElementsAre("cell-zeros-lost"));
  const BatchPlan plan = planOf("id;gtin\n1;9,52112E+12\n", "{gtin}");
  ASSERT_EQ(plan.warnings().size(), 1u);
  EXPECT_EQ(sentence(plan.warnings()[0]),
            "Line 2: 9,52112E+12 in the column \"gtin\" is a number that a spreadsheet has shortened");
}

TEST(BatchPlan, DoesNotWarnOfOrdinaryValues) {
  for (const char* value : {"12E5", "E+12", "4006381333931", "8949020000123456789", "1.5", "2026-03-01", "MARCH1",
                            "may-be", "3-4", "00123", "1000000000000001"})
    EXPECT_THAT(warningsOf({value}), IsEmpty()) << value;
  EXPECT_THAT(warningsOf({"99998", "99999", "100000", "100001", "100002", "100003"}), IsEmpty()) << "a count";
  EXPECT_THAT(warningsOf({"1", "22", "333", "22", "1"}), IsEmpty()) << "short numbers";
}

TEST(BatchPlan, WarnsOnceOfEachKindOfFaultyLink) {
  const BatchPlan plan = planOf(
      "id,text\n1,https://example.com/1\u00A0\n2,https://example.com/2\u200B\n3,https://example.com/3\u00A0\n"
      "4,\u201Chttps://example.com/4\u201D\n5,example.com/5\n6,https://example.com/6\n");
  ASSERT_THAT(problemsOf(plan), IsEmpty());
  std::vector<std::string> warnings;
  for (const Message& warning : plan.warnings()) warnings.push_back(sentence(warning));
  EXPECT_THAT(warnings, ElementsAre("Line 2 and 1 more: There are spaces before or after the link",
                                    "Line 3: The link has characters that nobody sees, such as zero-width spaces",
                                    "Line 5: The link is in quotation marks or brackets, which become part of it",
                                    "Line 6: Many phones open this as a link only if it begins with https://"));
  EXPECT_EQ(plan.row(0).request.code.text, "https://example.com/1\u00A0") << "the text stays";
}

TEST(BatchPlan, WarnsOfEmptyCellsThatATextOrLabelUses) {
  const auto warnings = [](const std::string& list, const std::string& text, const std::string& label = "") {
    BatchRequest request;
    request.all = defaultRequest();
    request.all.code.text = text;
    request.all.code.label.text = label;
    auto rows = readBatchList(std::span(reinterpret_cast<const std::uint8_t*>(list.data()), list.size()));
    const BatchPlan plan = BatchPlan::make(std::move(*rows), request);
    EXPECT_THAT(problemsOf(plan), IsEmpty());
    std::vector<std::string> sentences;
    for (const Message& warning : plan.warnings()) sentences.push_back(sentence(warning));
    return sentences;
  };
  const std::string table = "id,Lot,serial\n1,a,\n2,,\n3,b,7\n";
  EXPECT_THAT(warnings(table, "{lot} {serial} {id}"),
              ElementsAre("Line 2 and 1 more: The column \"serial\" is empty there, but the text or label uses it",
                          "Line 3: The column \"Lot\" is empty there, but the text or label uses it"));
  EXPECT_THAT(warnings(table, "{id}"), IsEmpty()) << "unused";
  EXPECT_THAT(warnings(table, "{id}", "{lot}"), IsEmpty()) << "a row without a label";
  EXPECT_THAT(warnings(table, "{id}", "Lot {lot}"), testing::SizeIs(1));
  EXPECT_THAT(warnings("{\"id\": 1, \"lot\": null}\n{\"id\": 2}\n", "{lot} {id}"),
              ElementsAre("Line 1 and 1 more: The column \"lot\" is empty there, but the text or label uses it"));
}

TEST(BatchPlan, RefusesATextOfNullAndOneThatNobodySees) {
  EXPECT_THAT(problemsOf(planOf("{\"text\": null}\n{\"text\": \"b\"}\n{\"lot\": 7}\n")),
              ElementsAre("1 row-without-text", "3 row-without-text"));
  EXPECT_THAT(problemsOf(planOf("id,text\n1,\u200B\n2,\"  \"\n3,\u00A0\n4,a\n")),
              ElementsAre("2 text-unseen", "3 text-unseen", "4 text-unseen"));
  EXPECT_THAT(problemsOf(planOf("{\"text\": \"a\\u0000b\"}\n")), ElementsAre("1 text-holds-nul"));
}

TEST(BatchPlan, RefusesTheErrorsOfASpreadsheet) {
  EXPECT_THAT(problemsOf(planOf("id,text\n1,#REF!\n2,b\n")), ElementsAre("cell-error"));
  EXPECT_THAT(problemsOf(planOf("id,text\n1,########\n")), ElementsAre("cell-error"));
  EXPECT_THAT(problemsOf(planOf("id,text,note\n1,a,#REF!\n")), IsEmpty());
}

TEST(BatchPlan, RefusesRowsThatCannotBeCarved) {
  const std::string tooLong(200, 'x');
  EXPECT_THAT(
      problemsOf(planOf("id,text,version,minWallMm,preset\n,a,,,\n2,,,,\n3," + tooLong +
                        ",3,,\n4,d,99,,\n5,e,,thick,\n6,f,,-1,\n7,g,,,deep\n")),
      ElementsAre("2 row-without-id", "3 row-without-text", "4 text-too-long-for-version", "5 setting-out-of-range",
                  "6 setting-no-number", "7 setting-out-of-range", "8 setting-no-choice"));
}

TEST(BatchPlan, ReportsAtMostTwentyProblems) {
  std::string list = "id,text\n";
  for (int i = 0; i < 100; ++i) list += std::to_string(i) + ",\n";
  EXPECT_EQ(planOf(list).problems().size(), BatchPlan::kMostProblems);
}

TEST(BatchPlan, AcceptsOnlyPlainFileNames) {
  for (const char* name :
       {"../x.stl", "a/b.stl", "/etc/x.stl", "..\\x.stl", "C:x.stl", ".x.stl", "..", "a\nb.stl", "con.stl", "NUL.3mf",
        "lpt1.stl", "a?.stl", "a|b.stl", "\x7f.stl", "COM0.stl", "com\u00B2.stl", "con .stl", "conout$.stl"})
    EXPECT_EQ(whyNoPlainName(name).value_or(Message()).code, "name-no-plain-name") << name;
  EXPECT_EQ(whyNoPlainName("")->code, "name-empty");
  EXPECT_EQ(whyNoPlainName("a.txt")->code, "name-not-writable");
  EXPECT_EQ(whyNoPlainName("a")->code, "name-not-writable");
  EXPECT_EQ(whyNoPlainName(std::string(300, 'x') + ".stl")->code, "name-too-long");
  for (const char* name : {"1.stl", "Teil 7 (ä).3mf", "a..b.obj", "console.ply", "com10.stl", "x.STL"})
    EXPECT_FALSE(whyNoPlainName(name)) << name;
}

}  // namespace
}  // namespace qrelief
