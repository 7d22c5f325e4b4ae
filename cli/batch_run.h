// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "batch/batch_plan.h"
#include "cli/model_input.h"
#include "cli/setting_flags.h"
#include "native/batch_folder.h"
#include "native/egl_context.h"
#include "native/engraver.h"
#include "report/report.h"

namespace qrelief {

/// What the command line says of a batch.
struct BatchOptions {
  ModelFlags model;
  SettingFlags flags;
  std::string list, folder, name, shardFlag;
  std::vector<double> at;
  std::size_t count = 0, shards = 0, perPlate = 0, printEvery = 1;
  bool merge = false, retryFailed = false, stream = false, reports = false, quiet = false;
};

/// Carves the rows of one process of a batch into its folder. prepare() comes first.
class BatchRun {
 public:
  /// @param options  kept by reference
  BatchRun(const BatchOptions& options, BatchFolder folder) : options_(&options), folder_(std::move(folder)) {}

  /// Loads the model, and finds the place that all rows share. @param all  a row's; then has the place
  Status prepare(EngraveRequest& all);

  /// Carves what is not yet there of some rows: of one, or of all of a plate. Their lines are written last.
  /// @param placed  has the place that prepare() found
  /// @param plate   name of the plate's file; empty: none
  /// @returns an entry a row; an error only if nothing more can be written
  Result<std::vector<ManifestEntry>> make(std::vector<BatchRow> rows, const EngraveRequest& placed,
                                          const std::string& plate = {});

  std::size_t made() const { return made_; }      ///< rows that were carved now, and passed
  std::size_t kept() const { return kept_; }      ///< that were there before
  std::size_t failed() const { return failed_; }  ///< now or before
  const BatchFolder& folder() const { return folder_; }

 private:
  bool isFiled() const;
  Status carveAll(const std::vector<BatchRow>& rows, std::vector<ManifestEntry>& entries, const std::string& plate);
  Result<Engraved> carve(const BatchRow& row, ManifestEntry& entry);
  Status writeReport(const BatchRow& row, const Engraved& engraved, double totalMs) const;

  const BatchOptions* options_;
  BatchFolder folder_;
  std::unique_ptr<EglContext> gl_;  // outlives what lies in it
  std::shared_ptr<const EngravableModel> model_;
  std::optional<Engraver> engraver_;
  std::vector<std::string> partNames_;
  std::string input_;     // SHA-256 of the model's file
  ReportContext report_;  // what all rows' reports have
  std::size_t made_ = 0, kept_ = 0, failed_ = 0;
};

}  // namespace qrelief
