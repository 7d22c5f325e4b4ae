// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the study's tables; see study/README.md. script/study runs it.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "base/clock.h"
#include "batch/shard.h"
#include "messages/sentences.h"
#include "native/egl_context.h"
#include "study/experiment.h"
#include "study/table.h"

namespace qrelief::study {
namespace {

/// Returns the file name of the table that a share writes.
std::string fileOf(const std::string& path, const Shard& shard) {
  return shard.isWhole() ? path : fmt::format("{}.{}", path, shard.name());
}

int failed(const std::string& what, const Error& error) {
  fmt::print(stderr, "{}: {}\n", what, sentenceAndHint(error.message));
  return 1;
}

Row measured(const Experiment& experiment, const Row& key, StudyContext& context) {
  auto values = experiment.measure(key, context);
  if (values) {
    values->emplace_back();
    return std::move(*values);
  }
  Row none(experiment.measures.size());
  none.push_back(values.error().message.code);
  return none;
}

/// Cases for a run to measure. A shard gets all cases with the same first key, which is usually the model: they share
/// the code's place and its measurements.
struct Chosen {
  Shard shard;
  std::string only;  ///< a value that one of the keys must have; empty: no restriction

  std::vector<const Row*> of(const std::vector<Row>& cases) const {
    std::vector<const Row*> chosen;
    std::vector<std::string> firstKeys;
    for (const Row& key : cases) {
      const auto known = std::find(firstKeys.begin(), firstKeys.end(), key.front());
      const auto group = static_cast<std::size_t>(known - firstKeys.begin());
      if (known == firstKeys.end()) firstKeys.push_back(key.front());
      if (shard.has(group) && (only.empty() || std::find(key.begin(), key.end(), only) != key.end()))
        chosen.push_back(&key);
    }
    return chosen;
  }
};

/// Measures the chosen cases that the table lacks. Takes over the rows in other shares' files, and removes these files
/// once the table is complete.
Status run(const Experiment& experiment, const std::string& path, const Chosen& chosen, StudyContext& context) {
  const Shard& shard = chosen.shard;
  auto table = Table::open(experiment, fileOf(path, shard));
  QRELIEF_TRY(table);
  std::vector<std::string> parts;
  if (shard.isWhole()) {
    const std::filesystem::path whole(path);
    for (const auto& entry : std::filesystem::directory_iterator(whole.parent_path()))
      if (entry.path().filename().string().starts_with(whole.filename().string() + ".")) parts.push_back(entry.path());
  } else {
    parts.push_back(path);
  }
  for (const std::string& part : parts) {
    const auto other = Table::open(experiment, part);
    QRELIEF_TRY(other);
    table->take(*other);
  }
  std::vector<const Row*> missing = chosen.of(experiment.cases);
  std::erase_if(missing, [&](const Row* key) { return table->find(*key) != nullptr; });
  const bool isTerminal = ::isatty(STDERR_FILENO);
  const auto start = Clock::now();
  for (std::size_t i = 0; i < missing.size(); ++i) {
    const double left =
        i == 0 ? 0 : millisecondsSince(start) / 1000 / static_cast<double>(i) * static_cast<double>(missing.size() - i);
    if (isTerminal)
      fmt::print(stderr, "\r\033[K{}: {} of {}{} ", experiment.name, i + 1, missing.size(),
                 i == 0 ? "" : ", " + durationInWords(left) + " left");
    QRELIEF_TRY(table->add(*missing[i], measured(experiment, *missing[i], context)));
  }
  fmt::print(stderr, "{}{}: {} rows, {} of them measured now, {}\n", isTerminal ? "\r\033[K" : "", experiment.name,
             experiment.cases.size(), missing.size(), durationInWords(millisecondsSince(start) / 1000));
  if (!shard.isWhole() || !chosen.only.empty()) return {};
  const Status written = table->write(experiment);
  if (written)
    for (const std::string& part : parts) std::filesystem::remove(part);
  return written;
}

/// Returns how far two values of a table differ: 0 = equal, 1 = as much as the column's values range, or different
/// words.
double apart(const std::string& before, const std::string& now, double range) {
  char *endKept = nullptr, *endNow = nullptr;
  const double a = std::strtod(before.c_str(), &endKept), b = std::strtod(now.c_str(), &endNow);
  if (before.empty() || now.empty() || *endKept || *endNow) return before == now ? 0 : 1;
  return range > 0 ? std::abs(a - b) / range : 0;
}

double rangeOf(const Experiment& experiment, const Table& table, std::size_t column) {
  double least = INFINITY, most = -INFINITY;
  for (const Row& key : experiment.cases)
    if (const Row* row = table.find(key); row && !(*row)[column].empty()) {
      const double value = std::strtod((*row)[column].c_str(), nullptr);
      least = std::min(least, value);
      most = std::max(most, value);
    }
  return std::max(0.0, most - least);
}

/// Measures some cases of a kept table once more. @returns number of values that differ
int check(const Experiment& experiment, const std::string& path, int count, StudyContext& context) {
  constexpr double kAlike = 0.1;  // as a part of the column's range
  const auto table = Table::open(experiment, path);
  if (!table) return failed(experiment.name, table.error());
  int off = 0;
  const std::size_t step = std::max<std::size_t>(1, experiment.cases.size() / static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < experiment.cases.size() && i / step < static_cast<std::size_t>(count); i += step) {
    const Row& key = experiment.cases[i];
    const Row* before = table->find(key);
    if (!before) {
      fmt::print("{}: no row {}\n", experiment.name, fmt::join(key, ","));
      ++off;
      continue;
    }
    const Row now = measured(experiment, key, context);
    for (std::size_t column = 0; column < now.size(); ++column) {
      const bool isTime = column < experiment.measures.size() && experiment.measures[column].ends_with("_ms");
      if (isTime || apart((*before)[column], now[column], rangeOf(experiment, *table, column)) <= kAlike) continue;
      fmt::print("{}, {}: {} was {}, is {}\n", experiment.name, fmt::join(key, ","),
                 column < experiment.measures.size() ? experiment.measures[column] : kFailedColumn, (*before)[column],
                 now[column]);
      ++off;
    }
  }
  return off;
}

int run(int argc, char** argv) {
  CLI::App app("Measures the tables of the study");
  std::vector<std::string> names;
  std::string folder, samples, shardText;
  std::string only;
  int checked = 0;
  app.add_option("NAME", names, "experiments; all if none is named");
  app.add_option("--results", folder, "folder of the tables")->required();
  app.add_option("--samples", samples, "folder of the page's sample models")->required();
  app.add_option(
      "--shard", shardText,
      "I/N: split the models into N groups and measure group I (0 to N - 1). Results go into separate files");
  app.add_option("--only", only, "measure only the cases that have this value among their keys");
  app.add_option("--check", checked, "measure this many cases of each kept table once more and compare");
  CLI11_PARSE(app, argc, argv);
  const std::optional<Shard> parsed = shardText.empty() ? Shard() : Shard::parse(shardText);
  if (!parsed) {
    fmt::print(stderr, "--shard is I/N with 0 ≤ I < N, not {}\n", shardText);
    return 2;
  }
  const Shard shard = *parsed;
  const auto gl = EglContext::create();
  if (!gl) return failed("EGL", gl.error());
  StudyContext context(samples);
  const std::vector<Experiment> all = allExperiments();
  for (const std::string& name : names)
    if (std::none_of(all.begin(), all.end(), [&](const Experiment& e) { return e.name == name; })) {
      fmt::print(stderr, "there is no experiment {}; there are:", name);
      for (const Experiment& experiment : all) fmt::print(stderr, " {}", experiment.name);
      fmt::print(stderr, "\n");
      return 2;
    }
  int off = 0;
  for (const Experiment& experiment : all) {
    if (!names.empty() && std::find(names.begin(), names.end(), experiment.name) == names.end()) continue;
    const std::string path = folder + "/" + experiment.name + ".csv";
    if (checked > 0)
      off += check(experiment, path, checked, context);
    else if (const Status done = run(experiment, path, {shard, only}, context); !done)
      return failed(experiment.name, done.error());
  }
  if (checked > 0)
    fmt::print("{}: {} values are off\n", names.empty() ? "all tables" : fmt::format("{}", fmt::join(names, ", ")),
               off);
  return off > 0 ? 1 : 0;
}

}  // namespace
}  // namespace qrelief::study

int main(int argc, char** argv) { return qrelief::study::run(argc, argv); }
