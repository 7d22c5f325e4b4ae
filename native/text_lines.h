// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// Reads all of a text, and stops at the first line that is too long: of a file that is one line of a gigabyte no more
/// than `mostLineBytes` are read.
/// @param stream  lines end with LF, CR LF or CR
/// @returns BadInput naming that line, or if the text is larger than the readers take
Result<std::vector<std::uint8_t>> readText(std::istream& stream, std::size_t mostLineBytes);

/// Reads lines as they come, in memory for one line of the accepted length.
class LineReader {
 public:
  /// @param stream  lines end with LF
  LineReader(std::istream& stream, std::size_t mostLineBytes) : stream_(stream), most_(mostLineBytes) {}

  /// The next line without its end; empty: there is none. A line that is too long is refused as soon as it is; the call
  /// after that passes over its rest.
  std::optional<Result<std::string>> next();

 private:
  bool skipRest();

  std::istream& stream_;
  std::size_t most_;
  std::size_t number_ = 0;
  bool isWithinLine_ = false;
};

}  // namespace qrelief
