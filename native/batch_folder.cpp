// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/batch_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

#include "message_codes/batch.h"
#include "message_codes/command.h"
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
              message<"file-not-written">(with::term<"path">(path), with::term<"why">(std::strerror(errno))));
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

/// Removes an unfinished last line, left by a killed process, because it would spoil the next line.
Status dropUnfinishedLine(int file, const std::string& path) {
  std::array<char, 65536> block;
  const off_t size = ::lseek(file, 0, SEEK_END);
  if (size < 0) return notWritten(path);
  off_t end = size;
  while (end > 0) {
    const off_t begin = std::max<off_t>(0, end - static_cast<off_t>(block.size()));
    const ssize_t n = ::pread(file, block.data(), static_cast<std::size_t>(end - begin), begin);
    if (n != end - begin) return notWritten(path);
    const std::size_t lineEnd = std::string_view(block.data(), static_cast<std::size_t>(n)).rfind('\n');
    end = lineEnd == std::string_view::npos ? begin : begin + static_cast<off_t>(lineEnd) + 1;
    if (lineEnd != std::string_view::npos) break;
  }
  if (end < size && ::ftruncate(file, end) != 0) return notWritten(path);
  return {};
}

/// Returns true if the manifest may have rows of the share. Another share of the same count has none.
bool mayHaveRowsOf(const std::string& name, const Shard& shard) {
  return shard.isWhole() || name == manifestName(shard) || !name.ends_with(fmt::format("-of-{}.jsonl", shard.count));
}

tl::unexpected<Error> notRead(const std::string& name, Message problem) {
  return fail(ErrorKind::BadInput,
              message<"manifest-not-read">(with::quoted<"name">(name), with::cause<"problem">(std::move(problem))));
}

}  // namespace

BatchFolder::BatchFolder(BatchFolder&& other) noexcept
    : path_(std::move(other.path_)),
      own_(std::move(other.own_)),
      file_(std::exchange(other.file_, -1)),
      manifests_(std::move(other.manifests_)) {}

BatchFolder::~BatchFolder() {
  if (file_ >= 0) ::close(file_);  // releases the lock, too
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
    return fail(ErrorKind::BadInput, message<"batch-folder-in-use">(with::quoted<"name">(own)));
  QRELIEF_TRY(dropUnfinishedLine(folder.file_, own));
  QRELIEF_TRY(folder.readManifests(shard));
  return folder;
}

Status BatchFolder::readManifests(const Shard& shard) {
  std::vector<char> block(1 << 16);
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    if (!isManifest(name) || !mayHaveRowsOf(name, shard) || !entry.is_regular_file()) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    if (!stream) return notRead(name, message<"file-not-opened">(with::term<"why">(std::strerror(errno))));
    ManifestIndex& index = manifests_[name];
    while (stream) {
      stream.read(block.data(), static_cast<std::streamsize>(block.size()));
      index.read(std::string_view(block.data(), static_cast<std::size_t>(stream.gcount())));
      if (const std::size_t line = index.firstBadLine(); line > 0)
        return notRead(name, message<"manifest-line">(with::index<"line">(line)));
    }
  }
  return {};
}

Result<ManifestEntry> BatchFolder::entryAt(const std::string& name, const Line& line) const {
  // Open it each time: there may be more manifests than a process may have open files.
  const int file = name == own_ ? file_ : ::open(pathOf(name).c_str(), O_RDONLY | O_CLOEXEC);
  std::string text(line.bytes, '\0');
  const ssize_t n = file < 0 ? -1 : ::pread(file, text.data(), text.size(), static_cast<off_t>(line.begin));
  const std::string why = n < 0 ? std::strerror(errno) : "";
  if (file >= 0 && file != file_) ::close(file);
  if (n < 0) return notRead(name, message<"file-not-opened">(with::term<"why">(why)));
  auto entry = readManifestLine(std::string_view(text).substr(0, static_cast<std::size_t>(n)));
  if (!entry) return notRead(name, message<"file-changed">());
  return std::move(*entry);
}

