// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/xml_tags.h"

#include <algorithm>
#include <charconv>

#include "io/parse_number.h"

namespace qrelief {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::size_t kNowhere = std::string_view::npos;

/// Returns the end of a tag that begins at `at`: after its ">", which no quotes enclose.
std::size_t endOfTag(std::string_view text, std::size_t at) {
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return at + 1;
    }
  }
  return kNowhere;
}

/// Returns the end of what begins with "<" and is no tag; `at` itself for a tag.
std::size_t endOfOther(std::string_view text, std::size_t at) {
  struct Kind {
    std::string_view begin, end;
  };
  for (const Kind& kind : {Kind{"<!--", "-->"}, Kind{"<![CDATA[", "]]>"}, Kind{"<?", "?>"}, Kind{"<!", ">"}}) {
    if (!text.substr(at).starts_with(kind.begin)) continue;
    const std::size_t end = text.find(kind.end, at + kind.begin.size());
    return end == kNowhere ? text.size() : end + kind.end.size();
  }
  return at;
}

}  // namespace

std::optional<XmlTag> XmlTags::next() {
  for (;;) {
    at_ = text_.find('<', at_);
    if (at_ == kNowhere) break;
    if (const std::size_t end = endOfOther(text_, at_); end != at_) {
      at_ = end;
      continue;
    }
    XmlTag tag;
    tag.begin = at_;
    tag.end = endOfTag(text_, at_);
    if (tag.end == kNowhere) break;
    tag.raw = text_.substr(tag.begin, tag.end - tag.begin);
    tag.isEnd = tag.raw.starts_with("</");
    tag.isEmpty = tag.raw.ends_with("/>");
    const std::size_t first = tag.isEnd ? 2 : 1;
    tag.name = tag.raw.substr(first, tag.raw.find_first_of(" \t\r\n/>", first) - first);
    if (const std::size_t colon = tag.name.find(':'); colon != kNowhere) tag.name.remove_prefix(colon + 1);
    at_ = tag.end;
    return tag;
  }
  at_ = text_.size();
  return std::nullopt;
}

std::vector<XmlTag::Attribute> XmlTag::attributes() const {
  std::vector<Attribute> all;
  std::size_t at = raw.find_first_of(kBlanks);
  while (at < raw.size()) {
    const std::size_t first = raw.find_first_not_of(kBlanks, at);
    const std::size_t equals = raw.find('=', at);
    if (first == kNowhere || equals == kNowhere) break;
    const std::size_t open = raw.find_first_of("\"'", equals);
    if (open == kNowhere) break;
    const std::size_t close = raw.find(raw[open], open + 1);
    if (close == kNowhere) break;
    std::string_view own = raw.substr(first, equals - first);
    if (const std::size_t blank = own.find_first_of(kBlanks); blank != kNowhere) own = own.substr(0, blank);
    all.push_back({own, raw.substr(open + 1, close - open - 1), begin + first, begin + close + 1, begin + open + 1});
    at = close + 1;
  }
  return all;
}

std::optional<std::string_view> XmlTag::attribute(std::string_view wanted) const {
  for (const Attribute& a : attributes())
    if (a.name == wanted) return a.value;
  return std::nullopt;
}

std::string edited(std::string_view text, std::vector<TextEdit> edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const TextEdit& a, const TextEdit& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t at = 0;
  for (const TextEdit& edit : edits) {
    result.append(text.substr(at, edit.begin - at)).append(edit.text);
    at = edit.end;
  }
  return result.append(text.substr(at));
}

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
