// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_plan.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <set>

#include "base/unicode.h"
#include "batch/spreadsheet_traces.h"
#include "delivery/carved_objects.h"
#include "io/sniff_format.h"
#include "io/write_files.h"
#include "message_codes/batch.h"
#include "pipeline/requested_symbol.h"
#include "qr/link_advice.h"
#include "settings/setting_text.h"

namespace qrelief {
namespace {

constexpr std::string_view kId = "id", kText = "text", kFile = "file", kNumber = "n", kModel = "model";
constexpr std::size_t kMostNameBytes = 200;  // file systems allow 255, and our names may get a suffix

/// Returns the setting that a column sets. Capitals do not count.
const Setting* settingOfColumn(std::string_view column) {
  if (const Setting* setting = findSetting(column)) return setting;
  for (const Setting& setting : settings())
    if (caseFolded(setting.key) == caseFolded(column)) return &setting;
  return nullptr;
}

/// Returns the name of the column whose texts become the codes: `text`, or else `url` or `link`.
std::string_view textColumn(const BatchList& list) {
  constexpr std::array<std::string_view, 3> kNames = {kText, "url", "link"};
  const auto known = std::find_if(kNames.begin(), kNames.end(), [&](std::string_view name) { return list.find(name); });
  return known == kNames.end() ? kText : *known;
}

/// Returns true for names that Windows reserves for devices, whatever their extension.
bool isDeviceName(std::string_view name) {
  std::string stem = caseFolded(name.substr(0, name.find('.')));
  while (stem.ends_with(' ')) stem.pop_back();
  if (stem.starts_with("com") || stem.starts_with("lpt")) {
    const std::string_view number = std::string_view(stem).substr(3);
    return (number.size() == 1 && number[0] >= '0' && number[0] <= '9') || number == "\u00B9" || number == "\u00B2" ||
           number == "\u00B3";
  }
  constexpr std::array<std::string_view, 6> kDevices = {"con", "prn", "aux", "nul", "conin$", "conout$"};
  return std::find(kDevices.begin(), kDevices.end(), stem) != kDevices.end();
}

}  // namespace

std::vector<std::string> BatchRow::files() const {
  return fileNames(file, request.marking.isInColour() || request.marking.isOpen);
}

std::optional<Message> whyNoPlainName(std::string_view name) {
  if (name.empty()) return message<"name-empty">();
  const bool hasControls = std::any_of(name.begin(), name.end(), [](char c) { return c >= 0 && c < ' '; });
  if (hasControls || name.find_first_of("/\\<>:\"|?*\x7f") != name.npos || name.starts_with('.') || isDeviceName(name))
    return message<"name-no-plain-name">(with::quoted<"name">(name));
  if (name.size() > kMostNameBytes)
    return message<"name-too-long">(with::count<"count">(name.size()), with::count<"limit">(kMostNameBytes));
  if (!isWritable(formatOfName(name))) return message<"name-not-writable">(with::quoted<"name">(name));
  return std::nullopt;
}

BatchPlan BatchPlan::make(BatchList list, const BatchRequest& request) {
  BatchPlan plan;
  plan.list_ = std::move(list);
  plan.all_ = request.all;
  plan.firstNumber_ = request.firstNumber;
  plan.idColumn_ = plan.list_.find(request.idColumn);
  plan.warnings_ = plan.list_.warnings();
  const std::string text =
      request.all.code.text.empty() ? "{" + std::string(textColumn(plan.list_)) + "}" : request.all.code.text;
  const bool hasFile = plan.list_.find(kFile).has_value();
  plan.hasUsualNames_ = request.name.empty() && !hasFile;
  const std::string name = plan.hasUsualNames_ ? "{id}.stl" : request.name.empty() ? "{file}" : request.name;
  const auto textTemplate = TextTemplate::parse(text), nameTemplate = TextTemplate::parse(name),
             labelTemplate = TextTemplate::parse(request.all.code.label.text);
  for (const auto* parsed : {&textTemplate, &nameTemplate, &labelTemplate})
    if (!*parsed) plan.problems_.push_back(parsed->error().message);
  if (!plan.problems_.empty()) return plan;
  plan.text_ = *textTemplate;
  plan.name_ = *nameTemplate;
  plan.label_ = *labelTemplate;
  if (const Status prepared = plan.prepare(); !prepared)
    plan.problems_.push_back(prepared.error().message);
  else
    plan.checkRows();
  return plan;
}

/// Finds the use of each column.
Status BatchPlan::prepare() {
  for (const TextTemplate* text : {&text_, &name_, &label_}) QRELIEF_TRY(checkNames(*text));
  const std::vector<std::string>& columns = list_.columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto names = [&](const TextTemplate& in) {
      return std::any_of(in.names().begin(), in.names().end(),
                         [&](const std::string& name) { return list_.find(name) == i; });
    };
    const bool isNamed = names(text_) || names(name_) || names(label_);
    const Setting* setting = settingOfColumn(columns[i]);
    if (setting && setting->key == kText) setting = nullptr;
    if (setting) settings_.push_back({i, setting});
    const bool isId = idColumn_ == i;
    if (isNamed || isId) filled_.push_back(i);
    if (isNamed || setting || isId || list_.find(kModel) == i) continue;
    unused_.push_back(columns[i]);
  }
  warnOfSpreadsheets();
  findModels();
  return {};
}

