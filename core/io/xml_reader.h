// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "io/zip_archive.h"

namespace qrelief {

/// A start tag; valid while the handler looks at it.
class XmlElement {
 public:
  XmlElement(const char* name, const char* const* attributes);

  std::string_view space;  ///< URI of the namespace, empty for none
  std::string_view name;   ///< without prefix

  /// An attribute without prefix.
  std::optional<std::string_view> attribute(std::string_view wanted) const;
  /// An attribute of a namespace.
  std::optional<std::string_view> attribute(std::string_view uri, std::string_view wanted) const;

 private:
  const char* const* attributes_;
};

/// Is told what an XML document holds, in its order; text between the tags is passed over. An error ends the reading.
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  /// The prefix means that namespace from the next element on.
  virtual void declareSpace(std::string_view /*prefix*/, std::string_view /*uri*/) {}
  virtual Status startElement(const XmlElement& element) = 0;
  virtual Status endElement() { return {}; }
};

/// Reads a part of a package by Expat, in bounded memory: never more than one tag at a time, none longer than 1 MB, no
/// more than 100 of them open. A document type definition is refused, as 3MF asks [core specification, 2.3.2].
/// @param part  its name, for messages
/// @returns BadInput naming part and line, also for what the handler refuses
Status readXml(ZipStream& stream, const std::string& part, XmlHandler& handler);

}  // namespace qrelief
