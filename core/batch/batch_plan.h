// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "batch/batch_list.h"
#include "batch/text_template.h"
#include "settings/engrave_request.h"
#include "settings/settings.h"

namespace qrelief {

/// The settings and templates that all rows of a batch share.
struct BatchRequest {
  /// Settings of all rows. Its text is a template; empty: the list has a column `text`, `url` or `link`. Its label is a
  /// template, too.
  /// If it leaves the version open, the smallest version that holds every row's text is used, so that all codes have
  /// the same size.
  EngraveRequest all;
  std::string name;             ///< template for file names; empty: the list's column `file`, else "{id}.stl", or
                                ///< "{id}.3mf" in colour
  std::size_t firstNumber = 1;  ///< number of the first row
  std::string idColumn = "id";  ///< column of the ids; if the list has none of that name, an id is the row's number
};

/// A code of a batch.
struct BatchRow {
  std::size_t number = 1;  ///< its place in the list, counted from BatchRequest::firstNumber
  std::uint32_t line = 1;  ///< line of the list in which the row begins
  std::string id;          ///< of BatchRequest::idColumn, or else the number
  std::string file;        ///< a plain name, without a folder
  std::string model;       ///< path of the row's own model, as in the column `model`; empty: the model of all rows
  EngraveRequest request;

  /// Returns the names of all files that this row may have, `file` first (io/write_files.h).
  std::vector<std::string> files() const;
};

/// The rows that a list requests, all checked before the first one is carved.
///
/// Columns are `id`, `text`, `file`, `model`, keys of settings (an empty cell keeps the value that all rows have), and
/// any names used in templates; `{n}` is the row's number. Capitals in names of columns do not count. The plan refuses:
/// a column that a template names and the list lacks; a value that a setting does not accept; a text, a name or an id
/// that two rows share (names that differ only in capitals or in the composition of their letters are one name for some
/// file systems); a text that no symbol of the version holds; a name that is not a plain name of a model file.
class BatchPlan {
 public:
  /// Makes the plan. Cost: some 2 µs per row.
  static BatchPlan make(BatchList list, const BatchRequest& request);

  /// Returns the reasons against carving, in the order of the list, at most `kMostProblems`; empty: everything may be
  /// carved.
  const std::vector<Message>& problems() const { return problems_; }
  static constexpr std::size_t kMostProblems = 20;

  /// Returns the columns that nothing uses; a misspelt setting would be among them.
  const std::vector<std::string>& unusedColumns() const { return unused_; }

  const BatchList& list() const { return list_; }

  /// Returns the names that the texts' template fills in: of columns, and "n" for the row's number.
  const std::vector<std::string>& textNames() const { return text_.names(); }

  /// Returns warnings about what the list's reader had to guess (BatchList), about cells that a spreadsheet has changed
  /// (batch/spreadsheet_traces.h), about empty cells in texts and labels, and about links (qr/link_advice.h).
  const std::vector<Message>& warnings() const { return warnings_; }

  std::size_t size() const { return list_.size(); }
  std::size_t firstNumber() const { return firstNumber_; }

  /// Returns the models that rows name (BatchRow::model), each once, with the first row that names it.
  const std::map<std::string, std::size_t>& models() const { return models_; }
  /// Returns true if a row names no model of its own.
  bool needsModel() const { return needsModel_; }

  /// Returns a row. Call it only if there are no problems.
  /// @param index  from 0
  BatchRow row(std::size_t index) const;

 private:
  /// Advice on the texts of one or more rows.
  struct TextTrace {
    Message message;     ///< of the first
    std::uint32_t line;  ///< of the first
    std::size_t count;
  };
  struct SettingColumn {
    std::size_t column;
    const Setting* setting;
  };

  Status prepare();
  void warnOfSpreadsheets();
  void findModels();
  static void addTrace(std::vector<TextTrace>& traces, Message message, std::uint32_t line);
  void noteEmptyCells(std::size_t index, const BatchRow& row, std::vector<TextTrace>& traces) const;
  void warnOfTexts(const std::vector<TextTrace>& traces);
  Status checkNames(const TextTemplate& pattern) const;
  Result<BatchRow> made(std::size_t index) const;
  std::string valueOf(std::size_t index, std::string_view name) const;
  void checkRows();
  void checkSecondFiles();
  void checkTwice(std::string (*of)(const BatchRow&), Message (*problem)(const BatchRow&, std::uint32_t otherLine));
  void add(std::uint32_t line, Message problem);

  BatchList list_;
  EngraveRequest all_;
  std::size_t firstNumber_ = 1;
  bool hasUsualNames_ = false;  // of the files: "{id}.stl", in colour "{id}.3mf"
  std::optional<std::size_t> idColumn_;
  TextTemplate text_, name_, label_;
  std::vector<SettingColumn> settings_;
  std::vector<std::size_t> filled_;  // columns that go into texts, labels, names and ids
  std::vector<std::string> unused_;
  std::map<std::string, std::size_t> models_;
  bool needsModel_ = true;
  std::vector<Message> problems_, warnings_;
};

/// Returns the reason why a name is not a plain name of a model file in the output folder; none if it is.
std::optional<Message> whyNoPlainName(std::string_view name);

}  // namespace qrelief