void BatchPlan::findModels() {
  const auto column = list_.find(kModel);
  if (!column) return;
  needsModel_ = false;
  for (std::size_t row = 0; row < size(); ++row) {
    const std::string_view model = list_.cell(row, *column);
    if (model.empty())
      needsModel_ = true;
    else
      models_.try_emplace(std::string(model), row);
  }
}

/// Adds one warning of each kind for each column that goes into texts and names.
void BatchPlan::warnOfSpreadsheets() {
  for (const std::size_t column : filled_) {
    const std::string& name = list_.columns()[column];
    std::set<std::string> kinds;
    for (std::size_t row = 0; row < size(); ++row)
      if (auto trace = spreadsheetTrace(list_.cell(row, column), name, list_.line(row)))
        if (kinds.insert(trace->code).second)
          (trace->code == "cell-error" ? problems_ : warnings_).push_back(std::move(*trace));
    if (auto lost = lostZeros(list_, column)) warnings_.push_back(std::move(*lost));
  }
}

Status BatchPlan::checkNames(const TextTemplate& pattern) const {
  for (const std::string& name : pattern.names()) {
    if (name == kNumber || name == kId || list_.find(name)) continue;
    if (list_.columns().empty()) return badInput(message<"template-without-list">(with::quoted<"name">(name)));
    std::string columns;
    for (const std::string& column : list_.columns()) columns += (columns.empty() ? "" : ", ") + column;
    if (name == kText) return badInput(message<"list-without-text">(with::quoted<"columns">(columns)));
    return badInput(message<"list-without-column">(with::quoted<"name">(name), with::quoted<"columns">(columns)));
  }
  return {};
}

std::string BatchPlan::valueOf(std::size_t index, std::string_view name) const {
  const auto column = name == kId && idColumn_ ? idColumn_ : list_.find(name);
  if (column) return std::string(list_.cell(index, *column));
  assert(name == kNumber || name == kId);
  return std::to_string(firstNumber_ + index);
}

