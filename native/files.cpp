// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

#include "io/read_model.h"

namespace qrelief {
namespace {

/// Removes the temporary file unless it was kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
  ~TemporaryFile() {
    if (!kept_) ::unlink(path_.c_str());
  }
  const std::string& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  std::string path_;
  bool kept_ = false;
};

}  // namespace

Result<std::vector<std::uint8_t>> readFile(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return fail(ErrorKind::BadInput, message("path-is-folder"));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return fail(ErrorKind::BadInput, message("file-not-opened", with::term("why", std::strerror(errno))));
  const auto size = std::filesystem::file_size(path, error);
  if (!error && size > ReadLimits{}.maxBytes)
    return fail(ErrorKind::BadInput,
                message("file-too-large", with::count("bytes", size), with::count("limit", ReadLimits{}.maxBytes)));
  std::vector<std::uint8_t> bytes(error ? 0 : static_cast<std::size_t>(size));
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::size_t>(stream.gcount()) != bytes.size())
    return fail(ErrorKind::BadInput, message("file-ended-early", with::count("read", stream.gcount()),
                                             with::count("announced", bytes.size())));
  return bytes;
}

Status writeFileAtomically(const std::string& path, std::span<const std::uint8_t> bytes) {
  const auto failed = [&] {
    return fail(ErrorKind::BadInput,
                message("file-not-written", with::term("path", path), with::term("why", std::strerror(errno))));
  };
  TemporaryFile temporary(fmt::format("{}.{}.part", path, ::getpid()));
  const int file = ::open(temporary.path().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return failed();
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t n = ::write(file, bytes.data() + written, bytes.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const Status error = failed();
      ::close(file);
      return error;
    }
    written += static_cast<std::size_t>(n);
  }
  if (::close(file) != 0) return failed();
  if (std::rename(temporary.path().c_str(), path.c_str()) != 0) return failed();
  temporary.keep();
  return {};
}

Status writeFileAtomically(const std::string& path, const std::string& text) {
  return writeFileAtomically(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::string fileNameOf(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace qrelief
