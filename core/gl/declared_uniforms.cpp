// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/declared_uniforms.h"

#include <algorithm>
#include <cctype>

namespace qrelief::gl {
namespace {

bool isNamed(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string withoutComments(std::string_view source) {
  std::string text;
  for (std::size_t at = 0; at < source.size();) {
    const std::string_view rest = source.substr(at);
    const std::string_view end = rest.starts_with("//") ? "\n" : rest.starts_with("/*") ? "*/" : "";
    if (end.empty()) {
      text += source[at++];
      continue;
    }
    text += ' ';  // a comment separates two words
    const std::size_t close = source.find(end, at + 2);
    if (close == std::string_view::npos) break;
    at = close + (end == "*/" ? 2 : 0);
  }
  return text;
}

/// Returns the last word of a declarator such as `highp sampler2D u_map` or ` u_lamps[2]`, before its brackets.
std::string nameOf(std::string_view declarator) {
  declarator = declarator.substr(0, declarator.find('['));
  while (!declarator.empty() && !isNamed(declarator.back())) declarator.remove_suffix(1);
  std::size_t first = declarator.size();
  while (first > 0 && isNamed(declarator[first - 1])) --first;
  return std::string(declarator.substr(first));
}

}  // namespace

std::vector<std::string> declaredUniforms(std::string_view source) {
  constexpr std::string_view kKeyword = "uniform";
  const std::string text = withoutComments(source);
  std::vector<std::string> names;
  for (std::size_t at = text.find(kKeyword); at != std::string::npos; at = text.find(kKeyword, at + 1)) {
    const std::size_t from = at + kKeyword.size();
    if ((at > 0 && isNamed(text[at - 1])) || (from < text.size() && isNamed(text[from]))) continue;
    std::string_view declarators =
        std::string_view(text).substr(from, std::min(text.find(';', from), text.size()) - from);
    while (!declarators.empty()) {
      const std::size_t comma = std::min(declarators.find(','), declarators.size());
      names.push_back(nameOf(declarators.substr(0, comma)));
      declarators.remove_prefix(std::min(comma + 1, declarators.size()));
    }
  }
  return names;
}

}  // namespace qrelief::gl
