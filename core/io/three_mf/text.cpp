// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/text.h"

#include <algorithm>

#include "base/utf8.h"
#include "io/three_mf/xml_tags.h"

namespace qrelief {
namespace {

/// Cura counts extruders from 0. The prefix is part of the name.
constexpr std::string_view kCuraExtruder = "cura:extruder_nr";

/// Returns true for characters that UTF-8 can hold but XML 1.0 cannot: U+FFFE and U+FFFF.
bool isNoCharacter(std::string_view sequence) { return sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF"; }

}  // namespace

std::string curaExtruder(std::size_t filament, std::string_view prefix) {
  return fmt::format(
      "   <{0}metadatagroup><{0}metadata name=\"{1}\" preserve=\"1\" type=\"xs:integer\">{2}</{0}metadata>"
      "</{0}metadatagroup>\n",
      prefix, kCuraExtruder, filament - 1);
}

std::size_t curaFilament(std::string_view model, std::size_t object) {
  const auto span = findElement(model, "object", object);
  XmlTags tags(span ? model.substr(span->inside, span->insideEnd - span->inside) : "");
  while (const auto tag = tags.next())
    if (tag->starts("metadata") && tag->attribute("name") == kCuraExtruder)
      return 1 + numberFrom(model.substr(span->inside + tag->end));
  return 1;
}

std::string transformText(const Affine& transform) {
  std::string text;
  for (const Vec3 row : {transform.x, transform.y, transform.z, transform.origin})
    for (int axis = 0; axis < 3; ++axis)
      text += fmt::format("{}{}", text.empty() ? "" : " ", row[axis] + 0.0);  // no −0
  return text;
}

std::string escapedXml(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8SequenceLength(text);
    const char c = text.front();
    if (length > 1 && isNoCharacter(text.substr(0, length)))
      result += "???";
    else if (length > 1)
      result += text.substr(0, length);
    else if (length == 0 || (c >= 0 && c < ' '))
      result += '?';
    else if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace qrelief
