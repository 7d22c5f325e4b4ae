// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_ply.h"

#include <cmath>
#include <fmt/format.h>

#include "io/load_bytes.h"
#include "io/parse_number.h"
#include "io/ply_header.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"

namespace qrelief {
namespace {

/// The file's values one after the other, as text. Doubles hold every integer type of PLY exactly.
class TextValues {
 public:
  TextValues(std::string_view text, const PlyHeader& header)
      : scanner_(text.substr(header.bytes)), headerLines_(header.lines), size_(text.size() - header.bytes) {}

  static std::size_t shortest(PlyType) { return 2; }  // one digit and a blank
  std::size_t room() const { return size_ + 1 - scanner_.position(); }

  Result<double> next(PlyType) {
    const std::string_view word = scanner_.word();
    if (const std::optional<double> value = parseNumber(word)) return *value;
    return fail(ErrorKind::BadInput, fmt::format("line {}: {}", headerLines_ + scanner_.line(), notANumber(word)));
  }

  Status skip(PlyType type, std::uint64_t count) {
    for (; count > 0; --count)
      if (const Result<double> value = next(type); !value) return tl::unexpected(value.error());
    return {};
  }

 private:
  TextScanner scanner_;
  std::size_t headerLines_;
  std::size_t size_;
};

/// The same from binary data.
class BinaryValues {
 public:
  BinaryValues(std::string_view text, const PlyHeader& header)
      : bytes_(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()),
        position_(header.bytes),
        bigEndian_(header.format == PlyFormat::BigEndian) {}

  static std::size_t shortest(PlyType type) { return sizeOf(type); }
  std::size_t room() const { return bytes_.size() - position_; }

  Result<double> next(PlyType type) {
    const std::size_t size = sizeOf(type);
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
    if (room() / sizeOf(type) < count) return cutOff();
    position_ += static_cast<std::size_t>(count) * sizeOf(type);
    return {};
  }

 private:
  tl::unexpected<Error> cutOff() const {
    return fail(ErrorKind::BadInput, fmt::format("byte {}: the file is cut off", bytes_.size()));
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t position_;
  bool bigEndian_;
};

template <class Values>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Values values, const ReadLimits& limits) : header_(header), values_(values) {
    list_.maxTriangles = limits.maxTriangles;
  }

  Result<PolygonSoup> read() {
    if (Status s = checkElements(); !s) return tl::unexpected(s.error());
    for (const PlyElement& element : header_.elements) {
      if (Status s = checkRoom(element); !s) return tl::unexpected(s.error());
      const Status s = element.name == "vertex" ? readVertices(element)
                       : element.name == "face" ? readFaces(element)
                                                : skipElement(element);
      if (!s) return tl::unexpected(s.error());
    }
    return triangulated(std::move(list_), "PLY");
  }

 private:
  Status checkElements() const {
    int vertexElements = 0;
    int faceElements = 0;
    bool strips = false;
    for (const PlyElement& element : header_.elements) {
      vertexElements += element.name == "vertex";
      faceElements += element.name == "face";
      strips |= element.name == "tristrips";
    }
    if (vertexElements == 1 && faceElements == 1) return {};
    if (faceElements == 0 && strips)
      return fail(ErrorKind::BadInput, "The PLY file has no element \"face\": its surface is stored as \"tristrips\"",
                  "Open it in a mesh program and export it with faces, or as STL or OBJ");
    return fail(
        ErrorKind::BadInput,
        fmt::format("The PLY header names {} elements \"vertex\" and {} elements \"face\"; one of each is needed",
                    vertexElements, faceElements),
        "Export the model as a surface mesh, with faces; a point cloud has no surface to engrave");
  }

  /// Nothing is reserved for a count that the file's size does not bear out.
  Status checkRoom(const PlyElement& element) const {
    std::size_t smallest = 0;
    for (const PlyProperty& property : element.properties)
      smallest += Values::shortest(property.countType ? *property.countType : property.type);
    if (smallest == 0 || element.count <= values_.room() / smallest) return {};
    return fail(
        ErrorKind::BadInput,
        fmt::format("The PLY file announces {} elements {}, each of at least {} bytes, but only {} bytes are left",
                    element.count, quoted(element.name), smallest, values_.room()),
        "The file is cut off or damaged; copy or export it again");
  }

