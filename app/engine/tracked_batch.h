// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "batch/batch_progress.h"
#include "batch/manifest_index.h"

namespace qrelief {

/// The progress and the manifest of a batch that the page carves (core/batch/batch_progress.h). Needs no plan, so its
/// object outlives the modules that carve. Rows count from 0. Answers have the form that Engine describes.
class TrackedBatch {
 public:
  /// Begins with all rows waiting. @param layout  {"rows", "perPlate", "printEvery"}, see BatchLayout
  std::string begin(const std::string& layout);

  /// Returns {waiting, running, done, failed, finished, remainingMs}: counts of rows, and the estimated time to the
  /// end; null before the run's first row. @param workedMs  time of the run without pauses
  std::string state(double workedMs) const;
  /// Returns {rows: [{index, state, reason}]}: up to `count` rows after the first `skipped`. @param state  of the rows,
  /// or "all"
  std::string page(const std::string& state, double skipped, double count) const;

  /// Begins a run. @param retriesFailed  failed rows wait again
  std::string startRun(bool retriesFailed);
  /// Ends the run: running rows wait again.
  std::string endRun();
  /// Returns {rows: [{index, print}]}: the rows to carve next, all of one file, and whether to simulate their print;
  /// empty: no row waits.
  std::string take();
  /// Records the stored result of rows. @param lines  their lines in the manifest
  std::string settle(const std::string& lines);
  /// Returns {then: "retry", "fail" or "stop"}, see BatchProgress::Loss. @param row  one of the rows that were being
  /// carved; -1: the engine did not start
  std::string lose(double row);

  /// Returns {line}: the manifest's line (batch/manifest.h) without a line end. @param entry  the entry as JSON of any
  /// layout
  std::string manifestLine(const std::string& entry) const;
  /// Returns {csv}: manifest lines as a table. @param lines  of the manifest; other lines are left out
  std::string manifestCsv(const std::string& lines, bool withHeader) const;
  /// Reads the next bytes of a manifest, for manifestSpans(). @param isFirst  begins another manifest
  /// @param restores  sets the states of the rows to what the lines say
  std::string readManifest(const std::vector<std::uint8_t>& bytes, bool isFirst, bool restores);
  /// Returns {spans: [[begin, end]], next}: positions of the last line about each row, in the order of the rows, at
  /// most `count`, and the number to continue with, null at the end. @param fromNumber  least number of a row
  std::string manifestSpans(double fromNumber, double count) const;

 private:
  BatchProgress progress_;
  ManifestIndex index_;
};

}  // namespace qrelief
