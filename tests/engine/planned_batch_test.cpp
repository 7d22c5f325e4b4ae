// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/planned_batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "batch/manifest.h"
#include "settings/setting_json.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

std::vector<std::uint8_t> bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

Json planned(PlannedBatch& batch, const std::string& list, const Json& wanted = Json::object()) {
  Json asked = {{"settings", {{"text", "of one code"}}}, {"text", ""}, {"name", ""}, {"count", 0}, {"perPlate", 0}};
  asked.update(wanted);
  return Json::parse(batch.planBatch(bytesOf(list), asked.dump()));
}

TEST(PlannedBatch, ReadsTheRowsOfAListAndTheirCommonVersion) {
  PlannedBatch batch;
  const Json plan = planned(batch, "id,text,colour\na,one,red\nb,a text that just needs version 3,blue\n");
  ASSERT_EQ(plan["ok"], true) << plan;
  EXPECT_EQ(plan["rows"], 2);
  EXPECT_EQ(plan["problems"], Json::array());
  EXPECT_EQ(plan["unused"], Json({"colour"}));
  EXPECT_EQ(plan["version"], 3);
  EXPECT_EQ(plan["modules"], 29);
  const Json row = Json::parse(batch.batchRow(1))["row"];
  EXPECT_EQ(row["number"], 2);
  EXPECT_EQ(row["line"], 3);
  EXPECT_EQ(row["id"], "b");
  EXPECT_EQ(row["file"], "b.stl");
}

TEST(PlannedBatch, NamesTheColumnsWithTheirFirstFiveCellsToChooseFrom) {
  PlannedBatch batch;
  const Json unknown = planned(batch, "Part,Website\nM8,example.org/8\n");
  ASSERT_EQ(unknown["problems"][0]["code"], "list-without-text") << unknown;
  EXPECT_EQ(unknown["columns"], Json::parse(R"([{"name": "Part", "cells": ["M8"]},
                                                {"name": "Website", "cells": ["example.org/8"]}])"));
  const Json six = planned(batch, "nr,url\n1,a\n2,b\n3,c\n4,d\n5,e\n6,f\n");
  EXPECT_EQ(six["columns"][1]["cells"], Json({"a", "b", "c", "d", "e"}));
  EXPECT_EQ(six["textNames"], Json({"url"}));
  const Json chosen = planned(batch, "Part,Website\nM8,example.org/8\n", {{"text", "{Website}"}, {"id", "Part"}});
  ASSERT_EQ(chosen["rows"], 1) << chosen;
  EXPECT_EQ(Json::parse(batch.batchRow(0))["row"]["id"], "M8");
  EXPECT_EQ(planned(batch, "red\ngreen\n", {{"hasNames", false}})["rows"], 2);
}

TEST(PlannedBatch, NumbersRowsWithoutAList) {
  PlannedBatch batch;
  const Json plan =
      planned(batch, "", {{"count", 12}, {"text", "https://example.org/p/{n:05}"}, {"name", "part-{n}.3mf"}});
  ASSERT_EQ(plan["rows"], 12) << plan;
  const Json row = Json::parse(batch.batchRow(11))["row"];
  EXPECT_EQ(row["text"], "https://example.org/p/00012");
  EXPECT_EQ(row["file"], "part-12.3mf");
  EXPECT_EQ(Json::parse(batch.batchRow(12))["error"]["code"], "no-such-row");
}

TEST(PlannedBatch, NamesThePlateOfARow) {
  PlannedBatch batch;
  const Json plan = planned(batch, "", {{"count", 5}, {"text", "part {n}"}, {"perPlate", 2}});
  ASSERT_EQ(plan["rows"], 5) << plan;
  std::vector<std::string> files;
  for (int index = 0; index < 5; ++index) files.push_back(Json::parse(batch.batchRow(index))["row"]["file"]);
  EXPECT_THAT(
      files, testing::ElementsAre("plate-001.3mf", "plate-001.3mf", "plate-002.3mf", "plate-002.3mf", "plate-003.3mf"));
}

