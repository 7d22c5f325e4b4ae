// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/manifest_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string line(std::size_t number, RowStatus status = RowStatus::Done) {
  ManifestEntry entry;
  entry.number = number;
  entry.text = "ä";
  entry.status = status;
  return manifestLine(entry) + "\n";
}

/// Returns number and text of each indexed line.
std::vector<std::string> linesOf(const ManifestIndex& index, const std::string& manifest) {
  std::vector<std::string> lines;
  for (const auto& [number, at] : index.lines())
    lines.push_back(std::to_string(number) + " " + manifest.substr(at.begin, at.bytes) + "\n");
  return lines;
}

TEST(ManifestIndex, FindsTheLastLineAboutEachRowInAnyPieces) {
  const std::string manifest = line(3) + line(1, RowStatus::Failed) + line(2) + line(1);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, manifest.size()}) {
    ManifestIndex index;
    for (std::size_t at = 0; at < manifest.size(); at += piece) index.read(manifest.substr(at, piece));
    EXPECT_THAT(linesOf(index, manifest), ElementsAre("1 " + line(1), "2 " + line(2), "3 " + line(3))) << piece;
    EXPECT_EQ(index.lines().at(1).status, RowStatus::Done);
    EXPECT_EQ(index.firstBadLine(), 0u);
  }
}

TEST(ManifestIndex, AnUnfinishedLastLineDoesNotCount) {
  const std::string manifest = line(1);
  ManifestIndex index;
  index.read(manifest.substr(0, manifest.size() - 1));
  EXPECT_THAT(index.lines(), IsEmpty());
  index.read("\n");
  EXPECT_THAT(linesOf(index, manifest), ElementsAre("1 " + manifest));
}

TEST(ManifestIndex, SkipsOtherLinesAndKnowsTheFirst) {
  const std::string manifest = line(1) + "{\"number\": 3, \"sta\n" + "\n" + line(2);
  ManifestIndex index;
  std::vector<std::size_t> visited;
  index.read(manifest, [&](const ManifestEntry& entry) { visited.push_back(entry.number); });
  EXPECT_THAT(visited, ElementsAre(1, 2));
  EXPECT_THAT(linesOf(index, manifest), ElementsAre("1 " + line(1), "2 " + line(2)));
  EXPECT_EQ(index.firstBadLine(), 2u);
}

}  // namespace
}  // namespace qrelief
