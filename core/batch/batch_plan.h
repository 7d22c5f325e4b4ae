// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/batch_list.h"
#include "batch/text_template.h"
#include "settings/settings.h"

namespace qrelief {

/// What a batch is asked for.
struct BatchRequest {
  /// What all rows have, but for its text, which is a template; empty: the list has a column `text`. A version that it
  /// leaves open becomes the smallest that takes every row's text, so that all codes have one size.
  EngraveRequest all;
  std::string name;             ///< template of the files' names; empty: the list's column `file`, else "{id}.stl"
  std::size_t firstNumber = 1;  ///< of the rows
};

/// One code of a batch.
struct BatchRow {
  std::size_t number = 1;  ///< its place in the list, from BatchRequest::firstNumber on
  std::uint32_t line = 1;  ///< of the list
  std::string id;          ///< the column `id`, else the number
  std::string file;        ///< a plain name, without a folder
  EngraveRequest request;
};

/// Everything that a list asks for, checked as a whole before the first row is carved.
///
/// Columns are `id`, `text`, `file`, keys of settings (an empty cell leaves the setting as all rows have it), and
/// whatever templates name; `{n}` is the row's number. Refused are: a column that a template names and the list lacks;
/// a value that a setting does not take; a text or a name that two rows have (names as file systems without capitals
/// see them); a text that no symbol of the version holds; a name that is more than a plain name of a model file.
class BatchPlan {
 public:
  /// Cost: some 10 µs a row.
  static BatchPlan make(BatchList list, const BatchRequest& request);

  /// Why nothing may be carved, in the order of the list, at most `kMostProblems`; empty: everything may.
  const std::vector<Message>& problems() const { return problems_; }
  static constexpr std::size_t kMostProblems = 20;

  /// Columns that nothing asks for: a misspelt setting would be among them.
  const std::vector<std::string>& unusedColumns() const { return unused_; }

  std::size_t size() const { return list_.size(); }

  /// Only without problems. @param index  from 0
  BatchRow row(std::size_t index) const;

 private:
  struct SettingColumn {
    std::size_t column;
    const Setting* setting;
  };

  Status prepare();
  Status checkNames(const TextTemplate& wanted) const;
  Result<BatchRow> made(std::size_t index) const;
  std::string valueOf(std::size_t index, std::string_view name) const;
  void checkRows();
  void checkTwice(std::string (*of)(const BatchRow&), Message (*problem)(const BatchRow&, std::uint32_t otherLine));
  void add(std::uint32_t line, Message problem);

  BatchList list_;
  EngraveRequest all_;
  std::size_t firstNumber_ = 1;
  TextTemplate text_, name_;
  std::vector<SettingColumn> settings_;
  std::vector<std::string> unused_;
  std::vector<Message> problems_;
};

/// Why a name is not that of a model file in the folder that everything is written to; none: it is.
std::optional<Message> whyNoPlainName(std::string_view name);

}  // namespace qrelief
