// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/text_lines.h"

#include <array>

#include "io/read_model.h"
#include "message_codes/batch.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::size_t kBlockBytes = 1 << 16;

tl::unexpected<Error> lineTooLong(std::size_t line, std::size_t limit) {
  return badInput(message<"list-line-too-long">(with::index<"line">(line), with::count<"limit">(limit)));
}

}  // namespace

Result<std::vector<std::uint8_t>> readText(std::istream& stream, std::size_t mostLineBytes) {
  std::vector<std::uint8_t> bytes;
  std::array<char, kBlockBytes> block;
  std::size_t line = 1, lineBytes = 0;
  char before = 0;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    const auto count = static_cast<std::size_t>(stream.gcount());
    for (std::size_t i = 0; i < count; ++i) {
      const char c = block[i];
      if (c == '\n' || c == '\r') {
        line += c == '\n' && before == '\r' ? 0 : 1;
        lineBytes = 0;
      } else if (++lineBytes > mostLineBytes) {
        return lineTooLong(line, mostLineBytes);
      }
      before = c;
    }
    bytes.insert(bytes.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(count));
    if (bytes.size() > ReadLimits{}.maxBytes)
      return badInput(
          message<"file-too-large">(with::count<"bytes">(bytes.size()), with::count<"limit">(ReadLimits{}.maxBytes)));
  }
  return bytes;
}

/// Skips the rest of a line. @returns false if the stream ended before the line did
bool LineReader::skipRest() {
  std::streambuf& buffer = *stream_.rdbuf();
  for (int c = buffer.sbumpc(); c != std::streambuf::traits_type::eof(); c = buffer.sbumpc())
    if (c == '\n') return true;
  return false;
}

std::optional<Result<std::string>> LineReader::next() {
  if (isWithinLine_ && !skipRest()) return std::nullopt;
  isWithinLine_ = false;
  ++number_;
  std::string line;
  std::streambuf& buffer = *stream_.rdbuf();
  for (int c = buffer.sbumpc(); c != '\n'; c = buffer.sbumpc()) {
    if (c == std::streambuf::traits_type::eof()) {
      if (line.empty()) return std::nullopt;
      break;
    }
    line += static_cast<char>(c);
    if (line.size() <= most_) continue;
    isWithinLine_ = true;
    return lineTooLong(number_, most_);
  }
  return line;
}

}  // namespace qrelief
