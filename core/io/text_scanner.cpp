// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_scanner.h"

#include <algorithm>
#include <cstdint>

namespace qrelief {
namespace {

bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool isPadding(char c) { return c == '\0' || c == '\x1A'; }

}  // namespace

std::string_view textOf(std::span<const std::uint8_t> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

std::string_view withoutPadding(std::string_view text) {
  std::size_t end = text.size();
  while (end > 0 && (isPadding(text[end - 1]) || isBlank(text[end - 1]) || isLineEnd(text[end - 1]))) --end;
  const auto padding = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(end), text.end(), isPadding);
  return text.substr(0, static_cast<std::size_t>(padding - text.begin()));
}

TextScanner::TextScanner(std::string_view text, char comment) : text_(withoutPadding(text)), comment_(comment) {}

void TextScanner::skipBlanks() {
  while (position_ < text_.size() && isBlank(text_[position_])) ++position_;
  if (comment_ != 0 && position_ < text_.size() && text_[position_] == comment_)
    while (position_ < text_.size() && !isLineEnd(text_[position_])) ++position_;
}

bool TextScanner::takeLineEnd() {
  if (atEnd() || !isLineEnd(text_[position_])) return false;
  const bool wasReturn = text_[position_++] == '\r';
  if (wasReturn && position_ < text_.size() && text_[position_] == '\n') ++position_;
  ++line_;
  return true;
}

std::string_view TextScanner::wordOnLine() {
  skipBlanks();
  const std::size_t begin = position_;
  while (position_ < text_.size() && !isBlank(text_[position_]) && !isLineEnd(text_[position_])) ++position_;
  return text_.substr(begin, position_ - begin);
}

std::string_view TextScanner::word() {
  do skipBlanks();
  while (takeLineEnd());
  return wordOnLine();
}

std::string_view TextScanner::restOfLine() {
  const std::size_t begin = position_;
  while (position_ < text_.size() && !isLineEnd(text_[position_])) ++position_;
  const std::string_view rest = text_.substr(begin, position_ - begin);
  takeLineEnd();
  return rest;
}

}  // namespace qrelief
