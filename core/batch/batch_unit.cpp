// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_unit.h"

#include <numeric>

namespace qrelief {

std::vector<std::string> matesToHash(const BatchUnit& unit) {
  std::vector<std::string> texts;
  if (unit.plate.empty()) return texts;
  for (const BatchRow& row : unit.rows) texts.push_back(settingsToHash(row, {}));
  return texts;
}

std::vector<std::string> rowsToHash(const BatchUnit& unit, std::span<const std::string> mates) {
  const std::string others = std::accumulate(mates.begin(), mates.end(), unit.others);
  std::vector<std::string> texts;
  for (const BatchRow& row : unit.rows) texts.push_back(settingsToHash(row, others));
  return texts;
}

std::vector<ManifestEntry> pendingEntries(const BatchUnit& unit, std::span<const std::string> hashes) {
  std::vector<ManifestEntry> entries;
  for (const BatchRow& row : unit.rows) {
    ManifestEntry entry;
    entry.number = row.number;
    entry.id = row.id;
    entry.text = row.request.code.text;
    entry.file = unit.hasOwnFiles ? row.file : unit.plate;
    entry.plate = unit.hasOwnFiles ? unit.plate : std::string();
    if (const std::vector<std::string> files = row.files(); unit.hasOwnFiles && files.size() > 1)
      (row.request.marking.isOpen ? entry.possibleSecond.emplace() : entry.second) = files[1];
    entry.sha256.input = unit.input;
    if (entries.size() < hashes.size()) entry.sha256.settings = hashes[entries.size()];
    entries.push_back(std::move(entry));
  }
  return entries;
}

void EarlierRow::add(const ManifestEntry& listed, const ManifestEntry& planned, const HashOf& hashOf) {
  if (state == State::Done || listed.file != planned.file || listed.plate != planned.plate ||
      (listed.second != planned.second && listed.second != planned.possibleSecond) ||
      listed.sha256.input != planned.sha256.input || listed.sha256.settings != planned.sha256.settings)
    return;
  if (listed.status != RowStatus::Done) {
    if (state == State::New) *this = {State::Failed, listed};
    return;
  }
  const auto file = hashOf(listed.file), plate = hashOf(listed.plate), second = hashOf(listed.second);
  if (!file || !plate || !second) return;  // the file is gone: carve it again
  const bool isSame = *file == listed.sha256.output && *plate == listed.sha256.plate && *second == listed.sha256.second;
  *this = {isSame ? State::Done : State::Changed, listed};
}

}  // namespace qrelief
