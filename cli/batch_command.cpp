// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <iostream>
#include <iterator>
#include <optional>

#include "base/clock.h"
#include "batch/batch_plan.h"
#include "batch/manifest.h"
#include "batch/plate_layout.h"
#include "cli/choose_spot.h"
#include "cli/commands.h"
#include "cli/model_input.h"
#include "cli/progress_bar.h"
#include "cli/setting_flags.h"
#include "cli/shard_flags.h"
#include "io/write_checked.h"
#include "messages/sentences.h"
#include "native/batch_folder.h"
#include "native/egl_context.h"
#include "native/engraver.h"
#include "native/files.h"
#include "native/sha256.h"
#include "native/zxing_reader.h"
#include "pipeline/carved_objects.h"
#include "report/report.h"

namespace qrelief {
namespace {

struct BatchOptions {
  ModelFlags model;
  SettingFlags flags;
  std::string list, folder, name, shardFlag;
  std::vector<double> at;
  std::size_t count = 0, shards = 0, perPlate = 0, printEvery = 1;
  bool merge = false, retryFailed = false, stream = false, reports = false, quiet = false;
};

Result<std::vector<std::uint8_t>> readList(const std::string& path) {
  if (path != "-") return readFile(path);
  return std::vector<std::uint8_t>(std::istreambuf_iterator<char>(std::cin), {});
}

/// The list's rows, or those of --count.
Result<BatchList> listOf(const BatchOptions& options) {
  if (options.list.empty() == (options.count == 0)) return fail(ErrorKind::BadUsage, message("batch-list-or-count"));
  if (options.count > 0) return countedBatchList(options.count);
  const auto bytes = readList(options.list);
  if (!bytes) return tl::unexpected(bytes.error());
  return readBatchList(*bytes);
}

/// Everything that decides a row's output and that its request does not say.
std::string otherSettings(const BatchOptions& options) {
  const RepairFlags& r = options.model.repair;
  return fmt::format("{} {} {} {} {}", options.model.units, options.model.scale.value_or(0), r.weldTolerance, r.maxHole,
                     fmt::join(r.without, ","));
}

/// Carves the rows of one process.
class BatchRun {
 public:
  BatchRun(const BatchOptions& options, BatchFolder folder) : options_(&options), folder_(std::move(folder)) {}

  /// Loads the model, and finds the place that all rows share. @param all  a row's; then has the place
  Status prepare(EngraveRequest& all) {
    fileName_ = fileNameOf(options_->model.path);
    const auto hash = sha256OfFile(options_->model.path);
    if (!hash) return tl::unexpected(hash.error());
    input_ = *hash;
    auto loaded = loadEngravable(options_->model);
    if (!loaded) return tl::unexpected(loaded.error());
    partNames_ = loaded->partNames;
    report_.fileName = fileName_;
    report_.format = loaded->format;
    report_.scaleToMm = loaded->scaleToMm;
    auto gl = EglContext::create();
    if (!gl) return tl::unexpected(gl.error());
    gl_ = std::move(*gl);
    const auto capabilities = gl::queryCapabilities();
    if (!capabilities) return tl::unexpected(capabilities.error());
    report_.gl = *capabilities;
    report_.wording = commandWording();
    report_.reader = zxingName();
    model_ = EngravableModel::upload(std::move(loaded->prepared));
    auto engraver = Engraver::create(model_);
    if (!engraver) return tl::unexpected(engraver.error());
    engraver_.emplace(std::move(*engraver));
    if (!options_->at.empty()) {
      all.placement.centreMm = Vec3(options_->at[0], options_->at[1], options_->at[2]) * report_.scaleToMm;
      return {};
    }
    return chooseSpot(model_, all, report_.scaleToMm, options_->quiet, stderr);  // stdout is for answers
  }

