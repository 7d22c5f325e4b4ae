// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "io/xml_tags.h"

namespace qrelief {

/// Bytes of an XML text that an element takes, from its first to after its last tag.
struct XmlSpan {
  std::size_t begin = 0, inside = 0, insideEnd = 0, end = 0;  ///< inside: between the two tags
};

/// Finds the first element of a name and id at or after `from`, and before `to`. Such elements must not nest.
std::optional<XmlSpan> findElement(std::string_view text, std::string_view name, std::size_t id, std::size_t from = 0,
                                   std::size_t to = std::string_view::npos);

/// Returns the value of `<metadata key value>` in a slicer's settings, of an object, part or volume itself: before the
/// first part or volume in it.
std::optional<std::string_view> metadataOf(std::string_view text, const XmlSpan& element, std::string_view key);

/// Returns the number that a text begins with; 0 if there is none.
std::size_t numberFrom(std::optional<std::string_view> text);

/// Returns the prefix of a tag's name, with a colon.
std::string_view prefixOf(const XmlTag& tag);

}  // namespace qrelief
