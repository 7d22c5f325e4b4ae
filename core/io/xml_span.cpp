// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/xml_span.h"

#include <charconv>

#include "io/parse_number.h"

namespace qrelief {

std::size_t numberFrom(std::optional<std::string_view> text) {
  std::size_t number = 0;
  const std::string_view digits = withoutBlanks(text.value_or(""));
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

std::string_view prefixOf(const XmlTag& tag) {
  const std::string_view name = tag.raw.substr(tag.isEnd ? 2 : 1);
  return name.substr(0, static_cast<std::size_t>(tag.name.data() - name.data()));
}

std::optional<XmlSpan> findElement(std::string_view text, std::string_view name, std::size_t id, std::size_t from,
                                   std::size_t to) {
  XmlTags tags(text.substr(0, to));
  std::optional<XmlSpan> element;
  while (const auto tag = tags.next()) {
    if (tag->begin < from) continue;
    if (!element && tag->starts(name) && numberFrom(tag->attribute("id")) == id) {
      element = XmlSpan{tag->begin, tag->end, tag->end, tag->end};
      if (tag->isEmpty) return element;
    } else if (element && tag->ends(name)) {
      element->insideEnd = tag->begin;
      element->end = tag->end;
      return element;
    }
  }
  return std::nullopt;
}

std::optional<std::string_view> metadataOf(std::string_view text, const XmlSpan& element, std::string_view key) {
  XmlTags tags(text.substr(element.inside, element.insideEnd - element.inside));
  while (const auto tag = tags.next()) {
    if (tag->starts("part") || tag->starts("volume")) break;
    if (tag->starts("metadata") && tag->attribute("key") == key) return tag->attribute("value");
  }
  return std::nullopt;
}

}  // namespace qrelief