/// Makes a row, without the version that all rows share.
Result<BatchRow> BatchPlan::made(std::size_t index) const {
  BatchRow row{.number = firstNumber_ + index,
               .line = list_.line(index),
               .id = valueOf(index, kId),
               .file = {},
               .model = {},
               .request = all_};
  if (row.id.empty()) return badInput(message<"row-without-id">());
  const auto value = [&](std::string_view name) { return valueOf(index, name); };
  auto text = text_.filled(value);
  QRELIEF_TRY(text);
  if (text->empty()) return badInput(message<"row-without-text">());
  row.request.code.text = std::move(*text);
  auto label = label_.filled(value);
  QRELIEF_TRY(label);
  row.request.code.label.text = std::move(*label);
  auto file = name_.filled(value);
  QRELIEF_TRY(file);
  if (auto why = whyNoPlainName(*file)) return badInput(std::move(*why));
  row.file = std::move(*file);
  if (const auto model = list_.find(kModel)) row.model = list_.cell(index, *model);
  for (const auto& [column, setting] : settings_) {
    const std::string cell(list_.cell(index, column));
    if (cell.empty()) continue;
    const auto parsed = valueFromText(*setting, std::span(&cell, 1));
    QRELIEF_TRY(parsed);
    QRELIEF_TRY(checkValue(*setting, *parsed));
    setting->write(row.request, *parsed);
  }
  if (hasUsualNames_ && (row.request.marking.isInColour() || row.request.marking.isOpen))
    row.file.replace(row.file.rfind('.'), std::string::npos, ".3mf");
  return row;
}

void BatchPlan::add(std::uint32_t line, Message problem) {
  if (problems_.size() < kMostProblems)
    problems_.push_back(message<"list-line">(with::index<"line">(line), with::cause<"problem">(std::move(problem))));
}

/// Counts a warning about another row. @param line  of the row
void BatchPlan::addTrace(std::vector<TextTrace>& traces, Message message, std::uint32_t line) {
  const auto same =
      std::find_if(traces.begin(), traces.end(), [&](const TextTrace& trace) { return trace.message == message; });
  if (same == traces.end())
    traces.push_back({std::move(message), line, 1});
  else
    ++same->count;
}

/// Adds one warning of each kind about the texts of rows, with the first line that it concerns.
void BatchPlan::warnOfTexts(const std::vector<TextTrace>& traces) {
  for (const TextTrace& trace : traces)
    if (trace.count == 1)
      warnings_.push_back(message<"list-line">(with::index<"line">(trace.line), with::cause<"problem">(trace.message)));
    else
      warnings_.push_back(message<"list-lines">(with::index<"line">(trace.line), with::count<"count">(trace.count - 1),
                                                with::cause<"problem">(trace.message)));
}

/// Adds traces of columns without a value in a row whose text or label uses them.
void BatchPlan::noteEmptyCells(std::size_t index, const BatchRow& row, std::vector<TextTrace>& traces) const {
  const auto note = [&](const TextTemplate& pattern) {
    for (const std::string& name : pattern.names())
      if (const auto column = list_.find(name); column && list_.cell(index, *column).empty())
        addTrace(traces, message<"cell-empty">(with::quoted<"name">(list_.columns()[*column])), row.line);
  };
  note(text_);
  if (!row.request.code.label.text.empty()) note(label_);
}

