// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// Reads a whole text, but stops at the first line that is too long. Of a file that is a single line of a gigabyte, it
/// reads at most `mostLineBytes`.
/// @param stream  lines end with LF, CR LF or CR
/// @returns BadInput that names the long line, or if the text is larger than the parsers accept
Result<std::vector<std::uint8_t>> readText(std::istream& stream, std::size_t mostLineBytes);

/// Reads lines as they come. Uses memory for one line of the accepted length.
class LineReader {
 public:
  /// @param stream  lines end with LF
  LineReader(std::istream& stream, std::size_t mostLineBytes) : stream_(stream), most_(mostLineBytes) {}

  /// Returns the next line without its end; none at the end of the stream. Refuses a line as soon as it is too long;
  /// the call after that skips its rest.
  std::optional<Result<std::string>> next();

 private:
  bool skipRest();

  std::istream& stream_;
  std::size_t most_;
  std::size_t number_ = 0;
  bool isWithinLine_ = false;
};

}  // namespace qrelief
