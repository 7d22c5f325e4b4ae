// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/clock.h"
#include "batch/plate_layout.h"
#include "cli/choose_spot.h"
#include "cli/commands.h"
#include "io/write_checked.h"
#include "messages/sentences.h"
#include "native/files.h"
#include "native/sha256.h"
#include "native/zxing_decoder.h"
#include "pipeline/carved_objects.h"

namespace qrelief {
namespace {

/// Returns everything that a row's output depends on beyond its request.
std::string otherSettings(const BatchOptions& options) {
  const RepairFlags& r = options.model.repair;
  return fmt::format("{} {} {} {} {}", options.model.units, options.model.scale.value_or(0), r.weldTolerance, r.maxHole,
                     fmt::join(r.without, ","));
}

}  // namespace

Status BatchRun::prepare(EngraveRequest& all) {
  const auto hash = sha256OfFile(options_->model.path);
  if (!hash) return tl::unexpected(hash.error());
  input_ = *hash;
  auto loaded = loadEngravable(options_->model);
  if (!loaded) return tl::unexpected(loaded.error());
  partNames_ = loaded->partNames;
  report_.fileName = fileNameOf(options_->model.path);
  report_.format = loaded->format;
  report_.scaleToMm = loaded->scaleToMm;
  graphics_ = Graphics::open();
  report_.gl = graphics_.capabilities;
  report_.wording = commandWording();
  report_.reader = zxingName();
  model_ = EngravableModel::create(std::move(loaded->prepared), graphics_.pass);
  auto engraver = Engraver::create(model_);
  if (!engraver) return tl::unexpected(engraver.error());
  engraver_.emplace(std::move(*engraver));
  if (!options_->at.empty()) {
    all.placement.centreMm = Vec3(options_->at[0], options_->at[1], options_->at[2]) * report_.scaleToMm;
    return {};
  }
  return chooseSpot(model_, all, report_.scaleToMm, options_->quiet, stderr);  // stdout is for answers
}

Result<std::vector<ManifestEntry>> BatchRun::make(std::vector<BatchRow> rows, const EngraveRequest& placed,
                                                  const std::string& plate) {
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

/// Returns true if each row has a file of its own.
bool BatchRun::isFiled() const { return options_->perPlate == 0 || !options_->name.empty(); }

/// Carves rows and fills their entries. @returns an error only if nothing more can be written
Status BatchRun::carveAll(const std::vector<BatchRow>& rows, std::vector<ManifestEntry>& entries,
                          const std::string& plate) {
  std::vector<ModelObject> objects;
  const std::vector<Vec3> offsets = plateOffsets(model_->box, rows.size());
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
    const BatchRow& row = rows[i];
    for (ModelObject& object : copyOnPlate(carvedObjects(carved->result, partNames_, row.request.inlay), row.id,
                                           row.request.text, offsets[i]))
      objects.push_back(std::move(object));
  }
  if (objects.empty()) return {};
  const auto bytes = writeChecked(objects, ModelFormat::ThreeMf, {.title = plate});
  if (!bytes) return tl::unexpected(bytes.error());
  if (const Status written = writeFileAtomically(folder_.pathOf(plate), *bytes); !written) return written;
  for (ManifestEntry& entry : entries)
    if (entry.status == RowStatus::Done) (isFiled() ? entry.sha256.plate : entry.sha256.output) = sha256(*bytes);
  return {};
}

/// Carves a row, fills its entry, and writes its file if it has one. @returns an error if that fails
Result<Engraved> BatchRun::carve(const BatchRow& row, ManifestEntry& entry) {
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
    if (const Status written = writeReport(row, *engraved, millisecondsSince(start)); !written)
      return tl::unexpected(written.error());
  return engraved;
}

Status BatchRun::writeReport(const BatchRow& row, const Engraved& engraved, double totalMs) const {
  ReportContext context = report_;
  context.printed = engraved.printed;
  context.reading = engraved.reading;
  context.verdict = engraved.verdict;
  context.askedPreset = row.request.preset;
  context.totalMs = totalMs;
  return writeFileAtomically(folder_.pathOf(row.file) + ".json",
                             makeReport(engraved.request, *model_, engraved.result, context));
}

}  // namespace qrelief
