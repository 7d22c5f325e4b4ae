// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/spreadsheet_traces.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/unicode.h"
#include "message_codes/batch.h"

namespace qrelief {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isNumber(std::string_view text) { return !text.empty() && std::all_of(text.begin(), text.end(), isDigit); }

std::size_t digitsAt(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && isDigit(text[end])) ++end;
  return end - begin;
}

/// Returns true for 9.52112E+12. The sign of the exponent tells it from a part number such as 12E5.
bool isScientific(std::string_view value) {
  std::size_t i = value.starts_with('-') ? 1 : 0;
  const std::size_t whole = digitsAt(value, i);
  if (whole != 1) return false;
  i += whole;
  if (i < value.size() && (value[i] == '.' || value[i] == ',')) i += 1 + digitsAt(value, i + 1);
  if (i + 2 >= value.size() || (value[i] != 'E' && value[i] != 'e')) return false;
  if (value[i + 1] != '+' && value[i + 1] != '-') return false;
  return isNumber(value.substr(i + 2));
}

/// Returns true for a whole number with zeros after its 15th digit, where spreadsheets stop counting.
bool isRounded(std::string_view value) {
  constexpr std::size_t kKept = 15;
  return value.size() > kKept && isNumber(value) && value.find_first_not_of('0', kKept) == value.npos &&
         value.find_first_not_of('0') != value.npos;
}

/// Returns true for 1001.0, as programs write a whole number from a column of decimal numbers.
bool isDecimalWhole(std::string_view value) {
  return (value.ends_with(".0") || value.ends_with(",0")) && isNumber(value.substr(0, value.size() - 2));
}

/// Returns true for a day and a month's name, such as 02-Mar, 2. Mrz or Sep-07.
bool isDate(std::string_view value) {
  constexpr std::array<std::string_view, 22> kMonths = {"jan", "feb", "mar", "mär", "mrz",  "apr", "may", "mai",
                                                        "jun", "jul", "aug", "sep", "sept", "oct", "okt", "nov",
                                                        "dec", "dez", "fév", "avr", "aoû",  "déc"};
  const std::string text = caseFolded(value);
  const auto isMonth = [&](std::string_view word) {
    if (word.ends_with('.')) word.remove_suffix(1);
    return std::find(kMonths.begin(), kMonths.end(), word) != kMonths.end();
  };
  constexpr std::string_view kBetween = "-. /";
  const std::string_view whole = text;
  const std::size_t separator = whole.find_first_of(kBetween);
  if (separator == whole.npos || separator == 0) return false;
  const std::size_t next = whole.find_first_not_of(kBetween, separator);
  if (next == whole.npos) return false;
  const std::string_view first = whole.substr(0, separator), second = whole.substr(next);
  const auto isDayOrYear = [](std::string_view word) { return isNumber(word) && word.size() <= 2; };
  return (isDayOrYear(first) && isMonth(second)) || (isMonth(first) && isDayOrYear(second));
}

/// Returns true for what a spreadsheet shows in place of a value, in English or German.
bool isErrorValue(std::string_view value) {
  constexpr std::array<std::string_view, 16> kErrors = {
      "#N/A",  "#NV",    "#REF!",  "#BEZUG!", "#VALUE!", "#WERT!",  "#DIV/0!",   "#NAME?",
      "#NUM!", "#ZAHL!", "#NULL!", "#SPILL!", "#CALC!",  "#FIELD!", "#BLOCKED!", "#UNKNOWN!"};
  const bool isTooNarrow = value.size() >= 5 && value.find_first_not_of('#') == value.npos;
  return isTooNarrow || std::find(kErrors.begin(), kErrors.end(), value) != kErrors.end();
}

}  // namespace

std::optional<Message> spreadsheetTrace(std::string_view value, std::string_view column, std::size_t line) {
  if (isErrorValue(value))
    return message<"cell-error">(with::index<"line">(line), with::quoted<"name">(column), with::term<"value">(value));
  if (isScientific(value))
    return message<"cell-scientific">(with::index<"line">(line), with::quoted<"name">(column),
                                      with::term<"value">(value));
  if (isRounded(value))
    return message<"cell-rounded">(with::index<"line">(line), with::quoted<"name">(column), with::term<"value">(value));
  if (isDecimalWhole(value))
    return message<"cell-decimal">(with::index<"line">(line), with::quoted<"name">(column), with::term<"value">(value));
  if (isDate(value))
    return message<"cell-date">(with::index<"line">(line), with::quoted<"name">(column), with::term<"value">(value));
  return std::nullopt;
}

std::optional<Message> lostZeros(const BatchList& list, std::size_t column) {
  constexpr std::size_t kLeastLength = 5, kLeastRows = 3;
  std::size_t length = 0, rows = 0;
  for (std::size_t row = 0; row < list.size(); ++row) {
    const std::string_view cell = list.cell(row, column);
    if (cell.empty()) continue;
    if (!isNumber(cell) || cell.starts_with('0')) return std::nullopt;
    length = std::max(length, cell.size());
    ++rows;
  }
  if (rows < kLeastRows || length < kLeastLength) return std::nullopt;
  std::size_t whole = 0;
  std::optional<std::size_t> shorter;
  for (std::size_t row = 0; row < list.size(); ++row) {
    const std::size_t size = list.cell(row, column).size();
    whole += size == length;
    if (whole > 0 && size > 0 && size < length && !shorter) shorter = row;
  }
  const bool areMostWhole = 3 * whole >= 2 * rows;
  if (!shorter || !areMostWhole) return std::nullopt;
  return message<"cell-zeros-lost">(with::index<"line">(list.line(*shorter)),
                                    with::quoted<"name">(list.columns()[column]),
                                    with::term<"value">(list.cell(*shorter, column)), with::count<"digits">(length));
}

}  // namespace qrelief
