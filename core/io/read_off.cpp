// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_off.h"

#include <fmt/format.h>

#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"

namespace qrelief {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const ReadLimits& limits) : text_(text), scanner_(text, '#') {
    list_.maxTriangles = limits.maxTriangles;
  }

  Result<PolygonSoup> read() {
    if (Status s = readKeyword(); !s) return tl::unexpected(s.error());
    const Result<std::uint64_t> vertices = readCount("vertices");
    if (!vertices) return tl::unexpected(vertices.error());
    const Result<std::uint64_t> faces = readCount("faces");
    if (!faces) return tl::unexpected(faces.error());
    scanner_.restOfLine();  // the number of edges; often wrong, never needed
    if (Status s = checkRoom(*vertices, *faces); !s) return tl::unexpected(s.error());
    if (Status s = list_.reserve(*vertices, *faces); !s) return tl::unexpected(s.error());

    const auto vertexCount = static_cast<std::size_t>(*vertices);
    const auto faceCount = static_cast<std::size_t>(*faces);
    for (std::size_t v = 0; v < vertexCount; ++v)
      if (Status s = readVertex(v + 1, vertexCount); !s) return tl::unexpected(s.error());
    for (std::size_t f = 0; f < faceCount; ++f)
      if (Status s = readFace(f + 1, faceCount); !s) return tl::unexpected(s.error());
    return triangulated(std::move(list_), "OFF");
  }

 private:
  tl::unexpected<Error> failHere(const std::string& what) const {
    return fail(ErrorKind::BadInput, fmt::format("Line {} of the OFF file: {}", scanner_.line(), what),
                "The file is cut off or damaged; export it again");
  }

  Status readKeyword() {
    const std::string_view keyword = scanner_.word();
    if (!isOffKeyword(keyword)) return failHere(fmt::format("{} where \"OFF\" should stand", quoted(keyword)));
    if (keyword.find('4') != std::string_view::npos || keyword.find('n') != std::string_view::npos)
      return fail(ErrorKind::BadInput,
                  fmt::format("The OFF file is of kind {}, which has no three-dimensional points", keyword),
                  "Export the model as plain OFF, STL, OBJ or PLY");
    const TextScanner before = scanner_;
    if (scanner_.wordOnLine() == "BINARY")
      return fail(ErrorKind::BadInput, "The OFF file is binary; only OFF as text is read",
                  "Export the model as OFF text, or as STL, OBJ or PLY");
    scanner_ = before;
    return {};
  }

  Result<std::uint64_t> readCount(std::string_view of) {
    const std::string_view word = scanner_.word();
    const std::optional<std::int64_t> count = parseInteger(word);
    if (!count || *count < 0)
      return failHere(fmt::format("the number of {} is {}", of, word.empty() ? "missing" : quoted(word)));
    return static_cast<std::uint64_t>(*count);
  }

  /// The shortest vertex takes six bytes ("0 0 0" and a line end), the shortest face two ("0").
  Status checkRoom(std::uint64_t vertices, std::uint64_t faces) const {
    const std::size_t room = text_.size() + 1 - scanner_.position();
    if (vertices <= room / 6 && faces <= room / 2) return {};
    return fail(ErrorKind::BadInput,
                fmt::format("The OFF file announces {} vertices and {} faces, but only {} bytes follow", vertices,
                            faces, text_.size() - scanner_.position()),
                "The file is cut off or damaged; export it again");
  }

  Status readVertex(std::size_t number, std::size_t count) {
    Vec3 p(0);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = scanner_.word();
      const std::optional<double> value = parseNumber(word);
      if (!value) return failHere(fmt::format("vertex {} of {}: {}", number, count, notANumber(word)));
      p[axis] = *value;
    }
    scanner_.restOfLine();
    list_.positions.push_back(p);
    return {};
  }

  Status readFace(std::size_t number, std::size_t count) {
    const std::string_view sizeWord = scanner_.word();
    const std::optional<std::int64_t> size = parseInteger(sizeWord);
    if (!size || *size < 0)
      return failHere(fmt::format("face {} of {}: the number of its corners is {}", number, count,
                                  sizeWord.empty() ? "missing" : quoted(sizeWord)));
    polygon_.clear();
    for (std::int64_t k = 0; k < *size; ++k) {
      const std::string_view word = scanner_.word();
      const std::optional<std::int64_t> index = parseInteger(word);
      if (!index) return failHere(fmt::format("face {} of {}: {}", number, count, notANumber(word)));
      if (*index < 0 || static_cast<std::uint64_t>(*index) >= list_.positions.size())
        return failHere(fmt::format("face {} of {} asks for vertex {} (counted from 0), but there are {}", number,
                                    count, *index, list_.positions.size()));
      polygon_.push_back(static_cast<std::uint32_t>(*index));
    }
    scanner_.restOfLine();  // colour
    return list_.add(polygon_);
  }

  std::string_view text_;
  TextScanner scanner_;
  PolygonList list_;
  std::vector<std::uint32_t> polygon_;
};

}  // namespace

bool isOffKeyword(std::string_view word) {
  if (!word.ends_with("OFF")) return false;
  word.remove_suffix(3);
  for (const std::string_view prefix : {"ST", "C", "N", "4", "n"})
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  return word.empty();
}

Result<PolygonSoup> readOff(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  return OffReader(textOf(bytes), limits).read();
}

}  // namespace qrelief
