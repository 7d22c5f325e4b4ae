// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply_header.h"

#include <array>
#include <utility>

#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypeNames = {{
    {"char", PlyType::Int8},
    {"int8", PlyType::Int8},
    {"uchar", PlyType::UInt8},
    {"uint8", PlyType::UInt8},
    {"short", PlyType::Int16},
    {"int16", PlyType::Int16},
    {"ushort", PlyType::UInt16},
    {"uint16", PlyType::UInt16},
    {"int", PlyType::Int32},
    {"int32", PlyType::Int32},
    {"uint", PlyType::UInt32},
    {"uint32", PlyType::UInt32},
    {"float", PlyType::Float32},
    {"float32", PlyType::Float32},
    {"double", PlyType::Float64},
    {"float64", PlyType::Float64},
}};

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view text) : text_(text), scanner_(text) {}

  Result<PlyHeader> read() {
    if (word() != "ply") return failHere(message<"ply-keyword">());
    scanner_.restOfLine();
    bool anyFormat = false;
    for (;;) {
      if (scanner_.atEnd()) return failHere(message<"ply-no-end">());
      line_ = scanner_.line();
      const std::string keyword = word();
      if (keyword == "end_header") break;
      Status status;
      if (keyword == "format") {
        status = readFormat();
        anyFormat = true;
      } else if (keyword == "element") {
        status = readElement();
      } else if (keyword == "property") {
        status = readProperty();
      } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
        status = failHere(message<"ply-unknown-keyword">(with::quoted<"word">(excerpt(keyword))));
      }
      QRELIEF_TRY(status);
      scanner_.restOfLine();
    }
    if (!anyFormat) return failHere(message<"ply-no-format">());
    endOfHeader();
    return std::move(header_);
  }

 private:
  tl::unexpected<Error> failHere(Message what) const {
    return badInput(message<"ply-header-line">(with::index<"line">(line_), with::cause<"cause">(std::move(what))));
  }

  /// Returns the next word of the line, without regard to capitals.
  std::string word() { return lowerCase(scanner_.wordOnLine()); }

  Status readFormat() {
    const std::string name = word();
    if (name == "ascii") {
      header_.format = PlyFormat::Ascii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::LittleEndian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::BigEndian;
    } else {
      return failHere(message<"ply-format">(with::quoted<"word">(excerpt(name))));
    }
    return {};
  }

  Status readElement() {
    PlyElement element;
    element.name = word();
    const std::string_view number = scanner_.wordOnLine();
    const std::optional<std::int64_t> count = parseInteger(number);
    if (number.empty())
      return failHere(message<"ply-element-count-missing">(with::quoted<"element">(excerpt(element.name))));
    if (!count || *count < 0)
      return failHere(message<"ply-element-count">(with::quoted<"element">(excerpt(element.name)),
                                                   with::quoted<"word">(excerpt(number))));
    element.count = static_cast<std::uint64_t>(*count);
    header_.elements.push_back(std::move(element));
    return {};
  }

  Result<PlyType> readType() {
    const std::string type = word();
    for (const auto& [name, known] : kTypeNames)
      if (name == type) return known;
    return failHere(message<"ply-type">(with::quoted<"word">(excerpt(type))));
  }

  Status readProperty() {
    if (header_.elements.empty()) return failHere(message<"ply-property-first">());
    PlyProperty property;
    const TextScanner before = scanner_;
    if (word() == "list") {
      const Result<PlyType> countType = readType();
      QRELIEF_TRY(countType);
      if (isFloating(*countType)) return failHere(message<"ply-list-type">());
      property.countType = *countType;
    } else {
      scanner_ = before;
    }
    const Result<PlyType> type = readType();
    QRELIEF_TRY(type);
    property.type = *type;
    property.name = word();
    if (property.name.empty()) return failHere(message<"ply-property-name">());
    header_.elements.back().properties.push_back(std::move(property));
    return {};
  }

  /// Moves to the data. The line end after "end_header" must be of the same kind as the one after "ply", because in a
  /// binary file the data after a CR may begin with a byte 10.
  void endOfHeader() {
    const std::size_t firstEnd = text_.find_first_of("\r\n");
    const bool returnOnly = text_[firstEnd] == '\r' && text_.substr(firstEnd, 2) != "\r\n";
    const std::size_t keyword = scanner_.position();
    scanner_.restOfLine();
    header_.bytes = scanner_.position();
    if (returnOnly && text_.substr(header_.bytes - 2, 2) == "\r\n" && header_.bytes - 2 >= keyword) --header_.bytes;
    header_.lines = line_;
  }

  std::string_view text_;
  TextScanner scanner_;
  PlyHeader header_;
  std::size_t line_ = 1;
};

}  // namespace

std::size_t sizeOf(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
      return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
      return 2;
    case PlyType::Float64:
      return 8;
    default:
      return 4;
  }
}

bool isFloating(PlyType type) { return type == PlyType::Float32 || type == PlyType::Float64; }

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return i;
  return std::nullopt;
}

Result<PlyHeader> parsePlyHeader(std::string_view text) { return HeaderReader(text).read(); }

}  // namespace qrelief