/// Returns the hash of a file; none if the file does not exist, empty for no file.
std::optional<std::string> BatchFolder::hashOf(const std::string& file) const {
  if (file.empty()) return "";
  if (isPipe(pathOf(file))) return "pipe";  // the hash of no file
  const auto hash = sha256OfFile(pathOf(file));
  return hash ? std::optional(*hash) : std::nullopt;
}

EarlierRow BatchFolder::known(const ManifestEntry& planned) const {
  EarlierRow known;
  for (const auto& [name, index] : manifests_) {
    const auto it = index.lines().find(planned.number);
    if (it == index.lines().end()) continue;
    if (const auto listed = entryAt(name, it->second))
      known.add(*listed, planned, [&](const std::string& file) { return hashOf(file); });
  }
  return known;
}

void BatchFolder::removeOutdated(const ManifestEntry& failed) const {
  for (const auto& [name, index] : manifests_) {
    const auto it = index.lines().find(failed.number);
    if (it == index.lines().end()) continue;
    const auto entry = entryAt(name, it->second);
    if (!entry || entry->status != RowStatus::Done || entry->file != failed.file) continue;
    for (const auto& [made, hash] :
         {std::pair(entry->file, entry->sha256.output), std::pair(entry->second, entry->sha256.second)})
      if (!made.empty() && hashOf(made) == hash) ::unlink(pathOf(made).c_str());
  }
}

Status BatchFolder::append(const ManifestEntry& entry) {
  const std::string line = manifestLine(entry) + "\n";
  QRELIEF_TRY(writeWhole(file_, line, pathOf(own_)));
  manifests_[own_].read(line);
  return {};
}

/// Returns all lines, with lines about the same row next to each other.
std::vector<BatchFolder::Found> BatchFolder::found() const {
  std::vector<Found> all;
  std::size_t count = 0;
  for (const auto& [name, index] : manifests_) count += index.lines().size();
  all.reserve(count);
  for (const auto& [name, index] : manifests_)
    for (const auto& [number, line] : index.lines()) all.push_back({number, &name, line});
  std::stable_sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.number < b.number; });
  return all;
}

Status BatchFolder::forEach(const std::function<Status(const ManifestEntry&)>& visit) const {
  const std::vector<Found> all = found();
  for (auto it = all.begin(); it != all.end();) {
    auto best = it;
    for (const std::size_t number = it->number; it != all.end() && it->number == number; ++it)
      if (best->line.status != RowStatus::Done) best = it;
    const auto entry = entryAt(*best->name, best->line);
    QRELIEF_TRY(entry);
    QRELIEF_TRY(visit(*entry));
  }
  return {};
}

std::vector<std::size_t> BatchFolder::doubles() const {
  std::vector<std::size_t> twice;
  std::optional<std::size_t> done;
  for (const Found& line : found()) {
    if (*line.name == kWhole || line.line.status != RowStatus::Done) continue;  // merged from the others
    if (done == line.number && (twice.empty() || twice.back() != line.number)) twice.push_back(line.number);
    done = line.number;
  }
  return twice;
}

Status BatchFolder::writeManifest(std::size_t lastNumber) const {
  auto lines = AtomicFile::create(pathOf(kWhole)), table = AtomicFile::create(pathOf(kTable));
  if (!lines || !table) return tl::unexpected((lines ? table : lines).error());
  QRELIEF_TRY(table->write(manifestCsvHeader()));
  const Status written = forEach([&](const ManifestEntry& entry) -> Status {
    if (entry.number > lastNumber) return {};
    QRELIEF_TRY(lines->write(manifestLine(entry) + "\n"));
    return table->write(manifestCsvLine(entry));
  });
  if (!written) return written;
  QRELIEF_TRY(lines->finish());
  return table->finish();
}

}  // namespace qrelief
