// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// Opens a file for reading; BadInput if it cannot be opened or is larger than the parsers accept.
Result<std::ifstream> openFile(const std::string& path);

/// Returns true if the path leads to a pipe, which can be read only once.
bool isPipe(const std::string& path);

/// Reads a whole file; BadInput if it cannot be read or is larger than the parsers accept.
Result<std::vector<std::uint8_t>> readFile(const std::string& path);

/// A file written piece by piece under a temporary name in the same folder, so that half a file never has the final
/// name.
class AtomicFile {
 public:
  /// BadInput if no file of this name can be written.
  static Result<AtomicFile> create(const std::string& path);
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;

  Status write(std::string_view bytes);

  /// Gives the file its name once all of it is on the disk.
  Status finish();

 private:
  explicit AtomicFile(std::string path);
  Status writeNow(std::string_view bytes);
  Status flush();
  tl::unexpected<Error> failed() const;

  std::string path_, temporary_, waiting_;
  int file_ = -1;
};

/// Writes a whole file through an AtomicFile.
Status writeFileAtomically(const std::string& path, std::span<const std::uint8_t> bytes);
Status writeFileAtomically(const std::string& path, std::string_view text);

/// Returns the part of a path after the last slash.
std::string fileNameOf(const std::string& path);

}  // namespace qrelief
