// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "batch/batch_plan.h"
#include "batch/manifest.h"

namespace qrelief {

/// Rows that are carved together, and everything that determines their files.
struct BatchUnit {
  std::vector<BatchRow> rows;  ///< placed
  std::string plate;           ///< name of the plate's file; empty: none
  bool hasOwnFiles = true;     ///< true: one file for each row; false: the plate is the only file
  std::string input;           ///< SHA-256 of the model's file
  std::string others;          ///< how the model was repaired, scaled and turned
};

/// Returns the texts whose hashes rowsToHash() needs: one per row of a plate, because a plate's file depends on all its
/// rows; none without a plate.
std::vector<std::string> matesToHash(const BatchUnit& unit);

/// Returns the text of each row to hash as RowHashes::settings. @param mates  hashes of the texts of matesToHash()
std::vector<std::string> rowsToHash(const BatchUnit& unit, std::span<const std::string> mates);

/// Returns the entries of the rows before they are carved, with the status Failed.
/// @param hashes  of the texts of rowsToHash()
std::vector<ManifestEntry> pendingEntries(const BatchUnit& unit, std::span<const std::string> hashes);

/// State of a row according to the manifests of earlier runs, some of which may list it with other inputs.
struct EarlierRow {
  enum class State {
    New,      ///< no entry, or an entry with other hashes
    Done,     ///< nothing to do
    Failed,   ///< tried with the same hashes, and failed
    Changed,  ///< done, but its file has changed since
  };
  /// Returns the hash of a file. An empty name has an empty hash, a missing file has none.
  using HashOf = std::function<std::optional<std::string>(const std::string& file)>;

  State state = State::New;
  ManifestEntry entry;  ///< the manifest's entry; set unless the state is New

  /// Takes a manifest's entry of the row into account. A later Failed does not replace Changed; Done is final.
  /// @param planned  the row's pending entry
  void add(const ManifestEntry& listed, const ManifestEntry& planned, const HashOf& hashOf);

  /// Returns true if the row is to be carved. @param retries  carve failed and changed rows again
  bool isOpen(bool retries) const { return state == State::New || (retries && state != State::Done); }
};

}  // namespace qrelief
