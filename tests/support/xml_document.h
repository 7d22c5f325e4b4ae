// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace qrelief {

/// An XML element with names as they are in the file, prefixes included, as slicers compare them.
struct XmlNode {
  std::string name, text;
  std::map<std::string, std::string> attributes;
  std::vector<XmlNode> children;

  /// Returns an attribute; empty if it is missing.
  std::string operator[](const std::string& attribute) const;
  /// Returns the children of that name.
  std::vector<const XmlNode*> all(std::string_view tag) const;
  /// Returns the first child of that name; an empty node if there is none.
  const XmlNode& first(std::string_view tag) const;
};

/// Parses a document; throws std::runtime_error if it is not well-formed.
XmlNode parsedXml(const std::string& text);

/// Returns the files of an archive by name; empty if it is damaged.
std::map<std::string, std::string> unzipped(std::span<const std::uint8_t> bytes);

}  // namespace qrelief
