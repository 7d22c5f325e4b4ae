// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace qrelief {

/// A tag of an XML text, and its place.
struct XmlTag {
  std::size_t begin = 0, end = 0;  ///< bytes of the text, from "<" to after ">"
  std::string_view raw;            ///< the tag itself
  std::string_view name;           ///< without prefix
  bool isEnd = false;              ///< "</name>"
  bool isEmpty = false;            ///< "<name/>"

  bool starts(std::string_view wanted) const { return !isEnd && name == wanted; }
  bool ends(std::string_view wanted) const { return isEnd && name == wanted; }

  /// An attribute's place.
  struct Attribute {
    std::string_view name, value;  ///< with prefix; as in the text, escapes not resolved
    std::size_t begin, end;        ///< bytes of the text, from the name to after the closing quote
    std::size_t valueBegin;        ///< byte of the text where the value begins
  };
  std::vector<Attribute> attributes() const;
  /// Returns an attribute's value; the name includes its prefix.
  std::optional<std::string_view> attribute(std::string_view wanted) const;
};

/// The tags of a text that a parser has found to be well-formed XML in UTF-8, one after the other. Comments, CDATA
/// sections and processing instructions are skipped. Unlike a parser, it gives the position of everything, so that a
/// text can be edited without changes elsewhere.
class XmlTags {
 public:
  /// @param text  must outlive the object and the tags
  explicit XmlTags(std::string_view text) : text_(text) {}
  /// Returns the next tag; none at the end.
  std::optional<XmlTag> next();

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// A piece of a text and its replacement.
struct TextEdit {
  std::size_t begin = 0, end = 0;
  std::string text;
};

/// Returns the text with all edits made; they must not overlap. Edits at the same place are made in their order.
std::string edited(std::string_view text, std::vector<TextEdit> edits);

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
