// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "batch/batch_plan.h"
#include "batch/batch_unit.h"
#include "cli/file_flags.h"
#include "cli/model_input.h"
#include "cli/setting_flags.h"
#include "native/batch_folder.h"
#include "native/engrave.h"
#include "native/graphics.h"
#include "report/report.h"

namespace qrelief {

/// Command-line options of a batch.
struct BatchOptions {
  ModelFlags model;
  SettingFlags flags;
  FileFlags fileFlags;
  std::string list, folder, name, shardFlag;
  std::vector<double> at;
  std::size_t count = 0, first = 1, shards = 0, perPlate = 0, printEvery = 1;
  bool merge = false, retryFailed = false, stream = false, reports = false, quiet = false;
};

/// Returns the path of a row's model: relative to the list's folder. @param model  as in BatchRow::model
std::string modelPath(const BatchOptions& options, const std::string& model);

/// Checks that a model can be opened more than once. @returns BadInput for a pipe, or a file that cannot be opened
Status checkModel(const std::string& path);

/// Carves one process's rows of a batch into the folder.
class BatchRun {
 public:
  /// @param options  kept by reference
  BatchRun(const BatchOptions& options, BatchFolder folder) : options_(&options), folder_(std::move(folder)) {}

  /// Loads the model of the rows that follow, unless it is loaded, and finds the place that all its rows share.
  /// @param model  as in BatchRow::model
  /// @param first  request of the first row with this model
  Status use(const std::string& model, const EngraveRequest& first);

  /// The rows of a unit: carved now, or as they were before.
  struct Made {
    std::vector<ManifestEntry> entries;  ///< one per row
    bool isNew = false;                  ///< carved now
  };

  /// Carves the rows that are not done yet: a single row, or all rows of a plate. Writes their lines last. Call
  /// use() for their model first.
  /// @param plate  name of the plate's file; empty: none
  /// @returns an error only if nothing more can be written
  Result<Made> make(std::vector<BatchRow> rows, const std::string& plate = {});

  /// Writes the lines of rows whose model cannot be used.
  Result<Made> refuse(std::vector<BatchRow> rows, const Message& why);

  const BatchFolder& folder() const { return folder_; }

 private:
  bool isFiled() const;
  Status carveAll(const BatchUnit& unit, std::vector<ManifestEntry>& entries);
  Result<Engraved> carve(const BatchRow& row, ManifestEntry& entry);
  void tellMoved(const EngraveResult& result);
  void tellNotKept(const std::optional<Message>& why);
  Status writeReport(const BatchRow& row, const Engraved& engraved, double totalMs) const;

  const BatchOptions* options_;
  BatchFolder folder_;
  std::optional<Graphics> graphics_;                // outlives the GL objects below
  std::optional<std::string> used_;                 // the loaded model
  std::map<std::string, PlacementRequest> places_;  // by model
  std::shared_ptr<const EngravableModel> model_;
  std::optional<Engraver> engraver_;
  std::vector<std::string> partNames_;
  std::string input_;     // SHA-256 of the model's file
  ReportContext report_;  // common to the reports of all rows
  bool hasToldNotKept_ = false, hasToldMoved_ = false;
};

}  // namespace qrelief
