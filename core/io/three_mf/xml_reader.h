// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "io/zip_archive.h"

namespace qrelief {

/// A start tag; valid only during the handler's call.
class XmlElement {
 public:
  XmlElement(const char* name, const char* const* attributes);

  std::string_view space;  ///< namespace URI, empty for none
  std::string_view name;   ///< without prefix

  /// Returns an attribute without prefix.
  std::optional<std::string_view> attribute(std::string_view wanted) const;
  /// Returns an attribute of a namespace.
  std::optional<std::string_view> attribute(std::string_view uri, std::string_view wanted) const;
  /// Returns the number of attributes.
  std::size_t attributeCount() const;
  /// Returns true if an attribute has this name without its prefix.
  bool hasAttributeNamed(std::string_view wanted) const;

 private:
  const char* const* attributes_;
};

/// Receives the contents of an XML document in order. An error stops the parser.
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  /// Binds the prefix to that namespace from the next element on.
  virtual void declareSpace(std::string_view /*prefix*/, std::string_view /*uri*/) {}
  virtual Status startElement(const XmlElement& element) = 0;
  virtual Status endElement() { return {}; }
  /// Takes a piece of the text between two tags; there may be several.
  virtual void text(std::string_view /*piece*/) {}
};

/// Reads a part of a package by Expat, in bounded memory: one tag at a time, of at most 1 MB, and no more than 100 open
/// tags. Refuses a document type definition, as 3MF requires [core specification, 2.3.2].
/// @param part  its name, for messages
/// @returns BadInput naming part and line, also for what the handler refuses
Status readXml(ZipStream& stream, const std::string& part, XmlHandler& handler);

}  // namespace qrelief