void BatchPlan::checkRows() {
  std::vector<TextTrace> traces, emptyCells;
  std::map<std::pair<ErrorCorrection, EciUse>, VersionsByLength> versions;
  int largest = 1;
  const auto checkCode = [&](const BatchRow& row) {
    for (TextAdvice& advice : adviseText(row.request.code.text)) {
      if (advice.severity != TextAdvice::Severity::Warning) continue;
      const auto same = std::find_if(traces.begin(), traces.end(),
                                     [&](const TextTrace& trace) { return trace.message.code == advice.message.code; });
      addTrace(traces, same == traces.end() ? std::move(advice.message) : same->message, row.line);
    }
    const SymbolOptions& symbol = row.request.code.symbol;
    const auto [known, isNew] =
        versions.try_emplace({symbol.errorCorrection, symbol.eci}, symbol.errorCorrection, symbol.eci);
    const std::string& text = row.request.code.text;
    const bool isRefused = isBlank(text) || text.find('\0') != text.npos;  // encodeSymbol() says why
    const int needed = isRefused ? 0 : known->second.smallest(text);
    if (needed == 0 || (symbol.version && needed > *symbol.version)) {
      const auto encoded = encodeSymbol(row.request.code.text, symbol);
      if (!encoded) add(row.line, encoded.error().message);
    } else if (!symbol.version) {
      largest = std::max(largest, needed);
    }
  };
  for (std::size_t i = 0; i < size(); ++i) {
    const auto row = made(i);
    if (!row) {
      add(list_.line(i), row.error().message);
      continue;
    }
    noteEmptyCells(i, *row, emptyCells);
    if (!row->request.code.isText())
      checkCode(*row);
    else if (const auto letters = requestedSymbol(row->request.code); !letters)
      add(row->line, letters.error().message);
    if (row->request.marking.isInColour() && !holdsColoursOf(row->request, formatOfName(row->file)))
      add(row->line, message<"colour-has-no-file">(with::quoted<"name">(row->file)));
    if (!row->request.code.label.text.empty())
      if (const auto label = layOutLabel(row->request.code.label, 21); !label) add(row->line, label.error().message);
    if (!settings_.empty() || i == 0)
      if (const Status good = checkSettings(row->request); !good) add(row->line, good.error().message);
  }
  warnOfTexts(emptyCells);
  warnOfTexts(traces);
  if (!problems_.empty()) return;
  if (!all_.code.symbol.version) all_.code.symbol.version = largest;
  // Parts may share a text without a code, such as a name.
  checkTwice([](const BatchRow& row) { return row.request.code.isText() ? std::string() : row.request.code.text; },
             [](const BatchRow& row, std::uint32_t other) {
               return message<"text-twice">(with::quoted<"text">(row.request.code.text), with::index<"other">(other));
             });
  const std::size_t known = problems_.size();
  checkTwice([](const BatchRow& row) { return row.id; },
             [](const BatchRow& row, std::uint32_t other) {
               return message<"id-twice">(with::quoted<"id">(row.id), with::index<"other">(other));
             });
  if (problems_.size() > known) return;  // the file names made of these ids would repeat the problem
  checkTwice([](const BatchRow& row) { return caseFolded(row.file); },
             [](const BatchRow& row, std::uint32_t other) {
               return message<"name-twice">(with::quoted<"name">(row.file), with::index<"other">(other));
             });
  checkSecondFiles();
}

/// Finds duplicates by their hashes, because all texts of a million rows would take too much memory. Where hashes
/// agree, compares the values themselves.
void BatchPlan::checkTwice(std::string (*of)(const BatchRow&),
                           Message (*problem)(const BatchRow&, std::uint32_t otherLine)) {
  std::vector<std::pair<std::size_t, std::uint32_t>> hashes;
  hashes.reserve(size());
  for (std::size_t i = 0; i < size(); ++i)
    hashes.emplace_back(std::hash<std::string>()(of(*made(i))), static_cast<std::uint32_t>(i));
  std::sort(hashes.begin(), hashes.end());
  for (std::size_t i = 1; i < hashes.size(); ++i) {
    if (hashes[i].first != hashes[i - 1].first) continue;
    const auto row = made(hashes[i].second), before = made(hashes[i - 1].second);
    if (of(*row) == of(*before) && !of(*row).empty()) add(row->line, problem(*row, before->line));
  }
}

/// Finds rows whose second files have the name of another row's file.
void BatchPlan::checkSecondFiles() {
  std::vector<std::pair<std::string, std::size_t>> names;
  bool isAnySecond = false;
  for (std::size_t i = 0; i < size(); ++i) {
    const std::vector<std::string> files = made(i)->files();
    isAnySecond |= files.size() > 1;
    if (i == 0 && !isAnySecond && settings_.empty()) return;  // no row has a second file
    for (const std::string& file : files) names.emplace_back(caseFolded(file), i);
  }
  if (!isAnySecond) return;
  std::sort(names.begin(), names.end());
  for (std::size_t i = 1; i < names.size(); ++i) {
    const std::size_t row = names[i].second, before = names[i - 1].second;
    if (names[i].first != names[i - 1].first || row == before) continue;
    add(list_.line(row),
        message<"name-twice">(with::quoted<"name">(names[i].first), with::index<"other">(list_.line(before))));
  }
}

BatchRow BatchPlan::row(std::size_t index) const {
  assert(problems_.empty());
  return *made(index);
}

}  // namespace qrelief
