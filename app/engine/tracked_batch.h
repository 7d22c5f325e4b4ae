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

  /// Returns {waiting, running, done, failed, finished, remainingMs, rows: [{index, state, reason}]}: counts of rows,
  /// the estimated time to the end, null before the run's first row, and the rows asked for.
  /// @param asked  {"workedMs": time of the run without pauses, "page": {"state": of the rows, or "all", "skipped",
  ///               "count"}}: up to `count` rows after the first `skipped`; both may be missing: 0, no rows
  std::string state(const std::string& asked) const;

  /// Begins or ends a run. @param what  "start"; "retry": failed rows wait again; "end": running rows wait again
  std::string run(const std::string& what);
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
