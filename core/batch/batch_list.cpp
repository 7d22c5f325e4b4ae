// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_list.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <csv.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/parse_json.h"
#include "base/utf8.h"
#include "io/sniff_format.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Refuses bytes that are not plain text, such as UTF-16 or a spreadsheet.
Status checkIsText(std::span<const std::uint8_t> bytes, std::string_view text) {
  if (text.empty()) return badInput(message("list-empty"));
  if (const std::string_view wide = wideEncodingOf(bytes); !wide.empty())
    return badInput(message("list-encoding", with::term<"encoding">(wide)));
  if (text.starts_with("PK\x03\x04") || text.starts_with("\xD0\xCF\x11\xE0"))
    return badInput(message("list-spreadsheet"));
  return {};
}

/// @param line  without its end
Status checkLine(std::string_view line, std::uint32_t number) {
  if (line.size() > kMostLineBytes)
    return badInput(message("list-line-too-long", with::count<"line">(number), with::count<"limit">(kMostLineBytes)));
  if (const std::size_t nul = line.find('\0'); nul != line.npos)
    return badInput(message("list-holds-nul", with::count<"line">(number), with::count<"byte">(nul + 1)));
  if (const std::size_t broken = firstNoUtf8(line); broken != line.npos)
    return badInput(message("list-no-utf8", with::count<"line">(number), with::count<"byte">(broken + 1)));
  return {};
}

/// Returns the first line of a text, with its end: LF, CR LF or CR.
std::string_view firstLine(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == text.npos) return text;
  return text.substr(0, text.substr(end).starts_with("\r\n") ? end + 2 : end + 1);
}

std::string_view withoutEnd(std::string_view line) {
  while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

Message tooManyColumns() { return message("list-too-many-columns", with::count<"limit">(kMostColumns)); }

Status checkColumns(std::span<const std::string> columns) {
  if (columns.size() > kMostColumns) return badInput(tooManyColumns());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].empty()) return badInput(message("list-column-unnamed", with::count<"column">(i + 1)));
    if (std::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(i), columns[i]) !=
        columns.begin() + static_cast<std::ptrdiff_t>(i))
      return badInput(message("list-column-twice", with::quoted<"name">(columns[i])));
  }
  return {};
}

/// Returns the separator that occurs most often in the first line, outside quotes.
char separatorOf(std::string_view line) {
  constexpr std::array kSeparators = {',', ';', '\t'};
  std::array<int, 3> counts{};
  bool isQuoted = false;
  for (const char c : line) {
    if (c == '"') isQuoted = !isQuoted;
    for (std::size_t i = 0; i < kSeparators.size(); ++i) counts[i] += !isQuoted && c == kSeparators[i];
  }
  return kSeparators[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

class CsvReader {
 public:
  CsvReader() { csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI); }
  ~CsvReader() { csv_free(&parser_); }
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  Result<BatchList> read(std::string_view text) {
    csv_set_delim(&parser_, static_cast<unsigned char>(separatorOf(firstLine(text))));
    for (std::uint32_t line = 1; !text.empty(); ++line) {
      const std::string_view whole = firstLine(text);
      if (const Status good = checkLine(withoutEnd(whole), line); !good) return tl::unexpected(good.error());
      if (parser_.pstate == kBetweenRows) rowLine_ = line;
      const std::size_t taken = csv_parse(&parser_, whole.data(), whole.size(), &takeCell, &takeRow, this);
      if (problem_) return badInput(std::move(*problem_));
      if (taken < whole.size())
        return badInput(message("list-quote", with::count<"line">(line), with::count<"byte">(taken + 1)));
      if (parser_.entry_pos > kMostCellBytes)
        return badInput(cellTooLong(parser_.entry_pos));  // a quotation that does
                                                          // not end
      text.remove_prefix(whole.size());
    }
    if (csv_fini(&parser_, &takeCell, &takeRow, this) != 0)
      return badInput(message("list-quote-open", with::count<"line">(rowLine_)));
    if (problem_) return badInput(std::move(*problem_));
    return std::move(list_);
  }

 private:
  static constexpr int kBetweenRows = 0;  // ROW_NOT_BEGUN in libcsv's source

  static void takeCell(void* bytes, std::size_t size, void* self) {
    static_cast<CsvReader*>(self)->addCell({static_cast<const char*>(bytes), size});
  }
  static void takeRow(int, void* self) { static_cast<CsvReader*>(self)->endRow(); }

  void addCell(std::string_view cell) {
    if (problem_) return;
    if (cell.size() > kMostCellBytes)
      problem_ = cellTooLong(cell.size());
    else if (cell.starts_with('='))
      problem_ = message("list-cell-formula", with::count<"line">(rowLine_), with::count<"column">(cells_.size() + 1));
    cells_.emplace_back(problem_ ? std::string_view() : cell);
  }

  Message cellTooLong(std::size_t bytes) const {
    return message("list-cell-too-long", with::count<"line">(rowLine_), with::count<"column">(cells_.size() + 1),
                   with::count<"count">(bytes), with::count<"limit">(kMostCellBytes));
  }

  void endRow() {
    const bool isEmpty = std::all_of(cells_.begin(), cells_.end(), [](const std::string& c) { return c.empty(); });
    if (!problem_ && !isEmpty) take();
    cells_.clear();
  }

  void take() {
    if (list_.columns().empty()) {
      if (const Status good = checkColumns(cells_); !good) problem_ = good.error().message;
      list_ = BatchList(cells_);
      return;
    }
    if (cells_.size() != list_.columns().size())
      problem_ = message("list-row-length", with::count<"line">(rowLine_), with::count<"count">(cells_.size()),
                         with::count<"columns">(list_.columns().size()));
    else
      list_.addRow(rowLine_, cells_);
  }

  csv_parser parser_{};
  BatchList list_;
  std::vector<std::string> cells_;
  std::uint32_t rowLine_ = 1;
  std::optional<Message> problem_;
};

/// Converts a value to the form in which a person types a setting; none if it has no such form.
std::optional<std::string> cellOf(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_number()) return value.dump();
  if (!value.is_array()) return std::nullopt;
  std::string list;
  for (const Json& part : value) {
    if (!part.is_number()) return std::nullopt;
    list += (list.empty() ? "" : ",") + part.dump();
  }
  return list;
}

