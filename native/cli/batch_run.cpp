// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch_run.h"

#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/clock.h"
#include "batch/batch_layout.h"
#include "batch/plate_layout.h"
#include "cli/choose_spot.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "cli/unused_flags.h"
#include "delivery/carved_file.h"
#include "delivery/carved_objects.h"
#include "io/write_checked.h"
#include "message_codes/command.h"
#include "messages/sentences.h"
#include "native/files.h"
#include "native/sha256.h"
#include "native/zxing_decoder.h"

namespace qrelief {
namespace {

namespace fs = std::filesystem;

/// Returns everything that a row's output depends on beyond its request.
std::string otherSettings(const BatchOptions& options) {
  const RepairFlags& r = options.model.repair;
  return fmt::format("{} {} {} {} {}{}", options.model.units, options.model.scale.value_or(0), r.weldTolerance,
                     r.maxHole, fmt::join(r.without, ","), options.fileFlags.text());
}

std::vector<std::string> hashesOf(std::vector<std::string> texts) {
  for (std::string& text : texts) text = sha256(text);
  return texts;
}

}  // namespace

std::string modelPath(const BatchOptions& options, const std::string& model) {
  if (model.empty()) return options.model.path;
  const bool isFile = !options.list.empty() && options.list != kStandardStream;
  const fs::path folder = isFile ? fs::path(options.list).parent_path() : fs::path();
  return (folder / model).string();  // an absolute path stays
}

Status checkModel(const std::string& path) {
  if (isPipe(path)) return fail(ErrorKind::BadInput, message<"model-is-pipe">());
  const auto opened = openFile(path);
  QRELIEF_TRY(opened);
  return {};
}

Status BatchRun::use(const std::string& model, const EngraveRequest& first) {
  if (used_ == model) return {};
  used_.reset();
  ModelFlags flags = options_->model;
  flags.path = modelPath(*options_, model);
  QRELIEF_TRY(checkModel(flags.path));
  const auto hash = sha256OfFile(flags.path);
  QRELIEF_TRY(hash);
  input_ = *hash;
  auto loaded = loadEngravable(flags);
  QRELIEF_TRY(loaded);
  partNames_ = loaded->partNames;
  report_.fileName = fileNameOf(flags.path);
  report_.format = loaded->format;
  report_.scaleToMm = loaded->scaleToMm;
  if (!graphics_) graphics_.emplace(Graphics::open());
  report_.gl = graphics_->capabilities;
  report_.wording = commandWording();
  report_.reader = zxingName();
  engraver_.reset();
  model_ = EngravableModel::create(std::move(loaded->prepared), graphics_->pass);
  engraver_.emplace(model_);
  hasToldMoved_ = false;
  if (!places_.contains(model)) {
    EngraveRequest placed = first;
    if (!options_->at.empty())
      placed.placement.centreMm = Vec3(options_->at[0], options_->at[1], options_->at[2]) * report_.scaleToMm;
    else if (const Status chosen = chooseSpot(model_, placed, report_.scaleToMm, options_->quiet, stderr);
             !chosen)  // stdout is for answers
      return chosen;
    places_[model] = placed.placement;
  }
  used_ = model;
  return {};
}

Result<BatchRun::Made> BatchRun::refuse(std::vector<BatchRow> rows, const Message& why) {
  const BatchUnit unit = {std::move(rows), {}, isFiled(), {}, otherSettings(*options_)};
  Made result = {pendingEntries(unit, hashesOf(rowsToHash(unit, {}))), true};
  for (ManifestEntry& entry : result.entries) {
    entry.status = RowStatus::Failed;
    entry.reason = sentenceAndHint(why);
    QRELIEF_TRY(folder_.append(entry));
  }
  return result;
}

Result<BatchRun::Made> BatchRun::make(std::vector<BatchRow> rows, const std::string& plate) {
  const PlacementRequest& placed = places_.at(*used_);
  for (BatchRow& row : rows) {
    row.request.placement.centreMm = placed.centreMm;
    if (!row.request.placement.direction) row.request.placement.direction = placed.direction;
  }
  const BatchUnit unit = {std::move(rows), plate, isFiled(), input_, otherSettings(*options_)};
  Made result = {pendingEntries(unit, hashesOf(rowsToHash(unit, hashesOf(matesToHash(unit))))), false};
  std::vector<ManifestEntry> changed;
  for (ManifestEntry& entry : result.entries) {
    const EarlierRow known = folder_.known(entry);
    if (known.isOpen(options_->retryFailed)) {
      result.isNew = true;
    } else if (known.state == EarlierRow::State::Changed) {
      entry.reason = sentenceAndHint(message<"file-changed">());
      changed.push_back(entry);
    } else {
      entry = known.entry;
    }
  }
  if (result.isNew) QRELIEF_TRY(carveAll(unit, result.entries));
  for (const ManifestEntry& entry : result.isNew ? result.entries : changed) QRELIEF_TRY(folder_.append(entry));
  return result;
}

/// Returns true if each row has a file of its own.
bool BatchRun::isFiled() const { return options_->perPlate == 0 || !options_->name.empty(); }

/// Carves rows and fills their entries. @returns an error only if nothing more can be written
Status BatchRun::carveAll(const BatchUnit& unit, std::vector<ManifestEntry>& entries) {
  const std::vector<BatchRow>& rows = unit.rows;
  std::vector<std::vector<ModelObject>> copies(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ManifestEntry& entry = entries[i];
    entry.status = RowStatus::Failed;
    entry.reason.clear();
    const auto carved = carve(rows[i], entry);
    if (!carved) {
      entry.reason = sentenceAndHint(carved.error().message);
      if (unit.hasOwnFiles) folder_.removeOutdated(entry);
      continue;
    }
    entry.status = RowStatus::Done;
    if (unit.plate.empty()) continue;
    const BatchRow& row = rows[i];
    copies[i] = namedCopy(carvedObjects(carved->result, partNames_, carved->request.marking.mark == Mark::Inlay, true),
                          row.id, row.request.code.text);
  }
  const std::vector<ModelObject> objects = onPlate(std::move(copies));
  if (objects.empty()) return {};
  const auto bytes = writeChecked(objects, ModelFormat::ThreeMf, options_->fileFlags.writeOptions(unit.plate));
  QRELIEF_TRY(bytes);
  QRELIEF_TRY(writeFileAtomically(folder_.pathOf(unit.plate), *bytes));
  for (ManifestEntry& entry : entries)
    if (entry.status == RowStatus::Done) (unit.hasOwnFiles ? entry.sha256.plate : entry.sha256.output) = sha256(*bytes);
  return {};
}

/// Carves a row, fills its entry, and writes its file if it has one. @returns an error if that fails
Result<Engraved> BatchRun::carve(const BatchRow& row, ManifestEntry& entry) {
  const auto start = Clock::now();
  const bool looksAtPrint = BatchLayout{.printEvery = options_->printEvery}.printsRow(row.number - options_->first);
  EngravePlan::Options plan{.looksAtPrint = looksAtPrint, .fixed = {"text"}, .chosen = options_->flags.given()};
  if (isFiled()) plan.otherMarks = marksInColour(formatOfName(row.file));
  auto engraved = engrave(*engraver_, row.request, plan);
  if (!engraved) return engraved;
  tellMoved(engraved->result);
  entry.details = describeRow({engraved->request, engraved->result, engraved->reading, engraved->printed,
                               engraved->verdict, millisecondsSince(start)});
  if (const std::vector<Message> failures = engraved->verdict.failed(); !failures.empty())
    return fail(ErrorKind::NoSolution, failures.front());
  if (isFiled()) {
    const auto encoded = encodeCarved(model_->prepared, engraved->result, row.file, partNames_,
                                      options_->fileFlags.writeOptions(row.id));
    QRELIEF_TRY(encoded);
    tellNotKept(encoded->notKept);
    for (const NamedFile& file : encoded->files) {
      QRELIEF_TRY(writeFileAtomically(folder_.pathOf(file.name), file.bytes));
      (file.name == row.file ? entry.sha256.output : entry.sha256.second) = sha256(file.bytes);
      if (file.name != row.file) entry.second = file.name;
    }
  }
  if (options_->reports) QRELIEF_TRY(writeReport(row, *engraved, millisecondsSince(start)));
  return engraved;
}

/// Prints once for each model that its surface lies far from --at.
void BatchRun::tellMoved(const EngraveResult& result) {
  if (hasToldMoved_ || options_->at.empty()) return;
  hasToldMoved_ = true;
  if (const auto moved = centreMoved(places_.at(*used_).centreMm, result.placement))
    printWarning(*moved, report_.fileName);
}

/// Prints once why the contents of the model's 3MF file are lost.
void BatchRun::tellNotKept(const std::optional<Message>& why) {
  if (!why || hasToldNotKept_) return;
  hasToldNotKept_ = true;
  printWarning(message<"3mf-not-kept">(with::cause<"cause">(*why)), {});
}

Status BatchRun::writeReport(const BatchRow& row, const Engraved& engraved, double totalMs) const {
  ReportContext context = report_;
  context.printed = engraved.printed;
  context.reading = engraved.reading;
  context.verdict = engraved.verdict;
  context.tried = engraved.tried;
  context.delivered = engraved.attempt;
  context.askedPreset = row.request.depth.preset;
  context.totalMs = totalMs;
  return writeFileAtomically(folder_.pathOf(row.file) + ".json",
                             makeReport(engraved.request, *model_, engraved.result, context));
}

}  // namespace qrelief
