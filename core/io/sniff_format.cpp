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

constexpr int kLinesLookedAt = 100;
constexpr std::size_t kBytesLookedAt = 16384;

constexpr std::array<std::string_view, 14> kObjKeywords = {"v", "vn", "vt", "vp",     "f",      "l",      "p",
                                                           "o", "g",  "s",  "mtllib", "usemtl", "cstype", "deg"};

/// A "v" line with three numbers, and before it only blank lines, comments and keywords of OBJ.
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

}  // namespace

std::string_view nameOf(ModelFormat format) {
  constexpr std::array<std::string_view, 7> kNames = {"unknown", "STL", "OBJ", "PLY", "OFF", "3MF", "glTF"};
  return kNames[static_cast<std::size_t>(format)];
}

ModelFormat formatOfName(std::string_view fileName) {
  const std::size_t dot = fileName.rfind('.');
  if (dot == std::string_view::npos) return ModelFormat::Unknown;
  std::string extension(fileName.substr(dot + 1));
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (extension == "stl") return ModelFormat::Stl;
  if (extension == "obj") return ModelFormat::Obj;
  if (extension == "ply") return ModelFormat::Ply;
  if (extension == "off") return ModelFormat::Off;
  if (extension == "3mf") return ModelFormat::ThreeMf;
  if (extension == "glb" || extension == "gltf") return ModelFormat::Gltf;
  return ModelFormat::Unknown;
}

ModelFormat formatOfContent(std::span<const std::uint8_t> bytes) {
  if (isBinaryStl(bytes)) return ModelFormat::Stl;
  const std::string_view text = textOf(bytes);
  if (text.starts_with("PK\x03\x04")) return ModelFormat::ThreeMf;
  if (text.starts_with("glTF")) return ModelFormat::Gltf;
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return ModelFormat::Ply;
  if (looksLikeAsciiStl(bytes)) return ModelFormat::Stl;
  if (isOffKeyword(TextScanner(text.substr(0, kBytesLookedAt), '#').word())) return ModelFormat::Off;
  if (looksLikeObj(text)) return ModelFormat::Obj;
  return ModelFormat::Unknown;
}

}  // namespace qrelief
