// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>
#include <string>
#include <string_view>

#include "io/zip_writer.h"
#include "math/affine.h"

namespace qrelief {

inline constexpr std::string_view kXmlDeclaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

inline constexpr std::string_view kMaterialSpace = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
                                  kCuraSpace = "http://software.ultimaker.com/xml/cura/3mf/2015/10";

/// Returns the element of an object that tells Cura its extruder.
/// @param filament  from 1
/// @param prefix    of the elements' names, with a colon
std::string curaExtruder(std::size_t filament, std::string_view prefix);

/// Returns the filament, from 1, that Cura's metadata gives an object of a model part. 1: it gives none.
std::size_t curaFilament(std::string_view model, std::size_t object);

/// Escapes a text for the value of an XML attribute. Characters that XML cannot hold become question marks.
std::string escapedXml(std::string_view text);

/// Returns the value of a transform attribute.
std::string transformText(const Affine& transform);

/// Text that goes into the archive piece by piece; finish() writes the last piece.
class PartText {
 public:
  /// Begins a file of the archive.
  PartText(ZipWriter& zip, std::string_view name) : zip_(zip) { zip_.begin(name); }
  void finish() { zip_.append(text_); }
  void addText(std::string_view text) { text_ += text; }
  template <class Format, class... Values>
  void add(const Format& format, const Values&... values) {
    fmt::format_to(std::back_inserter(text_), format, values...);
    if (text_.size() < kPieceBytes) return;
    zip_.append(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t kPieceBytes = 256 * 1024;

  ZipWriter& zip_;
  std::string text_;
};

}  // namespace qrelief
