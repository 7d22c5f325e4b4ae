// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "batch/batch_unit.h"
#include "batch/manifest.h"
#include "batch/manifest_index.h"
#include "batch/shard.h"

namespace qrelief {

/// The output folder of a batch, and the manifests in it. Processes with shares of one batch use it at the same time,
/// each with a manifest of its own. No two running processes may have the same share.
///
/// A row is done if a manifest says so with the wanted hashes, and the row's file has the hash in that manifest. A file
/// gets its final name before its line is written. A line is one write, which is on the disk when it returns. So a
/// process that is killed loses only its current row.
class BatchFolder {
 public:
  /// Makes the folder if necessary. Reads no manifests of other shares of the same count: they have none of this
  /// share's rows.
  /// @returns BadInput if the folder cannot be made or written to, if a manifest in it cannot be read, or if another
  /// process has this share
  static Result<BatchFolder> open(const std::string& path, const Shard& shard);
  ~BatchFolder();
  BatchFolder(BatchFolder&& other) noexcept;
  BatchFolder& operator=(BatchFolder&&) = delete;

  std::string pathOf(const std::string& file) const { return path_ + "/" + file; }

  /// Looks a row up. Cost: reading the row's file and plate. @param planned  the row's pending entry
  EarlierRow known(const ManifestEntry& planned) const;

  /// Removes the outdated file of a row that has now failed: a file that a manifest lists for the row with other
  /// hashes. An outdated code must not stay among the others. A file that somebody has changed stays.
  void removeOutdated(const ManifestEntry& failed) const;

  /// Adds a line to this process's manifest.
  Status append(const ManifestEntry& entry);

  /// Visits every row in the manifests, in order, with the last line about it; a line that says done wins over one that
  /// does not. Cost: reading each row's line, and little memory.
  /// @returns BadInput if a line cannot be read any more, or the error that `visit` returns
  Status forEach(const std::function<Status(const ManifestEntry&)>& visit) const;

  /// Returns the rows that the manifests of several shares call done.
  std::vector<std::size_t> doubles() const;

  /// Writes manifest.jsonl and manifest.csv with the rows that forEach() visits, up to a row number.
  Status writeManifest(std::size_t lastNumber) const;

 private:
  using Line = ManifestIndex::Line;
  /// A line and the name of its manifest.
  struct Found {
    std::size_t number;
    const std::string* name;
    Line line;
  };

  BatchFolder() = default;
  Status readManifests(const Shard& shard);
  Result<ManifestEntry> entryAt(const std::string& name, const Line& line) const;
  std::vector<Found> found() const;
  std::optional<std::string> hashOf(const std::string& file) const;

  std::string path_, own_;
  int file_ = -1;                                   // this process's manifest, locked
  std::map<std::string, ManifestIndex> manifests_;  // by file
};

}  // namespace qrelief
