// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_list.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <csv.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/parse_json.h"
#include "base/unicode.h"
#include "base/utf8.h"
#include "io/sniff_format.h"
#include "io/text_scanner.h"
#include "message_codes/batch.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Refuses bytes that are no text, such as a spreadsheet.
Status checkIsText(std::string_view text) {
  if (text.empty()) return badInput(message<"list-empty">());
  if (text.starts_with("PK\x03\x04") || text.starts_with("\xD0\xCF\x11\xE0"))
    return badInput(message<"list-spreadsheet">());
  return {};
}

/// Returns true for a web page. A link to a list gives one to those who are not signed in, and some programs save a
/// spreadsheet as one.
/// @param text  without spaces at its start
bool isWebPage(std::string_view text) {
  const std::string start = caseFolded(text.substr(0, 32));
  constexpr std::array<std::string_view, 5> kTags = {"<!doctype html", "<html", "<head", "<meta", "<table"};
  return std::any_of(kTags.begin(), kTags.end(), [&](std::string_view tag) { return start.starts_with(tag); });
}

/// @param line  without its end
Status checkLine(std::string_view line, std::uint32_t number) {
  if (line.size() > kMostLineBytes)
    return badInput(message<"list-line-too-long">(with::index<"line">(number), with::count<"limit">(kMostLineBytes)));
  if (const std::size_t nul = line.find('\0'); nul != line.npos)
    return badInput(message<"list-holds-nul">(with::index<"line">(number), with::index<"byte">(nul + 1)));
  if (const std::size_t broken = firstNoUtf8(line); broken != line.npos)
    return badInput(message<"list-no-utf8">(
        with::index<"line">(number), with::index<"byte">(broken + 1),
        with::term<"value">(fmt::format("0x{:02X}", static_cast<unsigned char>(line[broken])))));
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

/// Returns a name without the characters at its ends that nobody sees.
std::string trimmedName(std::string_view name) {
  std::u32string characters = charactersOf(name);
  const auto showsNothing = [](char32_t c) { return isSpace(c) || isUnseen(c); };
  while (!characters.empty() && showsNothing(characters.back())) characters.pop_back();
  const auto begin = std::find_if_not(characters.begin(), characters.end(), showsNothing);
  std::string trimmed;
  for (auto it = begin; it != characters.end(); ++it) appendUtf8(trimmed, *it);
  return trimmed;
}

Message tooManyColumns() { return message<"list-too-many-columns">(with::count<"limit">(kMostColumns)); }

Status checkColumns(std::span<const std::string> columns) {
  if (columns.size() > kMostColumns) return badInput(tooManyColumns());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto isSame = [&](const std::string& other) { return caseFolded(other) == caseFolded(columns[i]); };
    if (std::any_of(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(i), isSame))
      return badInput(message<"list-column-twice">(with::quoted<"name">(columns[i])));
  }
  return {};
}

/// Returns the separator that the first line names for Excel, as sep=; with or without quotation marks; none if it is a
/// row.
std::optional<char> namedSeparator(std::string_view line) {
  if (line.size() > 2 && line.starts_with('"') && line.ends_with('"')) line = line.substr(1, line.size() - 2);
  constexpr std::string_view kStart = "sep=";
  if (line.size() <= kStart.size() || caseFolded(line.substr(0, kStart.size())) != kStart) return std::nullopt;
  const char separator = line[kStart.size()];
  constexpr std::string_view kPossible = ",;\t|:";
  const bool isAlone = line.find_first_not_of(separator, kStart.size()) == line.npos;
  return isAlone && kPossible.find(separator) != kPossible.npos ? std::optional(separator) : std::nullopt;
}

