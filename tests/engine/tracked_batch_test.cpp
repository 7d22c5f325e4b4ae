// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/tracked_batch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "batch/manifest.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

std::vector<std::uint8_t> bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

std::string line(std::size_t number, RowStatus status, const std::string& reason = {}) {
  ManifestEntry entry;
  entry.number = number;
  entry.status = status;
  entry.reason = reason;
  return manifestLine(entry) + "\n";
}

TEST(TrackedBatch, TakesUnitsAndRecordsTheirLines) {
  TrackedBatch batch;
  ASSERT_EQ(Json::parse(batch.begin(R"({"rows": 3, "perPlate": 2, "printEvery": 2})"))["ok"], true);
  batch.run("start");
  EXPECT_EQ(Json::parse(batch.take())["rows"],
            Json::parse(R"([{"index": 0, "print": true}, {"index": 1, "print": false}])"));
  batch.settle(line(1, RowStatus::Done) + line(2, RowStatus::Failed, "too large"));
  EXPECT_EQ(Json::parse(batch.state(R"({"page": {"state": "failed", "skipped": 0, "count": 5}})"))["rows"],
            Json::parse(R"([{"index": 1, "state": "failed", "reason": "too large"}])"));
  EXPECT_EQ(Json::parse(batch.state(R"({"page": {"state": "all", "skipped": 0, "count": 5}})"))["rows"].size(), 3u);
  const Json state = Json::parse(batch.state(R"({"workedMs": 100})"));
  EXPECT_EQ(state["done"], 1);
  EXPECT_EQ(state["finished"], 2);
  EXPECT_EQ(state["remainingMs"], 50);
  EXPECT_EQ(Json::parse(batch.take())["rows"], Json::parse(R"([{"index": 2, "print": true}])"));
  EXPECT_EQ(Json::parse(batch.take())["rows"], Json::array());
  batch.run("end");
  EXPECT_EQ(Json::parse(batch.state(R"({"workedMs": 100})"))["waiting"], 1);
}

TEST(TrackedBatch, SaysHowToReactToLosses) {
  TrackedBatch batch;
  batch.begin(R"({"rows": 2, "perPlate": 0, "printEvery": 1})");
  batch.take();
  EXPECT_EQ(Json::parse(batch.lose(0))["then"], "retry");
  batch.take();
  EXPECT_EQ(Json::parse(batch.lose(0))["then"], "fail");
  EXPECT_EQ(Json::parse(batch.lose(-1))["then"], "stop");
  EXPECT_TRUE(Json::parse(batch.state("{}"))["remainingMs"].is_null());
}

TEST(TrackedBatch, RestoresTheStatesAndFindsTheLastLines) {
  const std::string manifest = line(2, RowStatus::Failed, "why") + line(1, RowStatus::Done) + line(2, RowStatus::Done);
  TrackedBatch batch;
  batch.begin(R"({"rows": 3, "perPlate": 0, "printEvery": 1})");
  batch.readManifest(bytesOf(manifest.substr(0, 20)), true, true);
  batch.readManifest(bytesOf(manifest.substr(20)), false, true);
  EXPECT_EQ(Json::parse(batch.state("{}"))["done"], 2);
  const Json spans = Json::parse(batch.manifestSpans(2, 9))["spans"];
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(manifest.substr(spans[0][0], spans[0][1].get<std::size_t>() - spans[0][0].get<std::size_t>()) + "\n",
            line(2, RowStatus::Done));
  EXPECT_EQ(Json::parse(batch.manifestSpans(1, 1))["next"], 2);
  EXPECT_TRUE(Json::parse(batch.manifestSpans(1, 2))["next"].is_null());
  batch.readManifest(bytesOf(line(3, RowStatus::Done)), true, false);
  EXPECT_EQ(Json::parse(batch.state("{}"))["done"], 2);
  EXPECT_EQ(Json::parse(batch.manifestSpans(0, 9))["spans"].size(), 1u);
  EXPECT_EQ(Json::parse(batch.manifestSpans(4, 9))["spans"], Json::array());
}

TEST(TrackedBatch, WritesTheManifestLikeTheCommand) {
  ManifestEntry entry;
  entry.number = 3;
  entry.id = "a \"quoted\" id";
  entry.text = "one, two";
  entry.file = "a.stl";
  entry.sha256 = {"11", "22", "33", ""};
  entry.status = RowStatus::Done;
  entry.details = R"({"verdict":{"reads":"good"},"timingsMs":{"total":7.0}})";
  const std::string line = manifestLine(entry);
  const TrackedBatch batch;
  EXPECT_EQ(Json::parse(batch.manifestLine(nlohmann::ordered_json::parse(line).dump(2)))["line"], line);
  EXPECT_EQ(Json::parse(batch.manifestLine("{}"))["error"]["code"], "no-manifest-line");
  EXPECT_EQ(Json::parse(batch.manifestCsv(line + "\nno line\n", true))["csv"],
            manifestCsvHeader() + manifestCsvLine(entry));
  EXPECT_EQ(Json::parse(batch.manifestCsv(line, false))["csv"], manifestCsvLine(entry));
}

}  // namespace
}  // namespace qrelief