  /// Carves what is not yet there of some rows: of one, or of all of a plate. Their lines are written last.
  /// @param placed  has the place that prepare() found
  /// @param plate   name of the plate's file; empty: none
  /// @returns an entry a row; an error only if nothing more can be written
  Result<std::vector<ManifestEntry>> make(std::vector<BatchRow> rows, const EngraveRequest& placed,
                                          const std::string& plate = {}) {
    using State = BatchFolder::Known::State;
    std::string others = otherSettings(*options_);
    for (BatchRow& row : rows) {
      row.request.placement.centreMm = placed.placement.centreMm;
      if (!row.request.placement.direction) row.request.placement.direction = placed.placement.direction;
      if (!plate.empty()) others += sha256(settingsToHash(row, {}));
    }
    std::vector<ManifestEntry> entries, changed;
    bool isNew = false;
    for (const BatchRow& row : rows) {
      ManifestEntry entry;
      entry.number = row.number;
      entry.id = row.id;
      entry.text = row.request.text;
      entry.file = isFiled() ? row.file : plate;
      entry.plate = isFiled() ? plate : std::string();
      entry.sha256 = {input_, sha256(settingsToHash(row, others)), {}, {}};
      const BatchFolder::Known known = folder_.known(entry);
      if (known.state == State::Done || (known.state == State::Failed && !options_->retryFailed)) {
        entry = known.entry;
      } else if (known.state == State::Changed && !options_->retryFailed) {
        entry.reason = sentenceAndHint(message("file-changed"));
        changed.push_back(entry);
      } else {
        isNew = true;
      }
      entries.push_back(std::move(entry));
    }
    if (isNew)
      if (const Status carved = carveAll(rows, entries, plate); !carved) return tl::unexpected(carved.error());
    for (const ManifestEntry& entry : entries) {
      const bool isDone = entry.status == RowStatus::Done;
      ++(!isDone ? failed_ : isNew ? made_ : kept_);
    }
    for (const ManifestEntry& entry : isNew ? entries : changed)
      if (const Status added = folder_.append(entry); !added) return tl::unexpected(added.error());
    return entries;
  }

  std::size_t made() const { return made_; }
  std::size_t kept() const { return kept_; }
  std::size_t failed() const { return failed_; }
  BatchFolder& folder() { return folder_; }

 private:
  /// Whether each row has a file of its own.
  bool isFiled() const { return options_->perPlate == 0 || !options_->name.empty(); }