  static tl::unexpected<Error> failAt(const PlyElement& element, std::uint64_t number, const std::string& what) {
    return fail(
        ErrorKind::BadInput,
        fmt::format("Element {} {} of {} of the PLY file, {}", quoted(element.name), number + 1, element.count, what),
        "The file is cut off or damaged; copy or export it again");
  }

  Result<std::uint64_t> readListLength(PlyType type) {
    const Result<double> length = values_.next(type);
    if (!length) return tl::unexpected(length.error());
    if (!(*length >= 0) || *length != std::floor(*length) || *length > 4294967295.0)
      return fail(ErrorKind::BadInput, fmt::format("a list's length is {}", *length));
    return static_cast<std::uint64_t>(*length);
  }

  Status skipProperty(const PlyProperty& property) {
    if (!property.countType) return values_.skip(property.type, 1);
    const Result<std::uint64_t> length = readListLength(*property.countType);
    if (!length) return tl::unexpected(length.error());
    return values_.skip(property.type, *length);
  }

  Status skipElement(const PlyElement& element) {
    if (element.properties.empty()) return {};
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const PlyProperty& property : element.properties)
        if (const Status s = skipProperty(property); !s) return failAt(element, i, toldText(s.error().message));
    return {};
  }

  Status readVertices(const PlyElement& element) {
    std::vector<int> axisOf(element.properties.size(), -1);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name(1, static_cast<char>('x' + axis));
      const std::optional<std::size_t> at = element.find(name);
      if (!at || element.properties[*at].countType)
        return fail(ErrorKind::BadInput, fmt::format("The PLY file's vertices have no coordinate \"{}\"", name),
                    "Export the model again");
      axisOf[*at] = axis;
    }
    if (Status s = list_.reserve(element.count, 0); !s) return s;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Vec3 p(0);
      for (std::size_t k = 0; k < axisOf.size(); ++k) {
        if (axisOf[k] < 0) {
          if (const Status s = skipProperty(element.properties[k]); !s)
            return failAt(element, i, toldText(s.error().message));
          continue;
        }
        const Result<double> value = values_.next(element.properties[k].type);
        if (!value) return failAt(element, i, toldText(value.error().message));
        p[axisOf[k]] = *value;
      }
      list_.positions.push_back(p);
    }
    return {};
  }

  Status readFaces(const PlyElement& element) {
    const std::optional<std::size_t> plural = element.find("vertex_indices");
    const std::optional<std::size_t> at = plural ? plural : element.find("vertex_index");
    if (!at || !element.properties[*at].countType || isFloating(element.properties[*at].type))
      return fail(ErrorKind::BadInput,
                  "The PLY file's faces have no integer list \"vertex_indices\" or \"vertex_index\"",
                  "Export the model again");
    if (Status s = list_.reserve(0, element.count); !s) return s;
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        const Status s = k == *at ? readPolygon(property) : skipProperty(property);
        if (!s) return failAt(element, i, toldText(s.error().message));
      }
    return {};
  }

  Status readPolygon(const PlyProperty& property) {
    const Result<std::uint64_t> length = readListLength(*property.countType);
    if (!length) return tl::unexpected(length.error());
    polygon_.clear();
    for (std::uint64_t k = 0; k < *length; ++k) {
      const Result<double> index = values_.next(property.type);
      if (!index) return tl::unexpected(index.error());
      if (!(*index >= 0) || *index != std::floor(*index) || *index > 4294967295.0)
        return fail(ErrorKind::BadInput, fmt::format("the index of corner {} is {}", k + 1, *index));
      polygon_.push_back(static_cast<std::uint32_t>(*index));
    }
    return list_.add(polygon_);
  }

  const PlyHeader& header_;
  Values values_;
  PolygonList list_;
  std::vector<std::uint32_t> polygon_;
};

}  // namespace

Result<PolygonSoup> readPly(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  const std::string_view text = textOf(bytes);
  const Result<PlyHeader> header = parsePlyHeader(text);
  if (!header) return tl::unexpected(header.error());
  if (header->format == PlyFormat::Ascii) return PlyReader(*header, TextValues(text, *header), limits).read();
  return PlyReader(*header, BinaryValues(text, *header), limits).read();
}

}  // namespace qrelief
