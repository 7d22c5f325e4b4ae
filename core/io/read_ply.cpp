// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "io/parse_number.h"
#include "io/ply_header.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

/// The values of a text file, one after the other. Doubles hold every integer type of PLY exactly.
///
/// Errors are messages that begin with their place; the caller adds the element.
class TextValues {
 public:
  TextValues(std::string_view text, const PlyHeader& header)
      : scanner_(text.substr(header.bytes)), headerLines_(header.lines), size_(text.size() - header.bytes) {}

  static std::size_t shortest(PlyType) { return 2; }                // one digit and a blank
  std::size_t left() const { return size_ - scanner_.position(); }  ///< bytes not yet read
  std::size_t room() const { return left() + 1; }                   ///< the last value needs no blank

  Result<double> next(PlyType) {
    std::string_view word = scanner_.word();
    for (; word == "comment" || word == "obj_info"; word = scanner_.word()) scanner_.restOfLine();
    if (const std::optional<double> value = parseNumber(word)) return *value;
    return failHere(notANumber(word));
  }

  /// @param what  describes the value read last
  tl::unexpected<Error> failHere(Message what) const {
    return badInput(
        message<"at-line">(with::index<"line">(headerLines_ + scanner_.line()), with::cause<"cause">(std::move(what))));
  }

  Status skip(PlyType type, std::uint64_t count) {
    for (; count > 0; --count) QRELIEF_TRY(next(type));
    return {};
  }

 private:
  TextScanner scanner_;
  std::size_t headerLines_;
  std::size_t size_;
};

/// The values of a binary file, with the same interface.
class BinaryValues {
 public:
  BinaryValues(std::string_view text, const PlyHeader& header)
      : bytes_(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()),
        position_(header.bytes),
        bigEndian_(header.format == PlyFormat::BigEndian) {}

  static std::size_t shortest(PlyType type) { return sizeOf(type); }
  std::size_t left() const { return bytes_.size() - position_; }
  std::size_t room() const { return left(); }

  Result<double> next(PlyType type) {
    const std::size_t size = sizeOf(type);
    valueBegin_ = position_;
    if (room() < size) return cutOff();
    const std::uint8_t* raw = bytes_.data() + position_;
    position_ += size;
    switch (type) {
      case PlyType::Int8:
        return loadBytes<std::int8_t>(raw);
      case PlyType::UInt8:
        return *raw;
      case PlyType::Int16:
        return loadBytes<std::int16_t>(raw, bigEndian_);
      case PlyType::UInt16:
        return loadBytes<std::uint16_t>(raw, bigEndian_);
      case PlyType::Int32:
        return loadBytes<std::int32_t>(raw, bigEndian_);
      case PlyType::UInt32:
        return loadBytes<std::uint32_t>(raw, bigEndian_);
      case PlyType::Float32:
        return loadBytes<float>(raw, bigEndian_);
      case PlyType::Float64:
        return loadBytes<double>(raw, bigEndian_);
    }
    return cutOff();
  }

  Status skip(PlyType type, std::uint64_t count) {
    valueBegin_ = position_;
    if (room() / sizeOf(type) < count) return cutOff();
    position_ += static_cast<std::size_t>(count) * sizeOf(type);
    return {};
  }

  tl::unexpected<Error> failHere(Message what) const {
    return badInput(message<"at-byte">(with::index<"byte">(valueBegin_), with::cause<"cause">(std::move(what))));
  }

 private:
  tl::unexpected<Error> cutOff() const { return failHere(message<"file-cut-off">()); }

  std::span<const std::uint8_t> bytes_;
  std::size_t position_;
  std::size_t valueBegin_ = 0;  // start of the value read last, for messages
  bool bigEndian_;
};

