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

TEST(Manifest, ReadsBackWhatItWrote) {
  for (const RowStatus status : {RowStatus::Done, RowStatus::Failed, RowStatus::Refused}) {
    const auto row = readManifestLine(manifestLine(entry(4, status)));
    ASSERT_TRUE(row);
    expectEqual(*row, entry(4, status));
  }
}

TEST(Manifest, KeepsTheSecondFileOfARow) {
  ManifestEntry done = entry(4, RowStatus::Done);
  done.second = "f-2.stl";
  done.sha256.second = "ee";
  const auto row = readManifestLine(manifestLine(done));
  ASSERT_TRUE(row);
  EXPECT_EQ(row->second, "f-2.stl");
  expectEqual(*row, done);
  EXPECT_NE(manifestCsvLine(done).find(",cc,f-2.stl,ee\r\n"), std::string::npos) << manifestCsvLine(done);
}

TEST(Manifest, RefusesLinesThatAreNotOfAManifest) {
  for (const char* line : {"", "{}", "[]", "text", "{\"number\": 1}",
                           R"({"number":"1","id":"","text":"","file":"","sha256":{},"status":"done"})"})
    EXPECT_FALSE(readManifestLine(line)) << line;
  const std::string whole = manifestLine(entry(1, RowStatus::Done));
  EXPECT_FALSE(readManifestLine(std::string(100'000, '[')));
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_FALSE(readManifestLine(whole.substr(0, i))) << i;
}

TEST(Manifest, WritesATableForSpreadsheets) {
  const std::string table = manifestCsvHeader() + manifestCsvLine(entry(7, RowStatus::Failed));
  EXPECT_EQ(
      table,
      "number,id,text,file,plate,status,reason,reads,prints,solid,meanDepthMm,maxDepthMm,iso29158,totalMs,sha256,"
      "second,sha256Second\r\n"
      "7,id7,\"a \"\"text\"\", with commas\nand ü\",f.stl,plate-1.3mf,failed,because,good,barely,good,0.5,,,,,,\r\n");
}

TEST(Manifest, HashesEverySettingNameAndPlace) {
  BatchRow row;
  row.file = "a.stl";
  row.request.code.text = "a";
  const std::string before = settingsToHash(row, "others");
  EXPECT_EQ(settingsToHash(row, "others"), before);
  EXPECT_NE(settingsToHash(row, "other"), before);
  for (void (*change)(BatchRow&) :
       {+[](BatchRow& r) { r.request.code.text = "b"; }, +[](BatchRow& r) { r.file = "b.stl"; },
        +[](BatchRow& r) { r.request.depth.minWallMm = 2; },
        +[](BatchRow& r) { r.request.placement.centreMm.y = 1e-9; }}) {
    BatchRow changed = row;
    change(changed);
    EXPECT_NE(settingsToHash(changed, "others"), before);
  }
}

}  // namespace
}  // namespace qrelief
