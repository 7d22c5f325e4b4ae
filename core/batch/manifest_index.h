// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "batch/manifest.h"

namespace qrelief {

/// The positions of a manifest's lines: of each row, the last one counts. An unfinished last line, left by a process or
/// page that was killed, does not count. A million rows take 80 MB.
class ManifestIndex {
 public:
  /// Position of a line, without its end.
  struct Line {
    std::uint64_t begin = 0;
    std::uint32_t bytes = 0;
    RowStatus status = RowStatus::Failed;
  };

  /// Reads the next bytes of the manifest. @param visit  gets each line that they complete
  void read(std::string_view bytes, const std::function<void(const ManifestEntry&)>& visit = {});

  /// Returns the last line about each row, by the row's number.
  const std::map<std::size_t, Line>& lines() const { return lines_; }

  /// Returns the number, from 1, of the first line that is not one of a manifest; 0: none so far.
  std::size_t firstBadLine() const { return firstBad_; }

 private:
  void add(std::string_view line, const std::function<void(const ManifestEntry&)>& visit);

  std::map<std::size_t, Line> lines_;
  std::string rest_;          // begin of an unfinished line
  std::uint64_t begin_ = 0;   // of the current line
  std::size_t count_ = 0;     // of lines
  std::size_t firstBad_ = 0;  // counts from 1
};

}  // namespace qrelief
