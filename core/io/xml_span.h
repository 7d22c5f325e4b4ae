// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "io/xml_tags.h"

namespace qrelief {

/// Byte range of an element in an XML text, with both tags.
struct XmlSpan {
  std::size_t begin = 0, inside = 0, insideEnd = 0, end = 0;  ///< inside: between the two tags
};

/// Finds the first element with that name and id at or after `from`, and before `to`. Such elements must not nest.
std::optional<XmlSpan> findElement(std::string_view text, std::string_view name, std::size_t id, std::size_t from = 0,
                                   std::size_t to = std::string_view::npos);

/// Returns the value of `<metadata key value>` in a slicer's settings, for an object, part or volume itself and not for
/// a part or volume within it.
std::optional<std::string_view> metadataOf(std::string_view text, const XmlSpan& element, std::string_view key);

/// Returns the number at the start of a text; 0 if there is none.
std::size_t numberFrom(std::optional<std::string_view> text);

/// Returns the prefix of a tag's name, with a colon.
std::string_view prefixOf(const XmlTag& tag);

}  // namespace qrelief
