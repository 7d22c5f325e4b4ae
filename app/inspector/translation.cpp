// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/translation.h"

#include <utility>

namespace qrelief {
namespace {

Translation& current() {
  static Translation translation;
  return translation;
}

}  // namespace

void setTranslation(Translation translation) { current() = std::move(translation); }

const char* translated(const char* english) {
  const auto it = current().find(std::string_view(english));
  return it == current().end() ? english : it->second.c_str();
}

std::vector<const char*> translated(std::span<const char* const> english) {
  std::vector<const char*> texts;
  for (const char* text : english) texts.push_back(translated(text));
  return texts;
}

}  // namespace qrelief