template <class Values>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Values values, const ReadLimits& limits) : header_(header), values_(values) {
    list_.maxTriangles = limits.maxTriangles;
  }

  Result<PolygonSoup> read() {
    QRELIEF_TRY(checkElements());
    for (const PlyElement& element : header_.elements) {
      QRELIEF_TRY(checkSizeBound(element));
      const Status s = element.name == "vertex" ? readVertices(element)
                       : element.name == "face" ? readFaces(element)
                                                : skipElement(element);
      QRELIEF_TRY(s);
    }
    return triangulated(std::move(list_), "PLY");
  }

 private:
  Status checkElements() {
    int vertexElements = 0;
    int faceElements = 0;
    bool strips = false;
    for (const PlyElement& element : header_.elements) {
      vertexElements += element.name == "vertex";
      if (element.name == "vertex") vertices_ = static_cast<std::size_t>(element.count);
      faceElements += element.name == "face";
      strips |= element.name == "tristrips";
    }
    if (vertexElements == 1 && faceElements == 1) return {};
    if (faceElements == 0 && strips) return badInput(message<"ply-strips">());
    return badInput(message<"ply-elements">(with::count<"vertexElements">(vertexElements),
                                            with::count<"faceElements">(faceElements)));
  }

  /// Refuses a count that exceeds what the file's size allows, before anything is reserved for it.
  Status checkSizeBound(const PlyElement& element) const {
    std::size_t smallest = 0;
    for (const PlyProperty& property : element.properties)
      smallest += Values::shortest(property.countType ? *property.countType : property.type);
    if (smallest == 0 || element.count <= values_.room() / smallest) return {};
    return badInput(message<"ply-announces">(with::count<"elements">(element.count),
                                             with::quoted<"element">(excerpt(element.name)),
                                             with::count<"size">(smallest), with::count<"bytes">(values_.left())));
  }

  static tl::unexpected<Error> failAt(const PlyElement& element, std::uint64_t number, const Error& error) {
    return fail(error.kind, message<"ply-element">(
                                with::quoted<"element">(excerpt(element.name)), with::index<"number">(number + 1),
                                with::count<"elements">(element.count), with::cause<"cause">(error.message)));
  }

  /// Reads the length of a list and checks that the rest of the file is long enough for it, so that no length alone
  /// makes the parser skip or store anything.
  Result<std::uint64_t> readListLength(const PlyProperty& list) {
    const Result<double> length = values_.next(*list.countType);
    QRELIEF_TRY(length);
    if (!(*length >= 0) || *length != std::floor(*length) || *length > 4294967295.0)
      return values_.failHere(message<"ply-list-length">(with::term<"length">(fmt::format("{}", *length))));
    const auto items = static_cast<std::uint64_t>(*length);
    const std::uint64_t needed = items * Values::shortest(list.type);
    if (needed > values_.left())
      return values_.failHere(message<"ply-list-too-long">(with::count<"length">(items), with::count<"needed">(needed),
                                                           with::count<"bytes">(values_.left())));
    return items;
  }

  Status skipProperty(const PlyProperty& property) {
    if (!property.countType) return values_.skip(property.type, 1);
    const Result<std::uint64_t> length = readListLength(property);
    QRELIEF_TRY(length);
    return values_.skip(property.type, *length);
  }

  Status skipElement(const PlyElement& element) {
    if (element.properties.empty()) return {};
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const PlyProperty& property : element.properties)
        if (const Status s = skipProperty(property); !s) return failAt(element, i, s.error());
    return {};
  }

  /// Returns the channel of a colour that each property is; -1 for any other property.
  static std::vector<int> channelsOf(const PlyElement& element) {
    constexpr std::array<const char*, 3> kNames = {"red", "green", "blue"};
    std::vector<int> channelOf(element.properties.size(), -1);
    for (std::size_t channel = 0; channel < kNames.size(); ++channel)
      if (const auto at = element.find(kNames[channel]); at && !element.properties[*at].countType)
        channelOf[*at] = static_cast<int>(channel);
    return channelOf;
  }

  /// Converts a channel: floating-point numbers are 0 … 1, integers 0 … 255.
  static std::uint8_t channelFrom(double value, PlyType type) {
    const double scaled = isFloating(type) ? 255 * value : value;
    return scaled > 0 ? static_cast<std::uint8_t>(std::lround(std::min(scaled, 255.0))) : std::uint8_t{0};
  }

  Status readVertices(const PlyElement& element) {
    std::vector<int> axisOf(element.properties.size(), -1);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name(1, static_cast<char>('x' + axis));
      const std::optional<std::size_t> at = element.find(name);
      if (!at || element.properties[*at].countType)
        return badInput(message<"ply-no-coordinate">(with::term<"axis">(name)));
      axisOf[*at] = axis;
    }
    const std::vector<int> channelOf = channelsOf(element);
    const bool isColoured = std::count(channelOf.begin(), channelOf.end(), -1) + 3 == std::ssize(channelOf);
    QRELIEF_TRY(list_.reserve(element.count, 0));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Vec3 p(0);
      Colour colour{};
      for (std::size_t k = 0; k < axisOf.size(); ++k) {
        if (axisOf[k] < 0 && (!isColoured || channelOf[k] < 0)) {
          if (const Status s = skipProperty(element.properties[k]); !s) return failAt(element, i, s.error());
          continue;
        }
        const Result<double> value = values_.next(element.properties[k].type);
        if (!value) return failAt(element, i, value.error());
        if (axisOf[k] >= 0)
          p[axisOf[k]] = *value;
        else
          colour[channelOf[k]] = channelFrom(*value, element.properties[k].type);
      }
      list_.positions.push_back(p);
      if (isColoured) list_.colours.push_back(colour);
    }
    return {};
  }

  Status readFaces(const PlyElement& element) {
    const std::optional<std::size_t> plural = element.find("vertex_indices");
    const std::optional<std::size_t> at = plural ? plural : element.find("vertex_index");
    if (!at || !element.properties[*at].countType || isFloating(element.properties[*at].type))
      return badInput(message<"ply-no-index-list">());
    QRELIEF_TRY(list_.reserve(0, element.count));
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        const Status s = k == *at ? readPolygon(property) : skipProperty(property);
        if (!s) return failAt(element, i, s.error());
        if (k == *at) QRELIEF_TRY(list_.add(polygon_));
      }
    return {};
  }

  Status readPolygon(const PlyProperty& property) {
    const Result<std::uint64_t> length = readListLength(property);
    QRELIEF_TRY(length);
    polygon_.clear();
    for (std::uint64_t k = 0; k < *length; ++k) {
      const Result<double> index = values_.next(property.type);
      QRELIEF_TRY(index);
      if (*index != std::floor(*index) || !(std::abs(*index) <= 4294967295.0))
        return values_.failHere(
            message<"ply-index">(with::index<"corner">(k + 1), with::term<"index">(fmt::format("{}", *index))));
      if (!(*index >= 0 && *index < static_cast<double>(vertices_)))
        return values_.failHere(noSuchVertex(static_cast<std::int64_t>(*index), vertices_));
      polygon_.push_back(static_cast<std::uint32_t>(*index));
    }
    return {};
  }

  const PlyHeader& header_;
  Values values_;
  PolygonList list_;
  std::vector<std::uint32_t> polygon_;
  std::size_t vertices_ = 0;  // number declared in the header; vertices may follow the faces
};

}  // namespace

Result<PolygonSoup> readPly(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  const std::string_view text = textOf(bytes);
  const Result<PlyHeader> header = parsePlyHeader(text);
  QRELIEF_TRY(header);
  if (header->format == PlyFormat::Ascii) return PlyReader(*header, TextValues(text, *header), limits).read();
  return PlyReader(*header, BinaryValues(text, *header), limits).read();
}

}  // namespace qrelief
