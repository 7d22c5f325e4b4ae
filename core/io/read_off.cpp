// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_off.h"

#include <string>

#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::string_view kDigits = "0123456789";

/// What ends a vertex or a face: its line, or its last number.
struct OffLayout {
  bool vertexOnLine = true, faceOnLine = true;
};

/// Returns the keyword of a header in capitals. "nOFF", of n dimensions, keeps its small letter; in a keyword of small
/// letters only, "n" announces normals.
std::string keywordFrom(std::string_view word) {
  std::string keyword(word.substr(0, word.find_last_not_of(kDigits) + 1));
  if (keyword.ends_with("OFF")) return keyword;
  for (char& c : keyword) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return keyword;
}

class OffReader {
 public:
  OffReader(std::string_view text, const ReadLimits& limits)
      : text_(text), scanner_(text, '#'), maxTriangles_(limits.maxTriangles) {}

  Result<PolygonSoup> read() {
    QRELIEF_TRY(readKeyword());
    QRELIEF_TRY(readCounts());
    const TextScanner data = scanner_;
    const Status byLines = readData({});
    if (!isPlain_ || (byLines && isAtEnd())) return finished(byLines);
    // Without colours and normals, a line may hold several vertices or a part of one.
    for (const OffLayout layout : {OffLayout{false, true}, OffLayout{false, false}, OffLayout{true, false}}) {
      scanner_ = data;
      if (const Status s = readData(layout); s && isAtEnd()) return finished(s);
    }
    // The data may also begin on the line of the counts.
    scanner_ = behindCounts_;
    if (const Status s = readData({false, false}); s && isAtEnd()) return finished(s);
    scanner_ = data;
    return finished(readData({}));
  }

 private:
  tl::unexpected<Error> failHere(Message what) const {
    return badInput(message<"off-line">(with::index<"line">(scanner_.line()), with::cause<"cause">(std::move(what))));
  }

  Result<PolygonSoup> finished(const Status& read) {
    QRELIEF_TRY(read);
    return triangulated(std::move(list_), "OFF");
  }

  bool isAtEnd() {
    const TextScanner before = scanner_;
    const bool isEnd = scanner_.word().empty();
    scanner_ = before;
    return isEnd;
  }

  /// Reads the keyword. It may be missing [Geomview, OFF], or the number of vertices follows it without a blank, as in
  /// ModelNet.
  Status readKeyword() {
    const std::string_view word = scanner_.word();
    if (word.empty()) return failHere(message<"off-keyword-missing">());
    verticesWord_ = word.substr(word.find_last_not_of(kDigits) + 1);
    const std::string keyword = keywordFrom(word);
    if (keyword.empty()) return {};
    if (!isOffKeyword(keyword)) return failHere(message<"off-keyword">(with::quoted<"word">(excerpt(word))));
    if (keyword.find('4') != std::string_view::npos || keyword.find('n') != std::string_view::npos)
      return badInput(message<"off-dimension">(with::term<"keyword">(keyword)));
    const TextScanner before = scanner_;
    if (lowerCase(scanner_.wordOnLine()) == "binary") return badInput(message<"off-binary">());
    scanner_ = before;
    isPlain_ = keyword == "OFF";
    return {};
  }

  Status readCounts() {
    if (verticesWord_.empty()) verticesWord_ = scanner_.word();
    const std::optional<std::uint64_t> vertices = countFrom(verticesWord_);
    if (!vertices)
      return verticesWord_.empty()
                 ? failHere(message<"off-vertex-count-missing">())
                 : failHere(message<"off-vertex-count">(with::quoted<"word">(excerpt(verticesWord_))));
    const std::string_view facesWord = scanner_.word();
    const std::optional<std::uint64_t> faces = countFrom(facesWord);
    if (!faces)
      return facesWord.empty() ? failHere(message<"off-face-count-missing">())
                               : failHere(message<"off-face-count">(with::quoted<"word">(excerpt(facesWord))));
    QRELIEF_TRY(checkSizeBound(*vertices, *faces));
    skipEdgeCount();
    vertexCount_ = static_cast<std::size_t>(*vertices);
    faceCount_ = static_cast<std::size_t>(*faces);
    return {};
  }

  /// Skips the number of edges, which is often wrong and never needed. It may be missing, or alone on the next line.
  void skipEdgeCount() {
    const bool isOnLine = !scanner_.wordOnLine().empty();
    behindCounts_ = scanner_;
    scanner_.restOfLine();
    if (isOnLine) return;
    const TextScanner before = scanner_;
    const bool isAlone = !scanner_.word().empty() && scanner_.wordOnLine().empty();
    if (!isAlone) scanner_ = before;
  }

