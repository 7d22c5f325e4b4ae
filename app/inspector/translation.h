// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace qrelief {

/// Texts of the page's language, keyed by the English ones. Formats keep their fields ({}) and the order of the fields.
using Translation = std::map<std::string, std::string, std::less<>>;

/// Sets the translation for the whole module. Empty: English. Pointers that `translated` returned before become
/// invalid.
void setTranslation(Translation translation);

/// Returns the text in the page's language; the English text if there is no translation.
const char* translated(const char* english);

/// Translates each text.
std::vector<const char*> translated(std::span<const char* const> english);

/// Returns a translated text with values filled in. The compiler checks the fields of the English text; a test checks
/// those of the translations (web/i18n/inspector_texts.test.js).
template <class... Args>
std::string phrase(fmt::format_string<Args...> english, Args&&... args) {
  const fmt::string_view text = english;
  const std::string key(text.data(), text.size());
  return fmt::vformat(translated(key.c_str()), fmt::make_format_args(args...));
}

}  // namespace qrelief
