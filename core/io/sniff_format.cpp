// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sniff_format.h"

#include <algorithm>
#include <array>
#include <string>

#include "io/parse_number.h"
#include "io/read_off.h"
#include "io/read_stl.h"
#include "io/text_scanner.h"

namespace qrelief {
namespace {

struct FormatRow {
  std::string_view name;
  std::array<std::string_view, 2> extensions;  // in lower case
  bool isWritable;
};
constexpr std::array<FormatRow, 7> kFormats = {{
    // in the order of ModelFormat
    {"unknown", {}, false},
    {"STL", {"stl"}, true},
    {"OBJ", {"obj"}, true},
    {"PLY", {"ply"}, true},
    {"OFF", {"off"}, false},
    {"3MF", {"3mf"}, true},
    {"glTF", {"glb", "gltf"}, false},
}};

constexpr int kLinesLookedAt = 100;
constexpr std::size_t kBytesLookedAt = 16384;

constexpr std::size_t kUnitsLookedAt = 64;  // 16-bit units of text
constexpr std::size_t kFewestUnits = 8;

constexpr std::array<std::string_view, 14> kObjKeywords = {"v", "vn", "vt", "vp",     "f",      "l",      "p",
                                                           "o", "g",  "s",  "mtllib", "usemtl", "cstype", "deg"};

/// Returns true if there is a "v" line with three numbers, and before it only blank lines, comments and keywords of
/// OBJ.
bool looksLikeObj(std::string_view text) {
  TextScanner scanner(text.substr(0, kBytesLookedAt), '#');
  for (int i = 0; i < kLinesLookedAt && !scanner.atEnd(); ++i, scanner.restOfLine()) {
    const std::string_view keyword = scanner.wordOnLine();
    if (keyword.empty()) continue;
    if (std::find(kObjKeywords.begin(), kObjKeywords.end(), keyword) == kObjKeywords.end()) return false;
    if (keyword != "v") continue;
    for (int axis = 0; axis < 3; ++axis)
      if (!parseNumber(scanner.wordOnLine())) return false;
    return true;
  }
  return false;
}

/// Returns true if the first 16-bit units are characters of ASCII text. After a byte order mark three in four are
/// enough, to allow comments in other scripts.
bool looksLikeWideText(std::span<const std::uint8_t> bytes, bool bigEndian) {
  const std::uint8_t first = bytes[bigEndian ? 0 : 1], second = bytes[bigEndian ? 1 : 0];
  const bool marked = first == 0xfe && second == 0xff;
  std::size_t units = 0, ascii = 0;
  for (std::size_t at = marked ? 2 : 0; at + 1 < bytes.size() && units < kUnitsLookedAt; at += 2, ++units) {
    const std::uint8_t high = bytes[at + (bigEndian ? 0 : 1)], low = bytes[at + (bigEndian ? 1 : 0)];
    ascii += high == 0 && ((low >= ' ' && low < 127) || (low >= '\t' && low <= '\r'));
  }
  return marked ? 4 * ascii >= 3 * units : units >= kFewestUnits && ascii == units;
}

}  // namespace

std::string_view nameOf(ModelFormat format) { return kFormats[static_cast<std::size_t>(format)].name; }

bool isWritable(ModelFormat format) { return kFormats[static_cast<std::size_t>(format)].isWritable; }

ModelFormat formatOfName(std::string_view fileName) {
  const std::size_t dot = fileName.rfind('.');
  if (dot == std::string_view::npos) return ModelFormat::Unknown;
  std::string extension(fileName.substr(dot + 1));
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (std::size_t i = 0; i < kFormats.size(); ++i)
    for (const std::string_view known : kFormats[i].extensions)
      if (!known.empty() && extension == known) return static_cast<ModelFormat>(i);
  return ModelFormat::Unknown;
}

ModelFormat formatOfContent(std::span<const std::uint8_t> bytes) {
  if (isBinaryStl(bytes)) return ModelFormat::Stl;
  const std::string_view text = textOf(bytes);
  if (text.starts_with("PK\x03\x04") || text.starts_with("PK\x05\x06")) return ModelFormat::ThreeMf;
  if (text.starts_with("glTF")) return ModelFormat::Gltf;
  if (text.starts_with("ply") && text.substr(3).find_first_of(" \t\r\n") == 0) return ModelFormat::Ply;
  if (looksLikeAsciiStl(bytes)) return ModelFormat::Stl;
  if (isOffKeyword(TextScanner(text.substr(0, kBytesLookedAt), '#').word())) return ModelFormat::Off;
  if (looksLikeObj(text)) return ModelFormat::Obj;
  return ModelFormat::Unknown;
}

std::string_view wideEncodingOf(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 2) return {};
  if (looksLikeWideText(bytes, false)) return "UTF-16 LE";
  if (looksLikeWideText(bytes, true)) return "UTF-16 BE";
  return {};
}

}  // namespace qrelief
