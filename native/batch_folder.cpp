// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/batch_folder.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <set>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

#include "native/files.h"
#include "native/sha256.h"

namespace qrelief {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWhole = "manifest.jsonl";
constexpr const char* kTable = "manifest.csv";

std::string manifestName(const Shard& shard) {
  return shard.isWhole() ? kWhole : fmt::format("manifest.{}.jsonl", shard.name());
}

bool isManifest(const std::string& name) { return name.starts_with("manifest.") && name.ends_with(".jsonl"); }

tl::unexpected<Error> notWritten(const std::string& path) {
  return fail(ErrorKind::BadInput,
              message("file-not-written", with::term("path", path), with::term("why", std::strerror(errno))));
}

Status writeWhole(int file, std::string_view text, const std::string& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return notWritten(path);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fdatasync(file) == 0 ? Status() : notWritten(path);
}

/// What a process that was ended has left behind the last line's end would spoil the next line.
Status dropUnfinishedLine(int file, const std::string& path) {
  const auto bytes = readFile(path);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  const std::size_t end = text.rfind('\n');
  const std::size_t whole = end == text.npos ? 0 : end + 1;
  if (whole < text.size() && ::ftruncate(file, static_cast<off_t>(whole)) != 0) return notWritten(path);
  return {};
}

}  // namespace

BatchFolder::BatchFolder(BatchFolder&& other) noexcept
    : path_(std::move(other.path_)),
      own_(std::move(other.own_)),
      file_(std::exchange(other.file_, -1)),
      manifests_(std::move(other.manifests_)) {}

BatchFolder::~BatchFolder() {
  if (file_ >= 0) ::close(file_);  // and with it the lock
}

Result<BatchFolder> BatchFolder::open(const std::string& path, const Shard& shard) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!fs::is_directory(path)) {
    errno = error ? error.value() : ENOTDIR;
    return notWritten(path);
  }
  BatchFolder folder;
  folder.path_ = path;
  folder.own_ = manifestName(shard);
  const std::string own = folder.pathOf(folder.own_);
  folder.file_ = ::open(own.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (folder.file_ < 0) return notWritten(own);
  if (::flock(folder.file_, LOCK_EX | LOCK_NB) != 0)
    return fail(ErrorKind::BadInput, message("batch-folder-in-use", with::quoted("name", own)));
  if (const Status clean = dropUnfinishedLine(folder.file_, own); !clean) return tl::unexpected(clean.error());
  if (const Status read = folder.readManifests(); !read) return tl::unexpected(read.error());
  return folder;
}

Status BatchFolder::readManifests() {
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    if (!isManifest(name)) continue;
    const auto bytes = readFile(entry.path().string());
    if (!bytes) return tl::unexpected(bytes.error());
    auto rows = readManifest({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (!rows)
      return fail(rows.error().kind, message("manifest-not-read", with::quoted("name", name),
                                             with::cause("problem", rows.error().message)));
    manifests_[name] = std::move(*rows);
  }
  return {};
}

/// @returns none if it is not there; empty for no file
std::optional<std::string> BatchFolder::hashOf(const std::string& file) const {
  if (file.empty()) return "";
  const auto hash = sha256OfFile(pathOf(file));
  return hash ? std::optional(*hash) : std::nullopt;
}

BatchFolder::Known BatchFolder::known(const ManifestEntry& wanted) const {
  Known best;
  for (const auto& [name, rows] : manifests_) {
    const auto found = rows.find(wanted.number);
    if (found == rows.end()) continue;
    const ManifestEntry& entry = found->second;
    if (entry.file != wanted.file || entry.plate != wanted.plate || entry.sha256.input != wanted.sha256.input ||
        entry.sha256.settings != wanted.sha256.settings)
      continue;
    if (entry.status != RowStatus::Done) {
      if (best.state == Known::State::New) best = {Known::State::Failed, entry};
      continue;
    }
    const auto file = hashOf(entry.file), plate = hashOf(entry.plate);
    if (!file || !plate) continue;  // it is not there any more: made again
    if (*file == entry.sha256.output && *plate == entry.sha256.plate) return {Known::State::Done, entry};
    best = {Known::State::Changed, entry};
  }
  return best;
}

Status BatchFolder::append(const ManifestEntry& entry) {
  manifests_[own_][entry.number] = entry;
  return writeWhole(file_, manifestLine(entry) + "\n", pathOf(own_));
}

std::map<std::size_t, ManifestEntry> BatchFolder::entries() const {
  std::map<std::size_t, ManifestEntry> all;
  for (const auto& [name, rows] : manifests_)
    for (const auto& [number, entry] : rows) {
      const auto [known, isNew] = all.try_emplace(number, entry);
      if (!isNew && known->second.status != RowStatus::Done) known->second = entry;
    }
  return all;
}

std::vector<std::size_t> BatchFolder::doubles() const {
  std::set<std::size_t> once, twice;
  for (const auto& [name, rows] : manifests_) {
    if (name == kWhole) continue;  // it was merged from the others
    for (const auto& [number, entry] : rows)
      if (entry.status == RowStatus::Done && !once.insert(number).second) twice.insert(number);
  }
  return {twice.begin(), twice.end()};
}

Status BatchFolder::writeManifest(const std::map<std::size_t, ManifestEntry>& entries) const {
  std::string lines;
  for (const auto& [number, entry] : entries) lines += manifestLine(entry) + "\n";
  if (const Status written = writeFileAtomically(pathOf(kWhole), lines); !written) return written;
  return writeFileAtomically(pathOf(kTable), manifestCsv(entries));
}

}  // namespace qrelief
