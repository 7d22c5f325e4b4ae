// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/manifest.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

ManifestEntry entry(std::size_t number, RowStatus status) {
  return {number,
          "id" + std::to_string(number),
          "a \"text\", with commas\nand ü",
          "f.stl",
          number % 2 ? "plate-1.3mf" : "",
          {"aa", "bb", status == RowStatus::Done ? "cc" : "", status == RowStatus::Done ? "dd" : ""},
          status,
          status == RowStatus::Done ? "" : "because",
          R"({"verdict":{"reads":"good","prints":"barely","solid":"good"},"depth":{"meanMm":0.5}})"};
}

void expectEqual(const ManifestEntry& a, const ManifestEntry& b) {
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.text, b.text);
  EXPECT_EQ(a.file, b.file);
  EXPECT_EQ(a.plate, b.plate);
  EXPECT_EQ(a.sha256, b.sha256);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.details, b.details);
}

TEST(Manifest, IsReadAsItWasWritten) {
  std::string text;
  for (const RowStatus status : {RowStatus::Done, RowStatus::Failed, RowStatus::Refused})
    text += manifestLine(entry(static_cast<std::size_t>(status) + 1, status)) + "\n";
  const auto rows = readManifest(text);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 3u);
  for (const auto& [number, row] : *rows) expectEqual(row, entry(number, static_cast<RowStatus>(number - 1)));
}

TEST(Manifest, HasWhatWasSaidLastOfARow) {
  const auto rows =
      readManifest(manifestLine(entry(4, RowStatus::Failed)) + "\n" + manifestLine(entry(4, RowStatus::Done)) + "\n");
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->at(4).status, RowStatus::Done);
}

TEST(Manifest, PassesOverALineWithoutEnd) {
  const std::string whole = manifestLine(entry(1, RowStatus::Done)) + "\n",
                    next = manifestLine(entry(2, RowStatus::Done));
  for (std::size_t i = 0; i <= next.size(); ++i) {
    const auto rows = readManifest(whole + next.substr(0, i));
    ASSERT_TRUE(rows) << i;
    EXPECT_EQ(rows->size(), 1u);
  }
}

TEST(Manifest, RefusesLinesOfSomethingElse) {
  const std::string good = manifestLine(entry(1, RowStatus::Done)) + "\n";
  for (const char* line : {"\n", "{}\n", "[]\n", "text\n", "{\"number\": 1}\n",
                           R"({"number":"1","id":"","text":"","file":"","sha256":{},"status":"done"})"
                           "\n"}) {
    const auto rows = readManifest(good + line);
    ASSERT_FALSE(rows) << line;
    EXPECT_EQ(rows.error().message.code, "manifest-line");
    EXPECT_EQ(rows.error().message.values[0].numbers[0], 2);
  }
}

TEST(Manifest, IsATableForSpreadsheets) {
  const std::string table = manifestCsv({{7, entry(7, RowStatus::Failed)}});
  EXPECT_EQ(
      table,
      "number,id,text,file,plate,status,reason,reads,prints,solid,meanDepthMm,maxDepthMm,iso29158,totalMs,sha256\r\n"
      "7,id7,\"a \"\"text\"\", with commas\nand ü\",f.stl,plate-1.3mf,failed,because,good,barely,good,0.5,,,,\r\n");
}

TEST(Manifest, HashesEverySettingNameAndPlace) {
  BatchRow row;
  row.file = "a.stl";
  row.request.text = "a";
  const std::string before = settingsToHash(row, "others");
  EXPECT_EQ(settingsToHash(row, "others"), before);
  EXPECT_NE(settingsToHash(row, "other"), before);
  for (void (*change)(BatchRow&) :
       {+[](BatchRow& r) { r.request.text = "b"; }, +[](BatchRow& r) { r.file = "b.stl"; },
        +[](BatchRow& r) { r.request.minWallMm = 2; }, +[](BatchRow& r) { r.request.placement.centreMm.y = 1e-9; }}) {
    BatchRow changed = row;
    change(changed);
    EXPECT_NE(settingsToHash(changed, "others"), before);
  }
}

}  // namespace
}  // namespace qrelief
