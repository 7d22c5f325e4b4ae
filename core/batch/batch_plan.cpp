// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_plan.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>

#include "io/sniff_format.h"
#include "io/write_files.h"
#include "pipeline/carved_objects.h"
#include "settings/removed_settings.h"
#include "settings/setting_text.h"

namespace qrelief {
namespace {

constexpr std::string_view kId = "id", kText = "text", kFile = "file", kNumber = "n";
constexpr std::size_t kMostNameBytes = 200;  // file systems allow 255, and our names may get a suffix

std::string lowered(std::string_view text) {
  std::string low(text);
  for (char& c : low)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return low;
}

/// Returns true for names that Windows reserves for devices, whatever their extension.
bool isDeviceName(std::string_view name) {
  const std::string stem = lowered(name.substr(0, name.find('.')));
  if (stem.size() == 4 && (stem.starts_with("com") || stem.starts_with("lpt"))) return stem[3] >= '1' && stem[3] <= '9';
  constexpr std::array<std::string_view, 4> kDevices = {"con", "prn", "aux", "nul"};
  return std::find(kDevices.begin(), kDevices.end(), stem) != kDevices.end();
}

}  // namespace

std::vector<std::string> BatchRow::files() const {
  return fileNames(file, request.marking.isTwoColoured() || request.marking.isOpen);
}

std::optional<Message> whyNoPlainName(std::string_view name) {
  if (name.empty()) return message("name-empty");
  const bool hasControls = std::any_of(name.begin(), name.end(), [](char c) { return c >= 0 && c < ' '; });
  if (hasControls || name.find_first_of("/\\<>:\"|?*\x7f") != name.npos || name.starts_with('.') || isDeviceName(name))
    return message("name-no-plain-name", with::quoted<"name">(name));
  if (name.size() > kMostNameBytes)
    return message("name-too-long", with::count<"count">(name.size()), with::count<"limit">(kMostNameBytes));
  if (!isWritable(formatOfName(name))) return message("name-not-writable", with::quoted<"name">(name));
  return std::nullopt;
}

BatchPlan BatchPlan::make(BatchList list, const BatchRequest& request) {
  BatchPlan plan;
  plan.list_ = std::move(list);
  plan.all_ = request.all;
  plan.firstNumber_ = request.firstNumber;
  const std::string text = request.all.code.text.empty() ? "{text}" : request.all.code.text;
  const bool hasFile = plan.list_.find(kFile).has_value();
  const bool mayBeInColour = request.all.marking.isInColour() || request.all.marking.isOpen;
  const char* const usual = hasFile ? "{file}" : mayBeInColour ? "{id}.3mf" : "{id}.stl";
  const std::string name = request.name.empty() ? usual : request.name;
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
  for (const TextTemplate* text : {&text_, &name_, &label_})
    if (const Status known = checkNames(*text); !known) return known;
  const std::vector<std::string>& columns = list_.columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto names = [&](const TextTemplate& in) {
      return std::find(in.names().begin(), in.names().end(), columns[i]) != in.names().end();
    };
    const bool isNamed = names(text_) || names(name_) || names(label_);
    const Setting* setting = findSetting(columns[i]);
    if (setting && setting->key == kText) setting = nullptr;
    if (setting) settings_.push_back({i, setting});
    if (isNamed || setting || columns[i] == kId) continue;
    if (const RemovedSetting* removed = findRemovedSetting(columns[i]))
      warnings_.push_back(removedWarning(*removed, columns[i]));
    else
      unused_.push_back(columns[i]);
  }
  warnOfRemovedChoices();
  return {};
}

/// Adds one warning for each removed choice in the list.
void BatchPlan::warnOfRemovedChoices() {
  for (const RemovedSetting& removed : removedSettings()) {
    if (removed.choice.empty()) continue;
    const auto column = std::find_if(settings_.begin(), settings_.end(),
                                     [&](const SettingColumn& c) { return c.setting->key == removed.key; });
    if (column == settings_.end()) continue;
    std::size_t row = 0;
    while (row < size() && list_.cell(row, column->column) != removed.choice) ++row;
    if (row < size()) warnings_.push_back(removedWarning(removed, removed.key + " " + removed.choice));
  }
}

Status BatchPlan::checkNames(const TextTemplate& pattern) const {
  for (const std::string& name : pattern.names()) {
    if (name == kNumber || name == kId || list_.find(name)) continue;
    if (list_.columns().empty()) return badInput(message("template-without-list", with::quoted<"name">(name)));
    std::string columns;
    for (const std::string& column : list_.columns()) columns += (columns.empty() ? "" : ", ") + column;
    if (name == kText) return badInput(message("list-without-text", with::quoted<"columns">(columns)));
    return badInput(message("list-without-column", with::quoted<"name">(name), with::quoted<"columns">(columns)));
  }
  return {};
}