Result<BatchList> readJsonLines(std::string_view text) {
  std::vector<std::string> columns;
  std::vector<std::pair<std::uint32_t, std::vector<std::string>>> rows;
  for (std::uint32_t number = 1; !text.empty(); ++number) {
    const std::string_view whole = firstLine(text), line = withoutEnd(whole);
    text.remove_prefix(whole.size());
    if (const Status good = checkLine(line, number); !good) return tl::unexpected(good.error());
    if (line.find_first_not_of(" \t") == line.npos) continue;
    const Result<Json> parsed = parseJson(line);
    if (!parsed && parsed.error().message.code != "json-malformed")
      return badInput(
          message("list-line", with::count<"line">(number), with::cause<"problem">(parsed.error().message)));
    if (!parsed || !parsed->is_object()) return badInput(message("list-no-object", with::count<"line">(number)));
    auto& cells = rows.emplace_back(number, std::vector<std::string>(columns.size())).second;
    for (const auto& [key, value] : parsed->items()) {
      const auto at = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), key) - columns.begin());
      if (at == kMostColumns) return badInput(tooManyColumns());
      if (at == columns.size()) columns.push_back(key), cells.emplace_back();
      const auto cell = cellOf(value);
      if (!cell) return badInput(message("list-value-kind", with::count<"line">(number), with::quoted<"name">(key)));
      if (cell->size() > kMostCellBytes)
        return badInput(message("list-cell-too-long", with::count<"line">(number), with::count<"column">(at + 1),
                                with::count<"count">(cell->size()), with::count<"limit">(kMostCellBytes)));
      cells[at] = *cell;
    }
  }
  if (const Status good = checkColumns(columns); !good) return tl::unexpected(good.error());
  BatchList list(columns);
  for (auto& [line, cells] : rows) {
    cells.resize(columns.size());
    list.addRow(line, cells);
  }
  return list;
}

}  // namespace

void BatchList::addRow(std::uint32_t line, std::span<const std::string> cells) {
  assert(cells.size() == columns_.size());
  for (const std::string& cell : cells) {
    cells_ += cell;
    ends_.push_back(cells_.size());
  }
  lines_.push_back(line);
}

std::optional<std::size_t> BatchList::find(std::string_view column) const {
  const auto it = std::find(columns_.begin(), columns_.end(), column);
  if (it == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(it - columns_.begin());
}

std::string_view BatchList::cell(std::size_t row, std::size_t column) const {
  const std::size_t index = row * columns_.size() + column;
  const std::size_t begin = index == 0 ? 0 : ends_[index - 1];
  return std::string_view(cells_).substr(begin, ends_[index] - begin);
}

Result<BatchList> readBatchList(std::span<const std::uint8_t> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (const Status good = checkIsText(bytes, text); !good) return tl::unexpected(good.error());
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  auto list = first != text.npos && text[first] == '{' ? readJsonLines(text) : CsvReader().read(text);
  if (list && list->size() == 0) return badInput(message("list-no-rows"));
  return list;
}

BatchList countedBatchList(std::size_t rows) {
  BatchList list;
  for (std::size_t i = 0; i < rows; ++i) list.addRow(static_cast<std::uint32_t>(i + 1), {});
  return list;
}

}  // namespace qrelief
