// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_obj.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <streambuf>
#include <string>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"
#include "mesh/topology.h"
#include "mesh/weld.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

/// Returns the kind of a statement, in small letters or capitals: 'v', 'f', 'g' for the start of a group or an object,
/// 'c' for a free-form curve or surface, or 0 for everything else.
char kindOf(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  const std::size_t end = line.find_first_of(" \t");
  if (end == std::string_view::npos) return 0;
  const std::string word = lowerCase(line.substr(0, end));
  if (word == "v" || word == "f" || word == "g") return word[0];
  if (word == "o") return 'g';
  if (word == "fo") return 'f';  // of the first versions of the format
  return word == "curv" || word == "surf" ? 'c' : static_cast<char>(0);
}

/// A group or an object of the file: its faces end at the next one's first.
struct Group {
  std::string name;
  std::size_t firstFace = 0;
};

std::size_t countVertices(std::string_view text) {
  std::size_t count = 0;
  for (TextScanner scanner(text); !scanner.atEnd();) count += kindOf(scanner.restOfLine()) == 'v';
  return count;
}

/// A stream buffer that passes on the `v` and `f` statements of an OBJ, one per line, and checks each one first. It
/// ends at the first bad statement and keeps the error.
class VettedStatements : public std::streambuf {
 public:
  explicit VettedStatements(std::string_view text) : scanner_(text), vertices_(countVertices(text)) {}

  std::size_t vertices() const { return vertices_; }  ///< number of vertices in the whole file
  const std::vector<Group>& groups() const { return groups_; }
  const std::vector<Colour>& colours() const { return colours_; }  ///< of the vertices that have one
  bool hasCurves() const { return hasCurves_; }                    ///< or exact surfaces
  const Status& status() const { return status_; }
  void stop(Error error) { status_ = tl::unexpected(std::move(error)); }

 protected:
  int_type underflow() override {
    if (!status_ || !nextStatement()) return traits_type::eof();
    setg(statement_.data(), statement_.data(), statement_.data() + statement_.size());
    return traits_type::to_int_type(statement_.front());
  }

 private:
  bool nextStatement() {
    while (!scanner_.atEnd()) {
      line_ = scanner_.line();
      const std::string_view text = scanner_.restOfLine();
      const char kind = kindOf(text);
      if (kind == 'g') groups_.push_back({std::string(nameIn(text)), facesSoFar_});
      if (kind == 'c') hasCurves_ = true;
      if (kind != 'v' && kind != 'f') continue;
      statement_ = text;
      const std::size_t keyword = statement_.find_first_not_of(" \t");
      statement_[keyword] = kind;
      if (kind == 'f') statement_[keyword + 1] = ' ';  // in place of the "o" of "fo"
      while (isContinued() && !scanner_.atEnd()) {
        statement_.back() = ' ';
        statement_ += scanner_.restOfLine();
      }
      if (const std::size_t comment = statement_.find('#'); comment != std::string::npos) statement_.resize(comment);
      status_ = kind == 'v' ? vetVertex() : vetFace();
      facesSoFar_ += kind == 'f';
      statement_ += '\n';
      return status_.has_value();
    }
    return false;
  }

  /// Returns the rest of a line behind its first word.
  static std::string_view nameIn(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t") + 1, line.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    return line.substr(0, line.find_last_not_of(" \t\r") + 1);
  }

  /// Returns true if the statement goes on in the next line; then removes blanks after the backslash.
  bool isContinued() {
    const std::size_t last = statement_.find_last_not_of(" \t");
    if (last == std::string::npos || statement_[last] != '\\') return false;
    statement_.resize(last + 1);
    return true;
  }

  Status failHere(Message what) const {
    return badInput(message<"obj-line">(with::index<"line">(line_), with::cause<"cause">(std::move(what))));
  }

  Status failAtVertex(Message what) const {
    return failHere(
        message<"vertex">(with::index<"vertex">(verticesSoFar_ + 1), with::cause<"cause">(std::move(what))));
  }

  Status vetVertex() {
    TextScanner words(statement_);
    words.wordOnLine();
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = words.wordOnLine();
      const std::optional<double> value = parseNumber(word);
      if (!value && hasDecimalComma(word)) return decimalComma("OBJ", line_, word);
      if (!value) return failAtVertex(notANumber(word));
      if (!std::isfinite(*value)) return failAtVertex(notFinite(word));
    }
    takeColour(words);
    ++verticesSoFar_;
    return {};
  }

  /// Takes three numbers behind a vertex's coordinates as its colour, 0 … 1. A fourth coordinate alone is none.
  void takeColour(TextScanner& words) {
    Colour colour{};
    for (std::uint8_t& channel : colour) {
      const std::optional<double> value = parseNumber(words.wordOnLine());
      if (!value) return;
      channel = static_cast<std::uint8_t>(std::lround(255 * std::clamp(*value, 0.0, 1.0)));
    }
    colours_.push_back(colour);
  }

  /// Checks a face such as "7", "7/1", "7//3", "7/1/3". Only the first number of a word is used; it must name a vertex
  /// of the file.
  Status vetFace() {
    TextScanner words(statement_);
    words.wordOnLine();
    for (std::string_view word = words.wordOnLine(); !word.empty(); word = words.wordOnLine()) {
      const bool malformed = word.find_first_not_of("+-0123456789/") != std::string_view::npos;
      const std::optional<std::int64_t> index = malformed ? std::nullopt : parseInteger(word.substr(0, word.find('/')));
      if (!index) return failHere(message<"obj-corner">(with::quoted<"word">(excerpt(word))));
      if (*index > 0 && static_cast<std::uint64_t>(*index) <= vertices_) continue;
      if (*index < 0 && *index >= -static_cast<std::int64_t>(verticesSoFar_)) continue;
      if (*index == 0) return failHere(message<"obj-vertex-zero">());
      if (*index > 0)
        return failHere(message<"obj-vertex-missing">(with::index<"vertex">(*index), with::count<"count">(vertices_)));
      return failHere(
          message<"obj-vertex-not-yet">(with::index<"vertex">(*index), with::count<"count">(verticesSoFar_)));
    }
    return {};
  }

  TextScanner scanner_;
  std::size_t vertices_;
  std::size_t verticesSoFar_ = 0, facesSoFar_ = 0;
  std::vector<Group> groups_;
  std::vector<Colour> colours_;
  bool hasCurves_ = false;
  std::size_t line_ = 1;
  std::string statement_;
  Status status_;
};

