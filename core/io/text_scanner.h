// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace qrelief {

/// Returns the bytes as text, without a UTF-8 byte order mark.
std::string_view textOf(std::span<const std::uint8_t> bytes);

/// Returns the text with its ASCII letters in lower case.
std::string lowerCase(std::string_view text);

/// Returns the text without padding at its end: NUL bytes, which fill up a block, and Ctrl-Z, which marks the end under
/// DOS.
std::string_view withoutPadding(std::string_view text);

/// Walks through text word by word and counts lines: LF, CR LF and CR all end one. Ignores padding at the end
/// (withoutPadding()).
class TextScanner {
 public:
  /// @param comment  character that begins a comment at the start of a word; the comment ends with the line. 0 for none
  explicit TextScanner(std::string_view text, char comment = 0);

  /// Returns the next word on this or a later line; empty at the end of the text.
  std::string_view word();

  /// Returns the next word on this line; empty at its end.
  std::string_view wordOnLine();

  /// Returns the rest of this line, without its end, and moves to the next line.
  std::string_view restOfLine();

  bool atEnd() const { return position_ >= text_.size(); }
  std::size_t position() const { return position_; }  ///< bytes from the start of the text
  std::size_t line() const { return line_; }          ///< from 1

 private:
  void skipBlanks();
  bool takeLineEnd();

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  char comment_;
};

}  // namespace qrelief
