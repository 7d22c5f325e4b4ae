// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// Builds a ZIP archive in memory, deflated. The same content gives the same bytes (no time or system is recorded).
///
///     ZipWriter zip;
///     zip.begin("a.txt"); zip.append("text"); …
///     Result<std::vector<std::uint8_t>> bytes = zip.finish();
class ZipWriter {
 public:
  ZipWriter();
  ~ZipWriter();

  /// Begins a file and ends the previous one.
  /// @param name  relative, UTF-8, "/" between folders; use each name once
  void begin(std::string_view name);
  /// Appends to the current file. Compresses every 8 MiB, on all cores, so a large file is never in memory as a
  /// whole.
  void append(std::string_view content);
  /// Ends the archive; call nothing after it.
  /// @returns BadUsage if it grew beyond the 4 GB of the plain format
  Result<std::vector<std::uint8_t>> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace qrelief