/// Returns the separator that occurs most often in the first line, outside quotes.
char separatorOf(std::string_view line) {
  constexpr std::array kSeparators = {',', ';', '\t', '|'};
  std::array<int, kSeparators.size()> counts{};
  bool isQuoted = false;
  for (const char c : line) {
    if (c == '"') isQuoted = !isQuoted;
    for (std::size_t i = 0; i < kSeparators.size(); ++i) counts[i] += !isQuoted && c == kSeparators[i];
  }
  return kSeparators[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

/// Returns true for a text that begins like a link: a scheme, then "://".
bool isLink(std::string_view text) {
  const std::size_t end = text.find("://");
  const auto isOfScheme = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '+' || c == '-' ||
           c == '.';
  };
  return end != text.npos && end > 0 &&
         std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), isOfScheme);
}

/// Converts a CSV text from Windows-1252 to UTF-8. Returns none if a byte has no meaning there, or if the text holds a
/// character of UTF-8 beyond ASCII: it is then damaged UTF-8.
std::optional<std::string> fromWindows1252(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8SequenceLength(text.substr(i));
    if (length > 1) return std::nullopt;
    ++i;
  }
  return text.find('\0') == text.npos ? utf8FromWindows1252(text) : std::nullopt;
}

/// Says that a list was read as Windows-1252, and shows the first line where that matters. @param text  as UTF-8
Message readAsWindows1252(std::string_view text) {
  constexpr std::size_t kMostShown = 60;  // characters
  for (std::uint32_t number = 1; !text.empty(); ++number) {
    const std::string_view whole = firstLine(text), line = withoutEnd(whole);
    text.remove_prefix(whole.size());
    if (std::all_of(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; })) continue;
    std::string shown;
    for (const char32_t c : charactersOf(line).substr(0, kMostShown)) appendUtf8(shown, c);
    return message<"list-windows-1252">(with::index<"line">(number), with::quoted<"text">(shown));
  }
  assert(false);  // a text in ASCII is valid UTF-8
  return message<"list-empty">();
}