  Status readData(OffLayout layout) {
    list_ = {};
    list_.maxTriangles = maxTriangles_;
    QRELIEF_TRY(list_.reserve(vertexCount_, faceCount_));
    for (std::size_t v = 0; v < vertexCount_; ++v) QRELIEF_TRY(readVertex(v + 1, layout.vertexOnLine));
    for (std::size_t f = 0; f < faceCount_; ++f) QRELIEF_TRY(readFace(f + 1, layout.faceOnLine));
    return {};
  }

  static std::optional<std::uint64_t> countFrom(std::string_view word) {
    const std::optional<std::int64_t> count = parseInteger(word);
    return !count || *count < 0 ? std::nullopt : std::optional(static_cast<std::uint64_t>(*count));
  }

  /// Checks the counts against the bytes left. The shortest vertex takes six bytes ("0 0 0" and a line end), the
  /// shortest face two ("0").
  Status checkSizeBound(std::uint64_t vertices, std::uint64_t faces) const {
    if (vertices <= (left() + 1) / 6 && faces <= (left() + 1) / 2) return {};
    return badInput(message<"off-announces">(with::count<"vertices">(vertices), with::count<"faces">(faces),
                                             with::count<"bytes">(left())));
  }

  std::size_t left() const { return text_.size() - scanner_.position(); }  ///< bytes not yet read

  Status readVertex(std::size_t number, bool onLine) {
    Vec3 p(0);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = scanner_.word();
      const std::optional<double> value = parseNumber(word);
      if (!value && hasDecimalComma(word)) return decimalComma("OFF", scanner_.line(), word);
      if (!value)
        return failHere(message<"vertex-of">(with::index<"vertex">(number), with::count<"vertices">(vertexCount_),
                                             with::cause<"cause">(notANumber(word))));
      p[axis] = *value;
    }
    if (onLine) scanner_.restOfLine();  // colour or normal
    list_.positions.push_back(p);
    return {};
  }

  Status readFace(std::size_t number, bool onLine) {
    const std::string_view sizeWord = scanner_.word();
    const auto failAtFace = [&](Message what) {
      return failHere(message<"face-of">(with::index<"face">(number), with::count<"faces">(faceCount_),
                                         with::cause<"cause">(std::move(what))));
    };
    const std::optional<std::uint64_t> size = countFrom(sizeWord);
    if (!size)
      return sizeWord.empty() ? failAtFace(message<"corner-count-missing">())
                              : failAtFace(message<"corner-count">(with::quoted<"word">(excerpt(sizeWord))));
    if (*size > left())
      return failAtFace(message<"corners-missing">(with::count<"corners">(*size), with::count<"count">(left())));
    polygon_.clear();
    for (std::uint64_t k = 0; k < *size; ++k) {
      const std::string_view word = scanner_.word();
      const std::optional<std::int64_t> index = parseInteger(word);
      if (!index) return failAtFace(word.empty() ? notANumber(word) : notAVertex(word));
      if (*index < 0 || static_cast<std::uint64_t>(*index) >= list_.positions.size())
        return failAtFace(noSuchVertex(*index, list_.positions.size()));
      polygon_.push_back(static_cast<std::uint32_t>(*index));
    }
    if (onLine) scanner_.restOfLine();  // colour
    return list_.add(polygon_);
  }

  std::string_view text_;
  TextScanner scanner_, behindCounts_ = scanner_;
  std::size_t maxTriangles_;
  std::string_view verticesWord_;
  bool isPlain_ = true;  // neither colours nor normals
  std::size_t vertexCount_ = 0, faceCount_ = 0;
  PolygonList list_;
  std::vector<std::uint32_t> polygon_;
};

}  // namespace

bool isOffKeyword(std::string_view word) {
  const std::string keyword = keywordFrom(word);
  std::string_view left = keyword;
  if (!left.ends_with("OFF")) return false;
  left.remove_suffix(3);
  for (const std::string_view prefix : {"ST", "C", "N", "4", "n"})
    if (left.starts_with(prefix)) left.remove_prefix(prefix.size());
  return left.empty();
}

Result<PolygonSoup> readOff(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  return OffReader(textOf(bytes), limits).read();
}

}  // namespace qrelief
