// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "batch/batch_layout.h"
#include "batch/manifest.h"

namespace qrelief {

enum class RowState : std::uint8_t { Waiting, Running, Done, Failed };

/// Returns "waiting", "running", "done" or "failed".
std::string_view rowStateName(RowState state);

/// Returns the state of that name; none for any other text.
std::optional<RowState> readRowState(std::string_view name);

/// The states of a batch's rows, and the rows to carve next. The host carves them, stores their files and then their
/// lines, and reports back. Rows count from 0. Takes a byte per row, and the reasons of failed rows.
class BatchProgress {
 public:
  struct Counts {
    std::size_t waiting = 0, running = 0, done = 0, failed = 0;
    std::size_t finished() const { return done + failed; }
  };

  /// Begins with all rows waiting. @param share  units to carve; other rows do not count
  explicit BatchProgress(const BatchLayout& layout = {}, const Shard& share = {});

  const BatchLayout& layout() const { return layout_; }
  const Counts& counts() const { return counts_; }
  RowState state(std::size_t row) const { return states_[row]; }

  /// Returns the reason why a row has failed; empty for other rows.
  std::string_view reason(std::size_t row) const;

  /// Returns up to `count` rows in a state, or in any state, after the first `skipped`.
  std::vector<std::size_t> page(std::optional<RowState> state, std::size_t skipped, std::size_t count) const;

  /// Sets a row's state to what the manifest says. A later line about the row replaces an earlier one. Ignores lines
  /// about rows that are not in the share.
  void note(const ManifestEntry& entry);

  /// Begins a run: no unit is lost yet, and no row is carved.
  /// @param retriesFailed  failed rows wait again
  void startRun(bool retriesFailed = false);

  /// Ends the run: running rows wait again.
  void endRun();

  /// Returns the first unit with a waiting row; none if no row waits. All rows of the unit are running then: a plate is
  /// carved as a whole.
  std::optional<std::size_t> take();

  /// Records the result of a unit that was carved in this run.
  void settle(std::span<const ManifestEntry> carved);

  /// Reaction to the loss of an engine.
  enum class Loss {
    Retry,  ///< go on with another engine; the rows wait again
    Fail,   ///< the second loss with this unit: report its rows as failed; they are running until then
    Stop    ///< too many losses without a row in between: end the run
  };
  /// @param unit  the unit being carved; none: it did not start
  Loss lose(std::optional<std::size_t> unit);

  /// Estimates the time to the end, in ms, at the pace of this run so far; none before the first row.
  /// @param workedMs  time of this run without pauses
  std::optional<double> remainingMs(double workedMs) const;

 private:
  void set(std::size_t row, RowState state, std::string reason = {});
  std::size_t& countOf(RowState state);

  BatchLayout layout_;
  Shard share_;
  std::vector<RowState> states_;
  std::map<std::size_t, std::string> reasons_;  // of failed rows
  Counts counts_;
  std::size_t firstWaiting_ = 0;  // no earlier row waits
  std::set<std::size_t> lost_;    // units lost once in this run
  std::size_t losses_ = 0;        // since the last carved row
  std::size_t carved_ = 0;        // rows carved in this run
};

}  // namespace qrelief