class CsvReader {
 public:
  explicit CsvReader(std::optional<bool> hasNames) : hasNames_(hasNames) {
    csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI);
  }
  ~CsvReader() { csv_free(&parser_); }
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  Result<BatchList> read(std::string_view text) {
    const auto named = namedSeparator(withoutEnd(firstLine(text)));
    if (named) text.remove_prefix(firstLine(text).size());
    csv_set_delim(&parser_, static_cast<unsigned char>(named ? *named : separatorOf(firstLine(text))));
    for (std::uint32_t line = named ? 2 : 1; !text.empty(); ++line) {
      const std::string_view whole = firstLine(text);
      QRELIEF_TRY(checkLine(withoutEnd(whole), line));
      if (parser_.pstate == kBetweenRows) {
        rowLine_ = line;
        if (holdsSpacesOnly(withoutEnd(whole)) && blanks_++ == 0) firstBlank_ = line;
      }
      const std::size_t taken = csv_parse(&parser_, whole.data(), whole.size(), &takeCell, &takeRow, this);
      if (problem_) return badInput(std::move(*problem_));
      if (taken < whole.size())
        return badInput(message<"list-quote">(with::index<"line">(line), with::index<"byte">(taken + 1)));
      if (parser_.entry_pos > kMostCellBytes)
        return badInput(cellTooLong(parser_.entry_pos));  // a quotation that does
                                                          // not end
      text.remove_prefix(whole.size());
    }
    if (csv_fini(&parser_, &takeCell, &takeRow, this) != 0)
      return badInput(message<"list-quote-open">(with::index<"line">(rowLine_)));
    if (problem_) return badInput(std::move(*problem_));
    warnOfBlanks();
    return std::move(list_);
  }

 private:
  static constexpr int kBetweenRows = 0;  // ROW_NOT_BEGUN in libcsv's source

  /// Returns true for a line of spaces and tabs. libcsv takes it for an empty line, unless a tab separates cells.
  bool holdsSpacesOnly(std::string_view line) const {
    const std::string_view spaces = parser_.delim_char == '\t' ? " " : " \t";
    return !line.empty() && line.find_first_not_of(spaces) == line.npos;
  }

  void warnOfBlanks() {
    if (blanks_ == 0) return;
    Message blank = message<"row-of-spaces">();
    if (blanks_ == 1)
      list_.warn(message<"list-line">(with::index<"line">(firstBlank_), with::cause<"problem">(std::move(blank))));
    else
      list_.warn(message<"list-lines">(with::index<"line">(firstBlank_), with::count<"count">(blanks_ - 1),
                                       with::cause<"problem">(std::move(blank))));
  }

  static void takeCell(void* bytes, std::size_t size, void* self) {
    static_cast<CsvReader*>(self)->addCell({static_cast<const char*>(bytes), size});
  }
  static void takeRow(int, void* self) { static_cast<CsvReader*>(self)->endRow(); }

  void addCell(std::string_view cell) {
    if (problem_) return;
    if (cell.size() > kMostCellBytes)
      problem_ = cellTooLong(cell.size());
    else if (cell.starts_with('='))
      problem_ = message<"list-cell-formula">(with::index<"line">(rowLine_), with::index<"column">(cells_.size() + 1));
    cells_.emplace_back(problem_ ? std::string_view() : cell);
  }

  Message cellTooLong(std::size_t bytes) const {
    return message<"list-cell-too-long">(with::index<"line">(rowLine_), with::index<"column">(cells_.size() + 1),
                                         with::count<"count">(bytes), with::count<"limit">(kMostCellBytes));
  }

  void endRow() {
    const bool isEmpty = std::all_of(cells_.begin(), cells_.end(), [](const std::string& c) { return c.empty(); });
    // libcsv skips empty lines. So in a list of one column an empty cell was written as "".
    const bool isQuoted = cells_.size() == 1 && columnCount_ == 1;
    if (!problem_ && (!isEmpty || isQuoted)) take();
    cells_.clear();
  }

  void take() {
    if (named_.empty()) {
      const auto link = std::find_if(cells_.begin(), cells_.end(), isLink);
      if (hasNames_.value_or(link == cells_.end())) return takeNames();
      nameColumns(static_cast<std::size_t>(link - cells_.begin()));
    }
    takeCells();
  }

  /// Names the columns of a table whose first row is a row like the others.
  /// @param texts  name of the column with the texts; a table with one column needs no such name
  void nameColumns(std::size_t texts) {
    while (cells_.back().empty()) cells_.pop_back();
    columnCount_ = cells_.size();
    if (columnCount_ == 1) texts = 0;
    std::vector<std::string> names;
    std::string all;
    for (std::size_t i = 0; i < columnCount_; ++i) {
      names.push_back(i == texts ? "text" : "column" + std::to_string(i + 1));
      named_.push_back(i);
      all += (all.empty() ? "" : ", ") + names.back();
    }
    if (const Status good = checkColumns(names); !good) problem_ = good.error().message;
    list_ = BatchList(std::move(names));
    if (!hasNames_)
      list_.warn(message<"list-without-names">(with::quoted<"first">(cells_[texts]), with::quoted<"columns">(all)));
  }

  /// Takes the columns' names. Spreadsheets write columns that are empty but were touched; these have no name.
  void takeNames() {
    std::vector<std::string> names;
    columnCount_ = cells_.size();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      std::string name = trimmedName(cells_[i]);
      if (name.empty()) continue;
      names.push_back(std::move(name));
      named_.push_back(i);
    }
    if (const Status good = checkColumns(names); !good) problem_ = good.error().message;
    list_ = BatchList(std::move(names));
  }

  void takeCells() {
    while (cells_.size() > columnCount_ && cells_.back().empty()) cells_.pop_back();
    if (cells_.size() > columnCount_ || cells_.size() <= named_.back()) return refuseLength();
    std::vector<std::string> named;
    for (const std::size_t i : named_) named.push_back(std::move(cells_[i]));
    for (std::size_t i = 0, next = 0; i < cells_.size(); ++i) {
      if (next < named_.size() && i == named_[next])
        ++next;
      else if (!cells_[i].empty())
        problem_ = message<"list-column-unnamed">(with::index<"line">(rowLine_), with::index<"column">(i + 1));
    }
    list_.addRow(rowLine_, named);
  }

  void refuseLength() {
    problem_ = message<"list-row-length">(with::index<"line">(rowLine_), with::count<"count">(cells_.size()),
                                          with::count<"columns">(columnCount_));
  }

  std::optional<bool> hasNames_;
  csv_parser parser_{};
  BatchList list_;
  std::vector<std::size_t> named_;  // places of the columns with names
  std::size_t columnCount_ = 0;     // with those without names
  std::vector<std::string> cells_;
  std::uint32_t rowLine_ = 1;
  std::uint32_t blanks_ = 0, firstBlank_ = 0;  // lines of spaces
  std::optional<Message> problem_;
};