TEST(PlannedBatch, GivesARowTheSettingsThatDifferFromTheCommonOnes) {
  PlannedBatch batch;
  ASSERT_EQ(planned(batch, "text,preset\none,\ntwo,robust\n", {{"settings", {{"text", ""}, {"sizeMm", 0}}}})["ok"],
            false);
  const Json all = {{"text", ""}, {"pattern", "square"}};
  ASSERT_EQ(planned(batch, "text,preset\none,\ntwo,robust\n", {{"settings", all}})["rows"], 2);
  EXPECT_EQ(Json::parse(batch.batchRow(0))["row"]["settings"], Json({{"text", "one"}, {"version", 1}}));
  EXPECT_EQ(Json::parse(batch.batchRow(1))["row"]["settings"],
            Json({{"text", "two"}, {"version", 1}, {"preset", "robust"}}));
}

TEST(PlannedBatch, RefusesAFaultyListAndThenHasNoRows) {
  PlannedBatch batch;
  ASSERT_EQ(planned(batch, "id,text\na,one\n")["rows"], 1);
  const Json plan = planned(batch, "id,text\na,one\nb,one\n");
  EXPECT_EQ(plan["ok"], true);
  EXPECT_EQ(plan["rows"], 0);
  ASSERT_EQ(plan["problems"].size(), 1u);
  EXPECT_EQ(plan["problems"][0]["code"], "list-line");
  EXPECT_EQ(plan["problems"][0]["values"]["line"]["index"], 3);
  EXPECT_EQ(plan["mayBeMore"], false);
  EXPECT_EQ(Json::parse(batch.batchRow(0))["error"]["code"], "no-such-row");
  EXPECT_EQ(planned(batch, "id,text\n\"a,one\n")["error"]["code"], "list-quote-open");
}

TEST(PlannedBatch, HashesLikeTheCommand) {
  PlannedBatch batch;
  planned(batch, "id,text\na,one\n");
  BatchRow row;
  row.file = "a.stl";
  row.request = *requestFromJson(R"({"text": "one", "version": 1})");
  row.request.placement.centreMm = {1, 2.5, -3};
  Json placed = {{"of", "plate"}, {"centre", {1, 2.5, -3}}, {"others", "z 1"}, {"mates", Json::array()}};
  EXPECT_EQ(Json::parse(batch.unitTexts(0, placed.dump()))["texts"], Json::array());
  placed["of"] = "rows";
  EXPECT_EQ(Json::parse(batch.unitTexts(0, placed.dump()))["texts"], Json({settingsToHash(row, "z 1")}));
  EXPECT_EQ(Json::parse(batch.unitTexts(1, placed.dump()))["error"]["code"], "no-such-row");

  planned(batch, "id,text\na,one\n", {{"perPlate", 2}});
  placed["of"] = "plate";
  EXPECT_EQ(Json::parse(batch.unitTexts(0, placed.dump()))["texts"], Json({settingsToHash(row, "")}));
  placed.update({{"of", "rows"}, {"mates", {"77"}}});
  EXPECT_EQ(Json::parse(batch.unitTexts(0, placed.dump()))["texts"], Json({settingsToHash(row, "z 177")}));
}

TEST(PlannedBatch, ListsTheEntriesOfAUnitBeforeItIsCarved) {
  PlannedBatch batch;
  planned(batch, "id,text\na,one\nb,two\nc,three\n", {{"perPlate", 2}});
  const Json hashes = {{"input", "in"}, {"settings", {"h1", "h2"}}};
  const Json entries = Json::parse(batch.unitEntries(1, hashes.dump()))["entries"];
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[1], Json({{"number", 2},
                              {"id", "b"},
                              {"text", "two"},
                              {"file", "plate-001.3mf"},
                              {"sha256", {{"input", "in"}, {"settings", "h2"}}},
                              {"status", "failed"}}));
  EXPECT_EQ(Json::parse(batch.unitEntries(3, hashes.dump()))["error"]["code"], "no-such-row");
}

}  // namespace
}  // namespace qrelief
