// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "base/clock.h"
#include "base/unicode.h"
#include "batch/batch_layout.h"
#include "batch/batch_progress.h"
#include "batch/manifest.h"
#include "cli/batch_run.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "cli/shard_flags.h"
#include "cli/unused_flags.h"
#include "io/sniff_format.h"
#include "message_codes/batch.h"
#include "message_codes/command.h"
#include "messages/sentences.h"
#include "native/files.h"
#include "native/text_lines.h"

namespace qrelief {
namespace {

constexpr std::size_t kMostNumber = 1'000'000'000'000;  // of a row
constexpr std::size_t kMostCounted = 10'000'000;        // rows; they take a few GiB of memory

Result<std::vector<std::uint8_t>> readList(const std::string& path) {
  if (path == kStandardStream) return readText(std::cin, kMostLineBytes);
  Result<std::ifstream> stream = openFile(path);
  QRELIEF_TRY(stream);
  return readText(*stream, kMostLineBytes);
}

/// Returns the rows of the list, or the rows that --count numbers.
Result<BatchList> listOf(const BatchOptions& options) {
  if (options.list.empty() == (options.count == 0)) return fail(ErrorKind::BadUsage, message<"batch-list-or-count">());
  if (options.count > 0) return countedBatchList(options.count);
  const auto bytes = readList(options.list);
  QRELIEF_TRY(bytes);
  return readBatchList(*bytes);
}

int printProblems(const BatchPlan& plan, const std::string& list) {
  for (const Message& problem : plan.problems()) printError({ErrorKind::BadInput, problem}, list);
  if (plan.problems().size() == BatchPlan::kMostProblems)
    fmt::print(stderr, "qrelief: stopped after {} problems; there may be more\n", BatchPlan::kMostProblems);
  return kBadInput;
}

/// Writes the manifest of all rows and prints a summary. @returns exit status
int finish(const BatchFolder& folder, const BatchPlan& plan) {
  const BatchLayout layout = {.rows = plan.size(), .firstNumber = plan.firstNumber()};
  BatchProgress progress(layout);
  const Status read = folder.forEach([&](const ManifestEntry& entry) -> Status {
    progress.note(entry);
    // The folder may have rows of another list or series.
    if (layout.rowOf(entry.number) >= plan.size() || entry.status == RowStatus::Done) return {};
    fmt::print(stderr, "qrelief: row {} ({}) {}: {}\n", entry.number, entry.id, rowStatusName(entry.status),
               entry.reason);
    return {};
  });
  if (!read) return printError(read.error());
  if (const Status written = folder.writeManifest(plan.firstNumber() + plan.size() - 1); !written)
    return printError(written.error());
  const BatchProgress::Counts counts = progress.counts();
  fmt::print("{}: {} done, {} failed, {} missing\n", counted(plan.size(), "row", "rows"), counts.done, counts.failed,
             counts.waiting);
  return counts.done == plan.size() ? kEngraved : kCheckFailed;
}

/// Merges the manifests that the processes of a batch have written.
int merge(const BatchOptions& options, const BatchPlan& plan) {
  const auto folder = BatchFolder::open(options.folder, {});
  if (!folder) return printError(folder.error());
  const std::size_t first = plan.firstNumber(), last = first + plan.size() - 1;
  std::size_t next = first, told = 0, lost = 0;
  const auto tellMissing = [&](std::size_t end) {
    for (; next < end && told < BatchPlan::kMostProblems; ++next, ++told)
      fmt::print(stderr, "qrelief: row {} ({}) is missing\n", next, plan.row(next - first).id);
  };
  const Status read = folder->forEach([&](const ManifestEntry& entry) -> Status {
    if (entry.number < first || entry.number > last) return {};
    tellMissing(entry.number);
    next = entry.number + 1;
    if (entry.status != RowStatus::Done) return {};
    const auto known = folder->known(entry);
    if (known.state == EarlierRow::State::Done) return {};
    fmt::print(stderr, "qrelief: row {}: {} {}\n", entry.number, entry.file,
               known.state == EarlierRow::State::Changed ? "has changed" : "is missing");
    ++lost;
    return {};
  });
  if (!read) return printError(read.error());
  tellMissing(last + 1);
  const std::vector<std::size_t> doubles = folder->doubles();
  for (const std::size_t number : doubles) fmt::print(stderr, "qrelief: two shares made row {}\n", number);
  const int status = finish(*folder, plan);
  return lost == 0 ? status : kCheckFailed;
}

std::size_t doneAmong(const std::vector<ManifestEntry>& entries) {
  return static_cast<std::size_t>(std::count_if(
      entries.begin(), entries.end(), [](const ManifestEntry& entry) { return entry.status == RowStatus::Done; }));
}

/// Prints a line about each row of a unit. @param mine  rows of this process
void printProgress(const std::vector<ManifestEntry>& entries, const BatchProgress& progress, std::size_t mine,
                   double workedMs) {
  const auto leftMs = progress.remainingMs(workedMs);
  for (const ManifestEntry& entry : entries)
    fmt::print(stderr, "{}/{} {}: {}{}{}\n", progress.counts().finished(), mine, entry.id, rowStatusName(entry.status),
               entry.reason.empty() ? "" : ", " + entry.reason,
               leftMs ? fmt::format("; {} left", durationInWords(*leftMs / 1000)) : "");
}

/// Returns the first row with a model. The model's place is the one for its code, whichever share a row is in.
std::size_t firstRowOf(const BatchPlan& plan, const std::string& model) {
  if (!model.empty()) return plan.models().at(model);
  std::size_t row = 0;
  while (!plan.models().empty() && !plan.row(row).model.empty()) ++row;
  return row;
}

/// Checks that each model that the rows need can be opened.
int checkModels(const BatchOptions& options, const BatchPlan& plan) {
  if (options.model.path.empty() && plan.needsModel()) {
    if (plan.models().empty()) return printError({ErrorKind::BadUsage, message<"model-missing">()});
    const std::uint32_t line = plan.row(firstRowOf(plan, "")).line;
    return printError(
        {ErrorKind::BadUsage,
         message<"list-line">(with::index<"line">(line), with::cause<"problem">(message<"row-without-model">()))});
  }
  if (options.perPlate > 0 && !plan.models().empty())
    return printError({ErrorKind::BadUsage, message<"models-on-plate">()});
  if (plan.needsModel())
    if (const Status opened = checkModel(options.model.path); !opened)
      return printError(opened.error(), options.model.path);
  int status = kEngraved;
  for (const auto& [model, row] : plan.models())
    if (const Status opened = checkModel(modelPath(options, model)); !opened)
      status = printError(
          {ErrorKind::BadInput,
           message<"list-line">(with::index<"line">(plan.row(row).line),
                                with::cause<"problem">(message<"row-model">(
                                    with::quoted<"model">(model), with::cause<"problem">(opened.error().message))))},
          options.list);
  return status;
}

/// Inputs that lie in the output folder, by their names without capitals.
using InputsInFolder = std::map<std::string, std::string>;

void addInput(const BatchOptions& options, const std::string& input, InputsInFolder& inside) {
  if (!input.empty() && isSameFile(options.folder + "/" + fileNameOf(input), input))
    inside.emplace(caseFolded(fileNameOf(input)), input);
}

/// Refuses files that would overwrite an input.
Status checkOverwrites(const InputsInFolder& inside, std::span<const std::string> names) {
  if (inside.empty()) return {};
  for (const std::string& name : names)
    if (const auto same = inside.find(caseFolded(name)); same != inside.end())
      return fail(ErrorKind::BadUsage,
                  message<"output-is-input">(with::term<"output">("-o"), with::term<"path">(same->second),
                                             with::term<"input">("this command")));
  return {};
}

/// Returns the names of all files that a row makes.
std::vector<std::string> filesOf(const BatchOptions& options, const BatchRow& row) {
  std::vector<std::string> names = row.files();
  if (options.reports) names.push_back(row.file + ".json");
  return names;
}

/// Refuses rows whose files would overwrite a model or the list.
Status checkOverwrites(const BatchOptions& options, const BatchPlan& plan) {
  InputsInFolder inside;
  addInput(options, options.model.path, inside);
  if (options.list != kStandardStream) addInput(options, options.list, inside);
  for (const auto& [model, row] : plan.models()) addInput(options, modelPath(options, model), inside);
  if (inside.empty()) return {};
  QRELIEF_TRY(checkOverwrites(inside, std::vector<std::string>{"manifest.jsonl", "manifest.csv"}));
  for (std::size_t i = 0; i < plan.size(); ++i) QRELIEF_TRY(checkOverwrites(inside, filesOf(options, plan.row(i))));
  return {};
}

/// Checks --for and --palette against the files of the rows.
Status checkFileFlags(const BatchOptions& options, const BatchPlan& plan) {
  if (options.perPlate > 0) return {};
  std::string output = plan.row(0).file;
  for (std::size_t i = 0; i < plan.size() && formatOfName(output) != ModelFormat::ThreeMf; ++i)
    output = plan.row(i).file;
  return options.fileFlags.check(output);
}

/// Returns the setting whose flag a column has as its name; null if there is none. Columns are named by keys.
const Setting* settingOfFlag(std::string_view column) {
  std::string flag = caseFolded(column);
  std::replace_if(
      flag.begin(), flag.end(), [](char c) { return c == '_' || c == ' '; }, '-');
  if (!flag.starts_with("--")) flag.insert(0, "--");
  const auto of = std::find_if(settings().begin(), settings().end(),
                               [&](const Setting& setting) { return flagOf(setting.key) == flag; });
  return of == settings().end() ? nullptr : &*of;
}

/// Warns of columns that nothing uses, and says what a setting's column is called.
void warnOfUnused(const BatchPlan& plan) {
  std::vector<std::string> unused;
  for (const std::string& column : plan.unusedColumns()) {
    const Setting* setting = settingOfFlag(column);
    unused.push_back(setting ? fmt::format("{} (the setting is called {})", column, setting->key) : column);
  }
  if (!unused.empty()) fmt::print(stderr, "qrelief: warning: unused columns: {}\n", fmt::join(unused, ", "));
}

int runRows(const BatchOptions& options, const GivenShard& share, const BatchRequest& request, BatchList list) {
  const BatchPlan plan = BatchPlan::make(std::move(list), request);
  for (const Message& warning : plan.warnings()) printWarning(warning, options.list);
  if (!plan.problems().empty()) return printProblems(plan, options.list);
  warnOfUnused(plan);
  if (options.merge) return merge(options, plan);
  if (const int status = checkModels(options, plan); status != kEngraved) return status;
  if (const Status writable = checkFileFlags(options, plan); !writable) return printError(writable.error());
  if (const Status safe = checkOverwrites(options, plan); !safe) return printError(safe.error());
  auto folder = BatchFolder::open(options.folder, share.shard);
  if (!folder) return printError(folder.error());
  if (!share.shard.isWhole())
    fmt::print(stderr, "share {} of {} ({})\n", share.shard.index, share.shard.count, share.from);
  BatchRun run(options, std::move(*folder));

  const auto start = Clock::now();
  const BatchLayout layout = {plan.size(), options.perPlate, options.printEvery, options.first};
  BatchProgress progress(layout, share.shard);
  const std::size_t mine = layout.rowsOf(share.shard);
  std::size_t passed = 0;  // rows carved now that passed
  while (const auto unit = progress.take()) {
    std::vector<BatchRow> rows;
    for (std::size_t i = layout.begin(*unit); i < layout.end(*unit); ++i) rows.push_back(plan.row(i));
    const std::string model = rows.front().model;
    const Status used = run.use(model, plan.row(firstRowOf(plan, model)).request);
    if (!used && model.empty()) return printError(used.error(), options.model.path);
    const auto carved =
        used ? run.make(std::move(rows), layout.plate(*unit)) : run.refuse(std::move(rows), used.error().message);
    if (!carved) return printError(carved.error());
    if (carved->isNew)
      progress.settle(carved->entries);
    else
      for (const ManifestEntry& entry : carved->entries) progress.note(entry);
    const std::size_t done = doneAmong(carved->entries);
    if (carved->isNew) passed += done;
    if (!options.quiet && (carved->isNew || done == 0))
      printProgress(carved->entries, progress, mine, millisecondsSince(start));
  }
  if (share.shard.isWhole()) return finish(run.folder(), plan);
  const BatchProgress::Counts& counts = progress.counts();
  fmt::print("{} of {}: {} made now, {} before, {} failed\n", counted(mine, "row", "rows"), plan.size(), passed,
             counts.done - passed, counts.failed);
  return counts.failed == 0 ? kEngraved : kCheckFailed;
}

/// Makes a row from a line of a stream.
/// @param number  for the row, unless the folder knows its name
/// @param warned  the warnings printed so far; each is printed once
Result<BatchRow> rowOf(const std::string& line, BatchRequest request, std::size_t number,
                       std::set<std::string>& warned) {
  auto list = readBatchList(std::span(reinterpret_cast<const std::uint8_t*>(line.data()), line.size()));
  QRELIEF_TRY(list);
  if (list->size() > 1) return badInput(message<"list-no-object">(with::index<"line">(1)));  // an array of several
  request.firstNumber = number;
  const BatchPlan plan = BatchPlan::make(std::move(*list), request);
  if (!plan.problems().empty()) return badInput(plan.problems().front());
  for (const Message& warning : plan.warnings())
    if (warned.insert(sentence(warning)).second) printWarning(warning, {});
  return plan.row(0);
}

/// Carves requests as they come, one JSON object a line, and answers each with its line of the manifest. Row numbers
/// continue after the folder's last one. A request whose file already exists gets the manifest's line for that file.
int runStream(const BatchOptions& options, const BatchRequest& request) {
  auto folder = BatchFolder::open(options.folder, {});
  if (!folder) return printError(folder.error());
  std::set<std::string> warned;
  struct KnownRow {
    std::size_t number;
    std::string text, file;
  };
  std::map<std::string, KnownRow> known;  // by the name of each of its files, without capitals
  std::size_t next = options.first;
  const Status read = folder->forEach([&](const ManifestEntry& entry) -> Status {
    for (const std::string& file : {entry.file, entry.second})
      if (!file.empty()) known[caseFolded(file)] = {entry.number, entry.text, entry.file};
    next = std::max(next, entry.number + 1);
    return {};
  });
  if (!read) return printError(read.error());
  BatchRun run(options, std::move(*folder));
  InputsInFolder inputs;
  addInput(options, options.model.path, inputs);
  bool hasFailed = false;
  LineReader lines(std::cin, kMostLineBytes);
  for (auto line = lines.next(); line; line = lines.next()) {
    auto row = *line ? rowOf(**line, request, next, warned) : tl::unexpected(line->error());
    auto same = known.end();
    if (row)
      for (const std::string& file : row->files())
        if (same == known.end()) same = known.find(caseFolded(file));
    if (same != known.end() && (same->second.text != row->request.code.text || same->second.file != row->file))
      row = badInput(
          message<"name-taken">(with::quoted<"name">(same->second.file), with::quoted<"text">(same->second.text)));
    if (row && row->model.empty() && options.model.path.empty()) row = badInput(message<"row-without-model">());
    if (row && !row->model.empty()) addInput(options, modelPath(options, row->model), inputs);
    if (row)
      if (const Status safe = checkOverwrites(inputs, filesOf(options, *row)); !safe)
        row = tl::unexpected(safe.error());
    if (!row) {
      ManifestEntry refused;
      refused.number = next;
      refused.status = RowStatus::Refused;
      refused.reason = sentenceAndHint(row.error().message);
      std::cout << manifestLine(refused) << std::endl;
      continue;
    }
    const Status used = run.use(row->model, row->request);
    if (!used && row->model.empty()) return printError(used.error(), options.model.path);
    if (same != known.end())
      row->number = same->second.number;
    else
      for (const std::string& file : row->files()) known[caseFolded(file)] = {next, row->request.code.text, row->file};
    if (same == known.end()) ++next;
    const auto carved = used ? run.make({*row}) : run.refuse({*row}, used.error().message);
    if (!carved) return printError(carved.error());
    const ManifestEntry& entry = carved->entries.front();
    hasFailed |= entry.status != RowStatus::Done;
    std::cout << manifestLine(entry) << std::endl;  // flush: the client waits for the line
  }
  return !hasFailed ? kEngraved : kCheckFailed;
}

/// Checks the value of -o. Empty if it can name a folder.
std::string whyNoFolder(const std::string& path) {
  return path == kStandardStream ? "standard output cannot hold the files of a batch: choose a folder" : std::string();
}

int runBatch(const BatchOptions& options) {
  if (const Status writable = options.fileFlags.check("any.3mf"); !writable) return printError(writable.error());
  const auto all = options.flags.request();
  if (!all) return printError(all.error());
  for (const Message& unused : unusedFlags(options.flags, *all)) printWarning(unused, {});
  const BatchRequest request{*all, options.name, options.first};
  if (options.stream) return runStream(options, request);
  const auto share = shardFrom(options.merge ? "0/1" : options.shardFlag, options.merge ? 0 : options.shards);
  if (!share) return printError(share.error());
  auto list = listOf(options);
  if (!list) return printError(list.error(), options.list);
  return runRows(options, *share, request, std::move(*list));
}

}  // namespace

std::function<int()> addBatchCommand(CLI::App& app) {
  auto o = std::make_shared<BatchOptions>();
  CLI::App* c = app.add_subcommand("batch", "Engrave a different code into each copy of a model");
  addModelFlags(*c, o->model);
  c->get_option("MODEL")->required(false)->description(
      fmt::format("{}; a list may name models instead, in its column model", kModelFormats));
  c->add_option("--list", o->list, "rows as CSV or JSON; - reads standard input");
  c->add_option("--count", o->count, "number of rows, without a list; {n} in --text is the row's number")
      ->check(CLI::Range(std::size_t{1}, kMostCounted));
  c->add_option("--first", o->first, "number of the first row, for {n} and the manifest [1]")
      ->check(CLI::Range(std::size_t{1}, kMostNumber));
  o->flags.add(
      *c, "text",
      "template; a column's name in braces is replaced, and {n:05} is the row's number in five digits [{text}]: ");
  c->add_option("-o", o->folder, "output folder")->required()->check(whyNoFolder);
  c->add_option(
      "--name", o->name,
      "template of the file names [{file} if the list has that column, else {id}.stl, or {id}.3mf in colour]");
  addCentreFlag(
      *c, o->at,
      "X,Y,Z: centre of the code in file units; QRelief moves it to the nearest point of the surface [best spot]");
  c->add_option("--shard", o->shardFlag, "I/N: make every N-th row, starting at row I, counted from 0");
  c->add_option("--shards", o->shards,
                "number of processes that share the work; the variables of Slurm, AWS Batch or Kubernetes give this "
                "process's index");
  c->add_option("--per-plate", o->perPlate,
                "write 3MF files of N named parts each; with --name, also a file for each row")
      ->check(CLI::Range(std::size_t{1}, kMostNumber));
  c->add_option("--print-every", o->printEvery,
                "simulate the print of every N-th row only; all rows are engraved for the print [1]")
      ->check(CLI::Range(std::size_t{1}, kMostNumber));
  c->add_flag("--merge", o->merge, "join the manifests of all shares and list missing and repeated rows");
  c->add_flag("--retry-failed", o->retryFailed, "retry failed rows, and overwrite files that have changed");
  c->add_flag("--stream", o->stream,
              "read requests from standard input, one per line, and answer each with its line of the manifest");
  c->add_flag("--reports", o->reports, "also write a report for each row, as FILE.json");
  c->add_flag("--quiet", o->quiet, "do not show progress");
  for (const char* option : {"--list", "--count", "--per-plate", "--shard", "--shards", "--merge"})
    c->get_option("--stream")->excludes(option);
  for (const char* option : {"--shard", "--shards", "--retry-failed"}) c->get_option("--merge")->excludes(option);
  c->get_option("--shard")->excludes("--shards");
  o->flags.addAll(*c);
  o->fileFlags.add(*c);
  return [o] { return runBatch(*o); };
}

}  // namespace qrelief
