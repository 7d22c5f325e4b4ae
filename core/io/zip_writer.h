// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// Builds a ZIP archive in memory, deflated; the same content gives the same bytes (no time, no system in them).
///
///     ZipWriter zip;
///     zip.begin("a.txt"); zip.append("text"); …
///     Result<std::vector<std::uint8_t>> bytes = zip.finish();
class ZipWriter {
 public:
  ZipWriter();
  ~ZipWriter();

  /// Begins a file, and ends the one before.
  /// @param name  relative, ASCII, "/" between folders; each once
  void begin(std::string_view name);
  /// More of the file that was begun last; compressed at once, so that a large file never is in memory as a whole.
  void append(std::string_view content);
  /// Ends the archive; nothing may be called after it.
  /// @returns BadUsage if it grew beyond the 4 GB of the plain format
  Result<std::vector<std::uint8_t>> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace qrelief