  /// Fills the entries. @returns an error only if nothing more can be written
  Status carveAll(const std::vector<BatchRow>& rows, std::vector<ManifestEntry>& entries, const std::string& plate) {
    std::vector<ModelObject> objects;
    const std::vector<Vec3> offsets = plateOffsets(model_->gpu.box(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ManifestEntry& entry = entries[i];
      entry.status = RowStatus::Failed;
      entry.reason.clear();
      const auto carved = carve(rows[i], entry);
      if (!carved) {
        entry.reason = sentenceAndHint(carved.error().message);
        if (isFiled()) folder_.removeOutdated(entry);
        continue;
      }
      entry.status = RowStatus::Done;
      if (plate.empty()) continue;
      for (ModelObject object : carvedObjects(carved->result, partNames_, rows[i].request.inlay)) {
        object.name = object.name.empty() ? rows[i].id : rows[i].id + " " + object.name;
        object.description = rows[i].request.text;
        object.offsetMm = offsets[i];
        objects.push_back(std::move(object));
      }
    }
    if (objects.empty()) return {};
    const auto bytes = writeChecked(objects, ModelFormat::ThreeMf, {.title = plate});
    if (!bytes) return tl::unexpected(bytes.error());
    if (const Status written = writeFileAtomically(folder_.pathOf(plate), *bytes); !written) return written;
    for (ManifestEntry& entry : entries)
      if (entry.status == RowStatus::Done) (isFiled() ? entry.sha256.plate : entry.sha256.output) = sha256(*bytes);
    return {};
  }

  /// Carves a row, and writes its file if it has one. @returns an error if it is not done, and the entry's details
  Result<Engraved> carve(const BatchRow& row, ManifestEntry& entry) {
    const auto start = Clock::now();
    const bool looksAtPrint = (row.number - 1) % options_->printEvery == 0;
    auto engraved = engraver_->engrave(
        row.request, [](const Progress&) {}, looksAtPrint);
    if (!engraved) return engraved;
    entry.details = describeRow({engraved->request, engraved->result, engraved->reading, engraved->printed,
                                 engraved->verdict, millisecondsSince(start)});
    if (const std::vector<Message> failures = engraved->verdict.failed(); !failures.empty())
      return fail(ErrorKind::NoSolution, failures.front());
    if (isFiled()) {
      const auto bytes = encodeCarved(engraved->result, partNames_, row.file, row.request.inlay, row.id);
      if (!bytes) return tl::unexpected(bytes.error());
      if (const Status written = writeFileAtomically(folder_.pathOf(row.file), *bytes); !written)
        return tl::unexpected(written.error());
      entry.sha256.output = sha256(*bytes);
    }
    if (options_->reports)
      if (const Status written = writeReport(row, *engraved, start); !written) return tl::unexpected(written.error());
    return engraved;
  }

  Status writeReport(const BatchRow& row, const Engraved& engraved, Clock::time_point start) {
    ReportContext context = report_;
    context.printed = engraved.printed;
    context.reading = engraved.reading;
    context.verdict = engraved.verdict;
    context.askedPreset = row.request.preset;
    context.totalMs = millisecondsSince(start);
    return writeFileAtomically(folder_.pathOf(row.file) + ".json",
                               makeReport(engraved.request, *model_, engraved.result, context));
  }

  const BatchOptions* options_;
  BatchFolder folder_;
  std::unique_ptr<EglContext> gl_;  // outlives what lies in it
  std::shared_ptr<const EngravableModel> model_;
  std::optional<Engraver> engraver_;
  std::vector<std::string> partNames_;
  std::string fileName_, input_;
  ReportContext report_;
  std::size_t made_ = 0, kept_ = 0, failed_ = 0;
};

int printProblems(const BatchPlan& plan, const std::string& list) {
  for (const Message& problem : plan.problems()) printError({ErrorKind::BadInput, problem}, list);
  if (plan.problems().size() == BatchPlan::kMostProblems)
    fmt::print(stderr, "qrelief: there may be more; the first {} are named\n", BatchPlan::kMostProblems);
  return kBadInput;
}

/// @param plate  from 0
std::string plateName(std::size_t plate, std::size_t plates) {
  return fmt::format("plate-{:0{}}.3mf", plate + 1, std::max<std::size_t>(3, std::to_string(plates).size()));
}

/// Writes the manifest of all, and what became of them. @returns exit status
int finish(const BatchFolder& folder, const BatchPlan& plan) {
  std::size_t known = 0, failed = 0;
  const Status read = folder.forEach([&](const ManifestEntry& entry) -> Status {
    if (entry.number > plan.size()) return {};  // of a longer list before
    ++known;
    if (entry.status == RowStatus::Done) return {};
    ++failed;
    fmt::print(stderr, "qrelief: row {} ({}) {}: {}\n", entry.number, entry.id, rowStatusName(entry.status),
               entry.reason);
    return {};
  });
  if (!read) return printError(read.error());
  if (const Status written = folder.writeManifest(plan.size()); !written) return printError(written.error());
  const std::size_t missing = plan.size() - known;
  fmt::print("{} rows: {} done, {} failed, {} missing\n", plan.size(), known - failed, failed, missing);
  return failed + missing == 0 ? kEngraved : kCheckFailed;
}

/// Joins what the processes of a batch have written.
int merge(const BatchOptions& options, const BatchPlan& plan) {
  const auto folder = BatchFolder::open(options.folder, {});
  if (!folder) return printError(folder.error());
  std::size_t next = 1, told = 0, lost = 0;
  const auto tellMissing = [&](std::size_t end) {
    for (; next < end && told < BatchPlan::kMostProblems; ++next, ++told)
      fmt::print(stderr, "qrelief: row {} ({}) is missing\n", next, plan.row(next - 1).id);
  };
  const Status read = folder->forEach([&](const ManifestEntry& entry) -> Status {
    if (entry.number > plan.size()) return {};
    tellMissing(entry.number);
    next = entry.number + 1;
    if (entry.status != RowStatus::Done) return {};
    const auto known = folder->known(entry);
    if (known.state == BatchFolder::Known::State::Done) return {};
    fmt::print(stderr, "qrelief: row {}: {} {}\n", entry.number, entry.file,
               known.state == BatchFolder::Known::State::Changed ? "was changed" : "is not there");
    ++lost;
    return {};
  });
  if (!read) return printError(read.error());
  tellMissing(plan.size() + 1);
  const std::vector<std::size_t> doubles = folder->doubles();
  for (const std::size_t number : doubles) fmt::print(stderr, "qrelief: row {} was made by two shares\n", number);
  const int status = finish(*folder, plan);
  return lost == 0 ? status : kCheckFailed;
}

int runRows(const BatchOptions& options, const GivenShard& given, const BatchRequest& request, BatchList list) {
  const BatchPlan plan = BatchPlan::make(std::move(list), request);
  if (!plan.problems().empty()) return printProblems(plan, options.list);
  if (!plan.unusedColumns().empty())
    fmt::print(stderr, "qrelief: warning: columns that nothing asks for: {}\n", fmt::join(plan.unusedColumns(), ", "));
  if (options.merge) return merge(options, plan);
  auto folder = BatchFolder::open(options.folder, given.shard);
  if (!folder) return printError(folder.error());
  if (!given.shard.isWhole())
    fmt::print(stderr, "share {} of {} ({})\n", given.shard.index, given.shard.count, given.from);
  BatchRun run(options, std::move(*folder));
  EngraveRequest first = plan.row(0).request;
  if (const Status prepared = run.prepare(first); !prepared) return printError(prepared.error(), options.model.path);

  const auto start = Clock::now();
  const std::size_t together = std::max<std::size_t>(options.perPlate, 1);
  const std::size_t units = (plan.size() + together - 1) / together;
  std::size_t mine = 0, at = 0;
  for (std::size_t unit = given.shard.index; unit < units; unit += given.shard.count)
    mine += std::min(together, plan.size() - unit * together);
  for (std::size_t unit = given.shard.index; unit < units; unit += given.shard.count) {
    std::vector<BatchRow> rows;
    for (std::size_t i = unit * together; i < std::min((unit + 1) * together, plan.size()); ++i)
      rows.push_back(plan.row(i));
    const std::size_t keptBefore = run.kept();
    const auto entries = run.make(std::move(rows), first, options.perPlate > 0 ? plateName(unit, units) : "");
    if (!entries) return printError(entries.error());
    at += entries->size();
    if (options.quiet || run.kept() > keptBefore) continue;
    const double seconds = millisecondsSince(start) / 1000;
    const auto done = static_cast<double>(run.made() + run.failed());
    for (const ManifestEntry& entry : *entries)
      fmt::print(stderr, "{}/{} {}: {}{}; {} left\n", at, mine, entry.id, rowStatusName(entry.status),
                 entry.reason.empty() ? "" : ", " + entry.reason,
                 durationInWords(seconds / done * static_cast<double>(mine - at)));
  }
  if (given.shard.isWhole()) return finish(run.folder(), plan);
  fmt::print("{} rows of {}: {} made now, {} before, {} failed\n", mine, plan.size(), run.made(), run.kept(),
             run.failed());
  return run.failed() == 0 ? kEngraved : kCheckFailed;
}

/// A stream's request as a row. @param number  of the row, if its name is not one that the folder knows
Result<BatchRow> rowOf(const std::string& line, BatchRequest request, std::size_t number) {
  auto list = readBatchList(std::span(reinterpret_cast<const std::uint8_t*>(line.data()), line.size()));
  if (!list) return tl::unexpected(list.error());
  request.firstNumber = number;
  const BatchPlan plan = BatchPlan::make(std::move(*list), request);
  if (!plan.problems().empty()) return fail(ErrorKind::BadInput, plan.problems().front());
  return plan.row(0);
}

/// Requests as they come, one JSON object a line, and an answer to each: its line of the manifest. The numbers go on
/// where the folder's end; a request whose file is there already is answered by what was said of it.
int runStream(const BatchOptions& options, const BatchRequest& request) {
  auto folder = BatchFolder::open(options.folder, {});
  if (!folder) return printError(folder.error());
  std::map<std::string, std::pair<std::size_t, std::string>> known;  // number and text by file
  std::size_t next = 1;
  const Status read = folder->forEach([&](const ManifestEntry& entry) -> Status {
    known[entry.file] = {entry.number, entry.text};
    next = entry.number + 1;
    return {};
  });
  if (!read) return printError(read.error());
  BatchRun run(options, std::move(*folder));
  std::optional<EngraveRequest> placed;
  for (std::string line; std::getline(std::cin, line);) {
    auto row = rowOf(line, request, next);
    const auto same = row ? known.find(row->file) : known.end();
    if (same != known.end() && same->second.second != row->request.text)
      row = fail(ErrorKind::BadInput,
                 message("name-taken", with::quoted("name", row->file), with::quoted("text", same->second.second)));
    if (!row) {
      ManifestEntry refused;
      refused.number = next;
      refused.status = RowStatus::Refused;
      refused.reason = sentenceAndHint(row.error().message);
      std::cout << manifestLine(refused) << std::endl;
      continue;
    }
    if (!placed) {
      placed = row->request;
      if (const Status prepared = run.prepare(*placed); !prepared)
        return printError(prepared.error(), options.model.path);
    }
    if (same != known.end())
      row->number = same->second.first;
    else
      known[row->file] = {next++, row->request.text};
    const auto entries = run.make({*row}, *placed);
    if (!entries) return printError(entries.error());
    std::cout << manifestLine(entries->front()) << std::endl;  // whoever asks waits for it
  }
  return run.failed() == 0 ? kEngraved : kCheckFailed;
}

int runBatch(const BatchOptions& options) {
  const auto all = options.flags.request();
  if (!all) return printError(all.error());
  const BatchRequest request{*all, options.name};
  if (options.stream) return runStream(options, request);
  const auto given = shardFrom(options.merge ? "0/1" : options.shardFlag, options.merge ? 0 : options.shards);
  if (!given) return printError(given.error());
  auto list = listOf(options);
  if (!list) return printError(list.error(), options.list);
  return runRows(options, *given, request, std::move(*list));
}

}  // namespace

std::function<int()> addBatchCommand(CLI::App& app) {
  auto o = std::make_shared<BatchOptions>();
  CLI::App* c = app.add_subcommand("batch", "Engrave a code of its own into every copy of a model");
  addModelFlags(*c, o->model);
  c->add_option("--list", o->list, "rows as CSV or JSON lines; - for standard input");
  c->add_option("--count", o->count, "this many rows without a list; {n} in --text is the number");
  o->flags.add(*c, "text", "template with columns in braces, {n:05} is the number in five digits [{text}]: ");
  c->add_option("-o", o->folder, "folder that everything is written to")->required();
  c->add_option("--name", o->name, "template of the files' names [{file}, if the list has it, else {id}.stl]");
  c->add_option("--at", o->at, "X,Y,Z: centre in file units, moved to the nearest surface point [best spot found]")
      ->delimiter(',')
      ->expected(3);
  c->add_option("--shard", o->shardFlag, "I/N: every N-th row, from the I-th on, counting from 0");
  c->add_option("--shards", o->shards, "N processes share the work; an engine's variable says which this is");
  c->add_option("--per-plate", o->perPlate, "3MF files of N named parts side by side; with --name, a file a row, too")
      ->check(CLI::PositiveNumber);
  c->add_option("--print-every", o->printEvery,
                "look at the print of every N-th row only; all are carved for the print alike [1]")
      ->check(CLI::PositiveNumber);
  c->add_flag("--merge", o->merge, "join the manifests of all shares, and say what is missing or double");
  c->add_flag("--retry-failed", o->retryFailed, "try rows again that failed, and write over files that were changed");
  c->add_flag("--stream", o->stream, "answer each line of standard input by its line of the manifest, as it comes");
  c->add_flag("--reports", o->reports, "write each row's report, too, as FILE.json");
  c->add_flag("--quiet", o->quiet, "no progress");
  o->flags.addAll(*c);
  return [o] { return runBatch(*o); };
}

}  // namespace qrelief