Result<BatchList> readCsv(std::string_view text, std::optional<bool> hasNames) {
  std::optional<std::string> decoded;
  if (firstNoUtf8(text) != text.npos) decoded = fromWindows1252(text);
  auto list = CsvReader(hasNames).read(decoded ? *decoded : text);
  if (list && decoded) list->warn(readAsWindows1252(*decoded));
  return list;
}

/// Converts a value to the form in which a person types a setting; none if it has no such form.
std::optional<std::string> cellOf(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_binary()) return numberText(value);
  if (!value.is_array()) return std::nullopt;
  std::string list;
  for (const Json& part : value) {
    if (!part.is_binary()) return std::nullopt;
    list += (list.empty() ? "" : ",") + numberText(part);
  }
  return list;
}

/// Rows of JSON objects, whose keys are the columns.
class JsonRows {
 public:
  /// @param line  in which the object begins
  Status add(std::string_view object, std::uint32_t line) {
    const Result<Json> parsed = parseJson(object, JsonNumbers::AsWritten);
    if (!parsed && parsed.error().message.code != "json-malformed")
      return badInput(message<"list-line">(with::index<"line">(line), with::cause<"problem">(parsed.error().message)));
    if (!parsed || !parsed->is_object()) return badInput(message<"list-no-object">(with::index<"line">(line)));
    auto& cells = rows_.emplace_back(line, std::vector<std::string>(columns_.size())).second;
    for (const auto& [key, value] : parsed->items()) {
      const auto at = static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), key) - columns_.begin());
      if (at == kMostColumns) return badInput(tooManyColumns());
      if (key.empty()) return badInput(message<"list-name-empty">(with::index<"line">(line)));
      if (at == columns_.size()) columns_.push_back(key), cells.emplace_back();
      const auto cell = cellOf(value);
      if (!cell) return badInput(message<"list-value-kind">(with::index<"line">(line), with::quoted<"name">(key)));
      if (cell->size() > kMostCellBytes)
        return badInput(message<"list-cell-too-long">(with::index<"line">(line), with::index<"column">(at + 1),
                                                      with::count<"count">(cell->size()),
                                                      with::count<"limit">(kMostCellBytes)));
      cells[at] = *cell;
    }
    return {};
  }

  Result<BatchList> list() && {
    QRELIEF_TRY(checkColumns(columns_));
    BatchList list(columns_);
    for (auto& [line, cells] : rows_) {
      cells.resize(columns_.size());
      list.addRow(line, cells);
    }
    return list;
  }

 private:
  std::vector<std::string> columns_;
  std::vector<std::pair<std::uint32_t, std::vector<std::string>>> rows_;
};