struct Collector {
  VettedStatements& statements;
  PolygonList list;
  std::vector<std::uint32_t> polygon;
  std::vector<std::size_t> firstTriangles;  // of each face
};

void takeVertex(void* user, double x, double y, double z, double) {
  static_cast<Collector*>(user)->list.positions.emplace_back(x, y, z);
}

void takeFace(void* user, tinyobj::index_t* indices, int count) {
  Collector& collector = *static_cast<Collector*>(user);
  collector.polygon.clear();
  for (int k = 0; k < count; ++k) {
    const int index = indices[k].vertex_index;
    collector.polygon.push_back(index > 0 ? static_cast<std::uint32_t>(index - 1)
                                          : static_cast<std::uint32_t>(collector.list.positions.size()) -
                                                static_cast<std::uint32_t>(-index));
  }
  collector.firstTriangles.push_back(collector.list.triangles);
  if (Status s = collector.list.add(collector.polygon); !s) collector.statements.stop(s.error());
}

/// Returns true if the triangles from `begin` to `end` have no open edge.
bool isClosed(const PolygonSoup& soup, std::size_t begin, std::size_t end) {
  std::vector<Vec3f> corners;
  for (std::size_t t = begin; t < end; ++t)
    for (const std::uint32_t v : soup.triangles[t]) corners.emplace_back(soup.positions[v]);
  Mesh mesh = weldedByGroup(corners, {});
  std::erase_if(mesh.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  const EdgeTable edges = buildEdgeTable(mesh.triangles);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.at(e).size() % 2 == 1) return false;
  return !mesh.triangles.empty();
}

/// Makes a body of each group that is closed by itself, and one body of all other groups: these divide one surface, by
/// material or smoothing.
/// @param firstTriangles  of each face
void setBodies(std::span<const Group> groups, std::span<const std::size_t> firstTriangles, PolygonSoup& soup) {
  const auto triangleOf = [&](std::size_t face) {
    return face < firstTriangles.size() ? firstTriangles[face] : soup.triangles.size();
  };
  if (groups.empty() || (groups.size() == 1 && groups[0].firstFace == 0)) return;
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> bodyOf(soup.triangles.size(), kNone);
  std::vector<Body> bodies;
  std::size_t named = 0;  // triangles of closed groups
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::size_t begin = triangleOf(groups[g].firstFace);
    const std::size_t end = g + 1 < groups.size() ? triangleOf(groups[g + 1].firstFace) : soup.triangles.size();
    if (begin == end || !isClosed(soup, begin, end)) continue;
    std::fill(bodyOf.begin() + static_cast<std::ptrdiff_t>(begin), bodyOf.begin() + static_cast<std::ptrdiff_t>(end),
              static_cast<std::uint32_t>(bodies.size()));
    bodies.push_back({groups[g].name});
    named += end - begin;
  }
  if (named < soup.triangles.size()) {
    std::replace(bodyOf.begin(), bodyOf.end(), kNone, static_cast<std::uint32_t>(bodies.size()));
    bodies.emplace_back();
  }
  if (bodies.size() < 2) return;
  soup.bodies = std::move(bodies);
  soup.bodyOf = std::move(bodyOf);
}

}  // namespace

Result<PolygonSoup> readObj(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  VettedStatements statements(textOf(bytes));
  if (statements.vertices() == 0) return badInput(message<"obj-no-vertex">());
  Collector collector{statements, {}, {}, {}};
  collector.list.maxTriangles = limits.maxTriangles;
  QRELIEF_TRY(collector.list.reserve(statements.vertices(), 0));

  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = takeVertex;
  callbacks.index_cb = takeFace;
  std::istream stream(&statements);
  const bool parsed = tinyobj::LoadObjWithCallback(stream, callbacks, &collector);
  if (!statements.status()) return tl::unexpected(statements.status().error());
  if (!parsed || collector.list.positions.size() != statements.vertices()) return badInput(message<"obj-not-parsed">());
  if (collector.firstTriangles.empty() && statements.hasCurves()) return badInput(message<"obj-only-curves">());
  const std::size_t triangles = collector.list.triangles;
  collector.list.colours = statements.colours();
  Result<PolygonSoup> soup = triangulated(std::move(collector.list), "OBJ");
  if (soup && soup->triangles.size() == triangles) setBodies(statements.groups(), collector.firstTriangles, *soup);
  return soup;
}

}  // namespace qrelief
