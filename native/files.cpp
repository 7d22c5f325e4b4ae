// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/files.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>
#include <utility>

#include "io/read_model.h"
#include "message_codes/command.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::size_t kWaitingBytes = 1 << 20;  // size of a write

/// Reads what a pipe or a device holds; its size is not known before.
Result<std::vector<std::uint8_t>> readToEnd(std::ifstream& stream) {
  const std::size_t limit = ReadLimits{}.maxBytes;
  std::vector<std::uint8_t> bytes;
  std::vector<char> block(kWaitingBytes);
  while (stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    bytes.insert(bytes.end(), block.begin(), block.begin() + stream.gcount());
    if (bytes.size() > limit)
      return badInput(message<"file-too-large">(with::count<"bytes">(bytes.size()), with::count<"limit">(limit)));
  }
  return bytes;
}

/// Returns the path of a temporary file in the same folder. Its name is short enough for every file system.
std::string temporaryName(const std::string& path) {
  static std::atomic<int> count{0};
  constexpr std::size_t kBeginning = 200;  // bytes of the name, to be recognised
  const std::size_t slash = path.rfind('/') + 1;
  return fmt::format("{}.{}.{}.part", path.substr(0, slash + kBeginning), ::getpid(), ++count);
}

/// Returns true if the path leads to a pipe, a device or a folder, which a new file must not replace.
bool isOther(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

/// Returns the path of the file that a symbolic link leads to, so that the link stays.
std::string withoutLinks(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  const std::filesystem::path file = std::filesystem::canonical(path, error);
  return error ? path : file.string();
}

/// Returns true if the name is longer than the folder's file system allows.
bool isNameTooLong(const std::string& path) {
  const std::size_t slash = path.rfind('/') + 1;
  const long longest = ::pathconf(slash == 0 ? "." : path.substr(0, slash).c_str(), _PC_NAME_MAX);
  return longest > 0 && path.size() - slash > static_cast<std::size_t>(longest);
}

}  // namespace

bool isPipe(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_type type = std::filesystem::status(path, error).type();
  return type == std::filesystem::file_type::fifo || type == std::filesystem::file_type::socket;
}

Result<std::ifstream> openFile(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return fail(ErrorKind::BadInput, message<"path-is-folder">());
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return fail(ErrorKind::BadInput, message<"file-not-opened">(with::term<"why">(std::strerror(errno))));
  const auto size = std::filesystem::file_size(path, error);
  if (!error && size > ReadLimits{}.maxBytes)
    return fail(ErrorKind::BadInput,
                message<"file-too-large">(with::count<"bytes">(size), with::count<"limit">(ReadLimits{}.maxBytes)));
  return stream;
}

Result<std::vector<std::uint8_t>> readFile(const std::string& path) {
  Result<std::ifstream> stream = openFile(path);
  QRELIEF_TRY(stream);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return readToEnd(*stream);
  const auto size = std::filesystem::file_size(path, error);
  std::vector<std::uint8_t> bytes(error ? 0 : static_cast<std::size_t>(size));
  stream->read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::size_t>(stream->gcount()) != bytes.size())
    return fail(ErrorKind::BadInput, message<"file-ended-early">(with::count<"read">(stream->gcount()),
                                                                 with::count<"announced">(bytes.size())));
  return bytes;
}

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), temporary_(temporaryName(path_)) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      waiting_(std::move(other.waiting_)),
      file_(std::exchange(other.file_, -1)) {}

AtomicFile::~AtomicFile() {
  if (file_ < 0) return;
  ::close(file_);
  ::unlink(temporary_.c_str());
}

tl::unexpected<Error> AtomicFile::failed() const {
  return fail(ErrorKind::BadInput,
              message<"file-not-written">(with::term<"path">(path_), with::term<"why">(std::strerror(errno))));
}

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  AtomicFile file(withoutLinks(path));
  std::error_code error;
  errno = std::filesystem::is_directory(path, error) ? EISDIR : isNameTooLong(path) ? ENAMETOOLONG : 0;
  if (errno != 0) return file.failed();
  if (isOther(path)) return fail(ErrorKind::BadInput, message<"output-is-no-file">(with::term<"path">(path)));
  file.file_ = ::open(file.temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file.file_ < 0) return file.failed();
  return file;
}

Status AtomicFile::writeNow(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return failed();
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return {};
}

Status AtomicFile::flush() {
  QRELIEF_TRY(writeNow(waiting_));
  waiting_.clear();
  return {};
}

Status AtomicFile::write(std::string_view bytes) {
  if (waiting_.size() + bytes.size() < kWaitingBytes) {
    waiting_ += bytes;
    return {};
  }
  QRELIEF_TRY(flush());
  return writeNow(bytes);
}

Status AtomicFile::finish() {
  QRELIEF_TRY(flush());
  if (::fsync(file_) != 0 || std::rename(temporary_.c_str(), path_.c_str()) != 0) return failed();
  ::close(std::exchange(file_, -1));
  return {};
}

Status writeFileAtomically(const std::string& path, std::string_view text) {
  auto file = AtomicFile::create(path);
  QRELIEF_TRY(file);
  QRELIEF_TRY(file->write(text));
  return file->finish();
}

Status writeFileAtomically(const std::string& path, std::span<const std::uint8_t> bytes) {
  return writeFileAtomically(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::string fileNameOf(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace qrelief
