// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "batch/manifest.h"
#include "batch/shard.h"

namespace qrelief {

/// The folder that a batch is written to, and what manifests in it say of its rows. Processes with shares of one batch
/// use it at the same time, each with a manifest of its own; none may have the share of another that is still at work.
///
/// A row counts as done if a manifest says so, with the hashes that are wanted, and its file has the hash that the
/// manifest has. A file is renamed to its name before its line is written, in one write that is on the disk when it
/// returns: a process that is killed loses the row that it is at.
class BatchFolder {
 public:
  /// Makes the folder if need be. What other shares of as many have is not asked for: it is none of this share's.
  /// @returns BadInput if it cannot be made or written to, if a manifest in it cannot be
  /// read, or if another process has this share
  static Result<BatchFolder> open(const std::string& path, const Shard& shard);
  ~BatchFolder();
  BatchFolder(BatchFolder&& other) noexcept;
  BatchFolder& operator=(BatchFolder&&) = delete;

  std::string pathOf(const std::string& file) const { return path_ + "/" + file; }

  /// What is known of a row.
  struct Known {
    enum class State {
      New,      ///< nothing, or what was made of something else
      Done,     ///< nothing is to be done
      Failed,   ///< it was tried with the same hashes, in vain
      Changed,  ///< it was done, but its file is not what was written
    };
    State state = State::New;
    ManifestEntry entry;  ///< of Done and Failed: the manifest's; of Changed: what now is to be said
  };

  /// Cost: reading the row's file and plate.
  /// @param wanted  number, file, plate, and hashes but for those of what was written
  Known known(const ManifestEntry& wanted) const;

  /// Removes the file of a row that has now failed, if it is one that a manifest says was made of the row with other
  /// hashes: a code that is not wanted any more is not to lie among the others. What somebody has changed stays.
  void removeOutdated(const ManifestEntry& failed) const;

  /// Adds a line to this process's manifest.
  Status append(const ManifestEntry& entry);

  /// Visits every row that a manifest knows, in their order, as the last line about it has it; one that is done before
  /// one that is not. Cost: reading its line, and little memory.
  /// @returns BadInput if a line cannot be read any more, or what `visit` returns if it is an error
  Status forEach(const std::function<Status(const ManifestEntry&)>& visit) const;

  /// Rows that manifests of several shares call done.
  std::vector<std::size_t> doubles() const;

  /// Writes manifest.jsonl and manifest.csv of the rows that forEach() visits, up to a number.
  Status writeManifest(std::size_t lastNumber) const;

 private:
  /// Where a manifest's last line about a row stands.
  struct Line {
    std::uint64_t begin;
    std::uint32_t bytes;
    RowStatus status;
  };
  /// A line of the manifest of some name.
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
  int file_ = -1;                                                 // this process's manifest, locked
  std::uint64_t end_ = 0;                                         // of it
  std::map<std::string, std::map<std::size_t, Line>> manifests_;  // by file; a million rows take 80 MB
};

}  // namespace qrelief
