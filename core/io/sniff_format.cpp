// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sniff_format.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "io/parse_number.h"
#include "io/read_off.h"
#include "io/read_stl.h"
#include "io/text_scanner.h"
#include "message_codes/files.h"

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
    const std::string keyword = lowerCase(scanner.wordOnLine());
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
  const std::string extension = lowerCase(fileName.substr(dot + 1));
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
  if (lowerCase(text.substr(0, 3)) == "ply" && text.substr(3).find_first_of(" \t\r\n") == 0) return ModelFormat::Ply;
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

namespace {

using namespace std::string_view_literals;

constexpr std::size_t kBytesOfText = 4096;  // that tell what a foreign file is
constexpr int kLinesOfText = 50;

enum class Kind { Model, Cad, Picture, Document, Archive };

/// Bytes at a fixed place that only files of one format have.
struct Signature {
  std::string_view bytes;
  std::string_view format;
  Kind kind;
  std::size_t at = 0;
};
constexpr std::array<Signature, 25> kSignatures = {{
    {"%PDF-", "PDF", Kind::Document},
    {"\x89PNG\r\n"sv, "PNG", Kind::Picture},
    {"\xFF\xD8\xFF"sv, "JPEG", Kind::Picture},
    {"GIF8", "GIF", Kind::Picture},
    {"WEBP", "WebP", Kind::Picture, 8},
    {"ISO-10303-21", "STEP", Kind::Cad},
    {"BLENDER", "Blender", Kind::Model},
    {"Kaydara FBX", "FBX", Kind::Model},
    {"#VRML", "VRML", Kind::Model},
    {"#X3D", "X3D", Kind::Model},
    {"AC10", "DWG", Kind::Cad},
    {"3D Geometry File Format", "Rhino", Kind::Cad},
    {"**ABCDEFGHIJKLMNOPQRSTUVWXYZ", "Parasolid", Kind::Cad},
    {"PXR-USDC", "USD", Kind::Model},
    {"#usda", "USD", Kind::Model},
    {"xof 0", "DirectX", Kind::Model},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, "SolidWorks, Inventor or Office", Kind::Document},
    {"\x1F\x8B\x08"sv, "gzip", Kind::Archive},
    {"ustar", "tar", Kind::Archive, 257},
    {"7z\xBC\xAF\x27\x1C"sv, "7z", Kind::Archive},
    {"Rar!\x1A"sv, "RAR", Kind::Archive},
    {"1AY&SY", "bzip2", Kind::Archive, 4},
    {"\xFD\x37zXZ"sv, "xz", Kind::Archive},
    {"\x28\xB5\x2F\xFD"sv, "zstd", Kind::Archive},
    {"PAR1", "Parquet", Kind::Document},
}};

Message messageOf(std::string_view format, Kind kind) {
  switch (kind) {
    case Kind::Model:
      return message<"format-unreadable">(with::term<"format">(format));
    case Kind::Cad:
      return message<"format-of-cad">(with::term<"format">(format));
    case Kind::Picture:
      return message<"file-is-picture">(with::term<"format">(format));
    case Kind::Document:
      return message<"file-is-document">(with::term<"format">(format));
    case Kind::Archive:
      break;
  }
  return message<"file-is-archive">(with::term<"format">(format));
}

/// Identifies HTML and XML by their first element.
/// @param text  in lower case, from the first "<"
Message markup(std::string_view text) {
  const auto has = [text](std::string_view word) { return text.find(word) != std::string_view::npos; };
  if (has("<!doctype html") || has("<html")) return message<"file-is-web-page">();
  if (has("<svg")) return messageOf("SVG", Kind::Picture);
  if (has("<collada")) return messageOf("COLLADA", Kind::Model);
  if (has("<amf")) return messageOf("AMF", Kind::Model);
  if (has("<x3d")) return messageOf("X3D", Kind::Model);
  return messageOf("XML", Kind::Document);
}

/// Returns true for a command such as "G1" or "M104".
bool isCommand(std::string_view word) {
  return word.size() > 1 && (word[0] == 'G' || word[0] == 'M' || word[0] == 'T') && word[1] >= '0' && word[1] <= '9';
}

/// Returns true if there are only G-code's comments and commands, and one command at least, or a slicer's name.
bool looksLikeGcode(std::string_view text) {
  TextScanner scanner(text);
  bool isSure = text.starts_with("; HEADER_BLOCK_START") || text.starts_with("; generated by ");
  for (int i = 0; i < kLinesOfText && !scanner.atEnd(); ++i, scanner.restOfLine()) {
    const std::string_view word = scanner.wordOnLine();
    if (word.empty() || word.starts_with(';')) continue;
    if (!isCommand(word)) return isSure;
    isSure = true;
  }
  return isSure;
}

/// Returns true if the first line is numbered as IGES numbers its lines: "S" in column 73, then a number.
bool looksLikeIges(std::string_view text) {
  return text.size() > 80 && text[72] == 'S' &&
         text.substr(73, 7).find_first_not_of(" 0123456789") == std::string_view::npos;
}

bool looksLikeDxf(std::string_view text) {
  TextScanner scanner(text);
  return scanner.word() == "0" && scanner.word() == "SECTION";
}

}  // namespace

std::optional<Message> identifyFile(std::span<const std::uint8_t> bytes) {
  const std::string_view whole = textOf(bytes.first(std::min(bytes.size(), kBytesOfText)));
  for (const Signature& s : kSignatures)
    if (whole.size() > s.at && whole.substr(s.at).starts_with(s.bytes)) return messageOf(s.format, s.kind);
  if (whole.starts_with("GCDE")) return message<"file-is-gcode">();
  if (whole.find('\0') != std::string_view::npos) return std::nullopt;
  const std::string_view text = whole.substr(std::min(whole.find_first_not_of(" \t\r\n"), whole.size()));
  if (text.starts_with('<')) return markup(lowerCase(text));
  if (text.starts_with('{') || text.starts_with('[')) {
    const bool isGltf = text.find("\"asset\"") != std::string_view::npos;
    return isGltf ? messageOf("glTF", Kind::Model) : message<"file-is-json">();
  }
  if (text.starts_with("version https://git-lfs")) return message<"file-is-lfs-pointer">();
  if (looksLikeIges(whole)) return messageOf("IGES", Kind::Cad);
  if (looksLikeDxf(text)) return messageOf("DXF", Kind::Model);
  if (looksLikeGcode(text)) return message<"file-is-gcode">();
  return std::nullopt;
}

}  // namespace qrelief
