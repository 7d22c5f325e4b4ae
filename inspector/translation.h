// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace qrelief {

/// Texts of the page's language by their English ones; formats keep their places ({}) and their order.
using Translation = std::map<std::string, std::string, std::less<>>;

/// What `translated` answers from now on, in the whole module. Empty: English. What was answered before is void.
void setTranslation(Translation translation);

/// The text in the page's language; English where that has none.
const char* translated(const char* english);

/// The same of each.
std::vector<const char*> translated(std::span<const char* const> english);

/// A translated text with values in it. Its places are checked when it is compiled, those of the translations by a test
/// (web/i18n/inspector_texts.test.js).
template <class... Args>
std::string phrase(fmt::format_string<Args...> english, Args&&... args) {
  const fmt::string_view text = english;
  const std::string key(text.data(), text.size());
  return fmt::vformat(translated(key.c_str()), fmt::make_format_args(args...));
}

}  // namespace qrelief