/// Returns the length of the value at the start of a JSON text: with its brackets or quotation marks, or else up to the
/// next space, comma or bracket.
std::size_t jsonValueLength(std::string_view text) {
  std::size_t depth = 0;
  bool isQuoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (isQuoted && c == '\\') {
      ++i;
      continue;
    }
    const bool isEnd = c == '}' || c == ']';
    if (!isQuoted && depth == 0 && i > 0 && (isEnd || std::string_view(", \t\r\n").find(c) != std::string_view::npos))
      return i;
    if (c == '"') isQuoted = !isQuoted;
    if (!isQuoted && (c == '{' || c == '[')) ++depth;
    if (!isQuoted && isEnd && depth > 0 && --depth == 0) return i + 1;
  }
  return text.size();
}

/// Reads objects, as programs write lists: each on its own line or lines, with or without commas between them, or all
/// in an array. @param text  from a brace or bracket on, spaces before it apart
Result<BatchList> readJsonObjects(std::string_view text) {
  std::uint32_t line = 1;
  std::string_view left = text;
  for (std::uint32_t number = 1; !left.empty(); ++number) {
    const std::string_view whole = firstLine(left);
    left.remove_prefix(whole.size());
    QRELIEF_TRY(checkLine(withoutEnd(whole), number));
  }
  const auto skip = [&](std::size_t count) {
    for (std::string_view skipped = text.substr(0, count); !skipped.empty();) {
      const std::string_view whole = firstLine(skipped);
      line += withoutEnd(whole).size() < whole.size();
      skipped.remove_prefix(whole.size());
    }
    text.remove_prefix(count);
  };
  const auto skipSpace = [&] { skip(std::min(text.find_first_not_of(" \t\r\n"), text.size())); };
  const auto broken = [&] { return badInput(message<"list-array">(with::index<"line">(line))); };
  JsonRows rows;
  skipSpace();
  const bool isArray = text.starts_with('[');
  if (isArray) skip(1);
  for (skipSpace(); !text.empty() && !(isArray && text.starts_with(']')); skipSpace()) {
    const std::size_t length = jsonValueLength(text);
    QRELIEF_TRY(rows.add(text.substr(0, length), line));
    skip(length);
    skipSpace();
    if (text.starts_with(',')) skip(1);
  }
  if (isArray && text.empty()) return broken();
  if (isArray) skip(1);
  skipSpace();
  if (!text.empty()) return broken();
  return std::move(rows).list();
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
  auto it = std::find(columns_.begin(), columns_.end(), column);
  if (it == columns_.end())
    it = std::find_if(columns_.begin(), columns_.end(),
                      [&](const std::string& name) { return caseFolded(name) == caseFolded(column); });
  if (it == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(it - columns_.begin());
}

std::string_view BatchList::cell(std::size_t row, std::size_t column) const {
  const std::size_t index = row * columns_.size() + column;
  const std::size_t begin = index == 0 ? 0 : ends_[index - 1];
  return std::string_view(cells_).substr(begin, ends_[index] - begin);
}

Result<BatchList> readBatchList(std::span<const std::uint8_t> bytes, const BatchListOptions& options) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::optional<std::string> narrow;
  if (const std::string_view wide = wideEncodingOf(bytes); !wide.empty()) {
    narrow = utf8FromUtf16(bytes, wide.ends_with("BE"));
    if (!narrow) return badInput(message<"list-encoding">(with::term<"encoding">(wide)));
    text = *narrow;
  }
  text = withoutPadding(text);
  QRELIEF_TRY(checkIsText(text));
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const char start = first == text.npos ? '\0' : text[first];
  if (start == '<' && isWebPage(text.substr(first))) return badInput(message<"list-web-page">());
  auto list = start == '{' || start == '[' ? readJsonObjects(text) : readCsv(text, options.hasNames);
  if (list && list->size() == 0) return badInput(message<"list-no-rows">());
  return list;
}

BatchList countedBatchList(std::size_t rows) {
  BatchList list;
  for (std::size_t i = 0; i < rows; ++i) list.addRow(static_cast<std::uint32_t>(i + 1), {});
  return list;
}

}  // namespace qrelief
