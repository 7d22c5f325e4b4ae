// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  /// Makes the folder if need be. @returns BadInput if it cannot be made or written to, if a manifest in it cannot be
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

  /// Adds a line to this process's manifest.
  Status append(const ManifestEntry& entry);

  /// Every row that a manifest knows, as the last line about it has it; one that is done before one that is not.
  std::map<std::size_t, ManifestEntry> entries() const;

  /// Rows that manifests of several shares call done.
  std::vector<std::size_t> doubles() const;

  /// Writes manifest.jsonl and manifest.csv of these rows, in their order.
  Status writeManifest(const std::map<std::size_t, ManifestEntry>& entries) const;

 private:
  BatchFolder() = default;
  Status readManifests();
  std::optional<std::string> hashOf(const std::string& file) const;

  std::string path_, own_;
  int file_ = -1;                                                          // this process's manifest, locked
  std::map<std::string, std::map<std::size_t, ManifestEntry>> manifests_;  // by file
};

}  // namespace qrelief