std::string BatchPlan::valueOf(std::size_t index, std::string_view name) const {
  if (const auto column = list_.find(name)) return std::string(list_.cell(index, *column));
  assert(name == kNumber || name == kId);
  return std::to_string(firstNumber_ + index);
}

/// Makes a row, without the version that all rows share.
Result<BatchRow> BatchPlan::made(std::size_t index) const {
  BatchRow row{.number = firstNumber_ + index,
               .line = list_.line(index),
               .id = valueOf(index, kId),
               .file = {},
               .request = all_};
  if (row.id.empty()) return badInput(message("row-without-id"));
  const auto value = [&](std::string_view name) { return valueOf(index, name); };
  auto text = text_.filled(value);
  if (!text) return tl::unexpected(text.error());
  if (text->empty()) return badInput(message("row-without-text"));
  row.request.code.text = std::move(*text);
  auto label = label_.filled(value);
  if (!label) return tl::unexpected(label.error());
  row.request.code.label.text = std::move(*label);
  auto file = name_.filled(value);
  if (!file) return tl::unexpected(file.error());
  if (auto why = whyNoPlainName(*file)) return badInput(std::move(*why));
  row.file = std::move(*file);
  for (const auto& [column, setting] : settings_) {
    const std::string cell(list_.cell(index, column));
    if (cell.empty() || findRemovedChoice(setting->key, cell)) continue;
    const auto parsed = valueFromText(*setting, std::span(&cell, 1));
    if (!parsed) return tl::unexpected(parsed.error());
    if (const Status good = checkValue(*setting, *parsed); !good) return tl::unexpected(good.error());
    setting->write(row.request, *parsed);
  }
  return row;
}

void BatchPlan::add(std::uint32_t line, Message problem) {
  if (problems_.size() < kMostProblems)
    problems_.push_back(message("list-line", with::count<"line">(line), with::cause<"problem">(std::move(problem))));
}

void BatchPlan::checkRows() {
  std::map<ErrorCorrection, VersionsByLength> versions;
  int largest = 1;
  for (std::size_t i = 0; i < size(); ++i) {
    const auto row = made(i);
    if (!row) {
      add(list_.line(i), row.error().message);
      continue;
    }
    const SymbolOptions& symbol = row->request.code.symbol;
    const int needed = versions.try_emplace(symbol.errorCorrection, symbol.errorCorrection)
                           .first->second.smallest(row->request.code.text);
    if (needed == 0 || (symbol.version && needed > *symbol.version)) {
      const auto encoded = encodeSymbol(row->request.code.text, symbol);
      if (!encoded) add(row->line, encoded.error().message);
    } else if (!symbol.version) {
      largest = std::max(largest, needed);
    }
    if (row->request.marking.isInColour() && !holdsColoursOf(row->request, formatOfName(row->file)))
      add(row->line, message("colour-has-no-file", with::quoted<"name">(row->file)));
    if (!row->request.code.label.text.empty())
      if (const auto label = layOutLabel(row->request.code.label, 21); !label) add(row->line, label.error().message);
    if (!settings_.empty() || i == 0)
      if (const Status good = checkSettings(row->request); !good) add(row->line, good.error().message);
  }
  if (!problems_.empty()) return;
  if (!all_.code.symbol.version) all_.code.symbol.version = largest;
  checkTwice([](const BatchRow& row) { return row.request.code.text; },
             [](const BatchRow& row, std::uint32_t other) {
               return message("text-twice", with::quoted<"text">(row.request.code.text), with::count<"other">(other));
             });
  checkTwice([](const BatchRow& row) { return lowered(row.file); },
             [](const BatchRow& row, std::uint32_t other) {
               return message("name-twice", with::quoted<"name">(row.file), with::count<"other">(other));
             });
  checkSecondFiles();
  checkTwice([](const BatchRow& row) { return row.id; },
             [](const BatchRow& row, std::uint32_t other) {
               return message("id-twice", with::quoted<"id">(row.id), with::count<"other">(other));
             });
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
    if (of(*row) == of(*before)) add(row->line, problem(*row, before->line));
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
    for (const std::string& file : files) names.emplace_back(lowered(file), i);
  }
  if (!isAnySecond) return;
  std::sort(names.begin(), names.end());
  for (std::size_t i = 1; i < names.size(); ++i) {
    const std::size_t row = names[i].second, before = names[i - 1].second;
    if (names[i].first != names[i - 1].first || row == before) continue;
    add(list_.line(row),
        message("name-twice", with::quoted<"name">(names[i].first), with::count<"other">(list_.line(before))));
  }
}

BatchRow BatchPlan::row(std::size_t index) const {
  assert(problems_.empty());
  return *made(index);
}

}  // namespace qrelief
