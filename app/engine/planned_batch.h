// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "batch/batch_layout.h"
#include "batch/batch_plan.h"
#include "batch/batch_unit.h"

namespace qrelief {

/// The rows of a batch, as the page asks for them. Needs neither a model nor a GL context: Engine::configure() and
/// startJob() carve the rows, and TrackedBatch knows which. Answers have the form that Engine describes.
class PlannedBatch {
 public:
  /// Plans a batch, see BatchPlan. Returns {rows, problems: [message], mayBeMore, unused: [column], columns: [{name,
  /// cells}], textNames: [name], warnings: [message], version, modules}; `cells`: of the first rows; `textNames`: see
  /// BatchPlan::textNames(). With a problem there are no rows; `version` and `modules` belong to the first row. An
  /// error if the list cannot be read.
  /// @param list   the list's file; ignored if there is a count
  /// @param order  {"settings": {…}, "text", "name", "count", "perPlate"}: the settings of all rows; the templates, ""
  ///               where the list's columns give the values; the number of rows without a list; and the number of rows
  ///               per plate, or 0. It may have "id", the column of the ids, and "hasNames", see BatchListOptions
  std::string planBatch(const std::vector<std::uint8_t>& list, const std::string& order);

  /// Returns {row: {number, line, id, text, file, settings}}. For a row on a plate, `file` is the plate's. `settings`
  /// are those in which the row differs from the common ones, and always its text and version. @param index  from 0
  std::string batchRow(double index) const;
  /// Returns {texts}: for the rows of a unit (core/batch/batch_layout.h) the texts to hash as their settings; or, with
  /// `of` "plate", the texts whose hashes that needs as `mates`, none without a plate. @param index  of any of its rows
  /// @param placed  {"of": "plate" or "rows", "centre": [x, y, z], "others": how the model was scaled and turned,
  ///                "mates"}
  std::string unitTexts(double index, const std::string& placed) const;
  /// Returns {entries: [manifest entry]}: the rows of a unit before they are carved, with status "failed".
  /// @param hashes  {"input": of the model's file, "settings": of the rows' texts, or []}
  std::string unitEntries(double index, const std::string& hashes) const;

 private:
  std::optional<BatchRow> at(double index) const;
  std::string fileOf(const BatchRow& row) const;
  BatchLayout layout() const { return {plan_->size(), perPlate_}; }
  std::optional<BatchUnit> unitAt(double index) const;

  std::optional<BatchPlan> plan_;  // none: the plan has problems
  EngraveRequest all_;
  std::size_t perPlate_ = 0;
};

}  // namespace qrelief
