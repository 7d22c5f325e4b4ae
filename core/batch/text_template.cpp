// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/text_template.h"

#include <algorithm>
#include <fmt/format.h>

#include "message_codes/batch.h"

namespace qrelief {
namespace {

constexpr std::size_t kMostDigits = 20;

bool isDigits(std::string_view text) { return !text.empty() && text.find_first_not_of("0123456789") == text.npos; }

tl::unexpected<Error> broken(std::string_view text, std::size_t at) {
  return fail(ErrorKind::BadUsage, message<"template-brace">(with::quoted<"text">(text), with::index<"byte">(at + 1)));
}

}  // namespace

Result<TextTemplate> TextTemplate::parse(std::string_view text) {
  TextTemplate result;
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c != '{' && c != '}') {
      plain += c;
      continue;
    }
    if (i + 1 < text.size() && text[i + 1] == c) {
      plain += c;
      ++i;
      continue;
    }
    const std::size_t end = text.find_first_of("{}", i + 1);
    if (c == '}' || end == text.npos || text[end] == '{') return broken(text, i);
    const std::string_view inside = text.substr(i + 1, end - i - 1);
    const std::string_view name = inside.substr(0, inside.find(':'));
    std::size_t digits = 0;
    if (name.size() < inside.size()) {
      const std::string_view width = inside.substr(name.size() + 1);
      if (!isDigits(width) || width.front() != '0' || width.size() > 3) return broken(text, i);
      digits = std::stoul(std::string(width));
      if (digits == 0 || digits > kMostDigits) return broken(text, i);
    }
    if (name.empty()) return broken(text, i);
    result.pieces_.push_back({std::move(plain)});
    plain.clear();
    result.pieces_.push_back({std::string(name), true, digits});
    if (std::find(result.names_.begin(), result.names_.end(), name) == result.names_.end())
      result.names_.emplace_back(name);
    i = end;
  }
  result.pieces_.push_back({std::move(plain)});
  return result;
}

Result<std::string> TextTemplate::filled(const std::function<std::string(std::string_view)>& valueOf) const {
  std::string text;
  for (const Piece& piece : pieces_) {
    if (!piece.isPlace) {
      text += piece.text;
      continue;
    }
    std::string value = valueOf(piece.text);
    if (piece.digits > 0) {
      if (!isDigits(value))
        return badInput(message<"template-no-number">(with::quoted<"name">(piece.text), with::quoted<"value">(value)));
      if (value.size() < piece.digits) value.insert(0, piece.digits - value.size(), '0');
    }
    text += value;
  }
  return text;
}

}  // namespace qrelief
