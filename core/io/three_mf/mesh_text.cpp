// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/mesh_text.h"

#include <algorithm>
#include <fmt/compile.h>
#include <fmt/format.h>

#include "io/parse_number.h"
#include "io/three_mf/filament_code.h"
#include "io/three_mf/xml_tags.h"

namespace qrelief {
namespace {

constexpr std::uint32_t kNowhere = 0xffffffffu;

std::uint32_t cornerFrom(std::string_view text) {
  const auto number = parseInteger(withoutBlanks(text));
  return number ? static_cast<std::uint32_t>(*number) : 0;
}

MeshText::TriangleText triangleFrom(const XmlTag& tag) {
  MeshText::TriangleText triangle{};
  for (const XmlTag::Attribute& a : tag.attributes()) {
    if (a.name == "v1" || a.name == "v2" || a.name == "v3")
      triangle.corners[a.name[1] - '1'] = cornerFrom(a.value);
    else
      triangle.attributes += fmt::format(" {}", tag.raw.substr(a.begin - tag.begin, a.end - a.begin));
  }
  return triangle;
}

/// Returns the attributes that a piece of a painted triangle keeps.
std::string attributesOf(const MeshText::TriangleText& triangle, KeptAttributes::What what) {
  if (what == KeptAttributes::What::Nothing || triangle.attributes.empty()) return {};
  if (what == KeptAttributes::What::All) return triangle.attributes;
  std::string attributes;
  const std::string text = "<t" + triangle.attributes + "/>";
  for (const XmlTag::Attribute& a : XmlTags(text).next()->attributes()) {
    const bool isPaint = std::find(kFacetPaints.begin(), kFacetPaints.end(), a.name) != kFacetPaints.end();
    if (!isPaint || filamentOfCode(a.value)) attributes += fmt::format(" {}", text.substr(a.begin, a.end - a.begin));
  }
  return attributes;
}

/// Writes vertices and triangles one after the other into two texts, and numbers the vertices.
class MeshWriter {
 public:
  explicit MeshWriter(std::string prefix) : prefix_(std::move(prefix)) {}

  std::uint32_t addVertex(std::string_view tag) {
    vertices_.append(tag).append("\n");
    return count_++;
  }

  /// Adds the vertices of a mesh in mm. @returns the first one's number
  std::uint32_t addVertices(const Mesh& mesh, const ThreeMfRun& run, double unitMm) {
    const std::uint32_t first = count_;
    const Affine toMesh = run.toFile.inverse();
    for (const Vec3f& position : mesh.positions) {
      const Vec3 p = toMesh(Vec3(position) / unitMm);
      fmt::format_to(std::back_inserter(vertices_), FMT_COMPILE("<{}vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n"), prefix_,
                     shortest(p.x), shortest(p.y), shortest(p.z));
      ++count_;
    }
    return first;
  }

  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::string_view attributes) {
    fmt::format_to(std::back_inserter(triangles_), FMT_COMPILE("<{}triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"{}/>\n"),
                   prefix_, a, b, c, attributes);
  }

  /// Adds a mesh that keeps nothing. Mirrored runs have their triangles turned round.
  void addMesh(const Mesh& mesh, const ThreeMfRun& run, double unitMm) {
    const std::uint32_t first = addVertices(mesh, run, unitMm);
    for (const auto& [a, b, c] : mesh.triangles)
      addTriangle(first + a, first + (run.mirrored ? c : b), first + (run.mirrored ? b : c), {});
  }

  /// @param spaces  attributes of `<triangles>`
  std::string text(std::string_view spaces = {}) const {
    return fmt::format("<{0}vertices>\n{1}</{0}vertices>\n<{0}triangles{3}>\n{2}</{0}triangles>\n", prefix_, vertices_,
                       triangles_, spaces);
  }

 private:
  /// Returns the fewest digits that give the number again; for a number that is a 32-bit float, that float.
  static std::string shortest(double value) {
    const auto single = static_cast<float>(value);
    return static_cast<double>(single) == value ? fmt::format("{}", single) : fmt::format("{}", value);
  }

  std::string prefix_, vertices_, triangles_;
  std::uint32_t count_ = 0;
};

}  // namespace

std::optional<MeshText> findMesh(std::string_view model, std::uint32_t object) {
  XmlTags tags(model);
  MeshText mesh;
  bool isInObject = false, isInMesh = false;
  while (const auto tag = tags.next()) {
    if (tag->starts("object")) {
      isInObject = numberFrom(tag->attribute("id")) == object;
    } else if (!isInObject) {
      continue;
    } else if (tag->ends("object")) {
      mesh.objectEnd = tag->end;
      return mesh.begin > 0 ? std::optional(std::move(mesh)) : std::nullopt;
    } else if (tag->starts("mesh")) {
      isInMesh = true;
      mesh.begin = tag->end;
      const std::size_t colon = tag->raw.substr(0, tag->raw.find_first_of(" \t\r\n>")).find(':');
      if (colon != std::string_view::npos) mesh.prefix = tag->raw.substr(1, colon);
    } else if (tag->ends("mesh")) {
      isInMesh = false;
      mesh.end = tag->begin;
    } else if (isInMesh && tag->starts("vertex")) {
      mesh.vertices.push_back(tag->raw);
    } else if (isInMesh && tag->starts("triangle")) {
      mesh.triangles.push_back(triangleFrom(*tag));
    }
  }
  return std::nullopt;
}

std::string changedMesh(const MeshText& mesh, const ThreeMfSource& source, std::span<const ChangedRun* const> changes,
                        const PaintAttributes& paint, bool withInlay) {
  // Triangles of the mesh that stay are used in the file's order, and so are their vertices.
  std::vector<char> stays(mesh.triangles.size(), 1);
  for (const ChangedRun* change : changes) {
    const ThreeMfRun& run = source.runs[change->run];
    std::fill_n(stays.begin() + static_cast<std::ptrdiff_t>(run.firstInMesh), run.count, 0);
  }
  std::vector<std::uint32_t> place(mesh.vertices.size(), kNowhere);
  for (std::size_t t = 0; t < stays.size(); ++t)
    if (stays[t])
      for (const std::uint32_t v : mesh.triangles[t].corners) place[v] = 0;
  MeshWriter writer(mesh.prefix);
  for (std::size_t v = 0; v < place.size(); ++v)
    if (place[v] == 0) place[v] = writer.addVertex(mesh.vertices[v]);

  const auto textOf = [&](std::uint32_t triangle) -> const MeshText::TriangleText& {
    const auto after = std::upper_bound(source.runs.begin(), source.runs.end(), triangle,
                                        [](std::size_t t, const ThreeMfRun& r) { return t < r.firstTriangle; });
    const ThreeMfRun& run = *std::prev(after);
    return mesh.triangles[run.firstInMesh + triangle - run.firstTriangle];
  };
  const auto addChanged = [&](const ChangedRun& change) {
    const ThreeMfRun& run = source.runs[change.run];
    const std::uint32_t first = writer.addVertices(change.mesh, run, source.unitMm);
    auto painted = change.painted.begin();
    for (std::uint32_t t = 0; t < change.mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = change.mesh.triangles[t];
      const KeptAttributes& origin = change.kept[t];
      std::string attributes = origin.what == KeptAttributes::What::Nothing
                                   ? std::string()
                                   : attributesOf(textOf(origin.triangle), origin.what);
      if (painted != change.painted.end() && *painted == t) {
        ++painted;
        attributes = paint.names;
      }
      writer.addTriangle(first + a, first + (run.mirrored ? c : b), first + (run.mirrored ? b : c), attributes);
    }
  };
  auto next = changes.begin();
  for (std::size_t t = 0; t <= mesh.triangles.size(); ++t) {
    while (next != changes.end() && source.runs[(*next)->run].firstInMesh == t) addChanged(**next++);
    if (t == mesh.triangles.size() || !stays[t]) continue;
    const auto& [a, b, c] = mesh.triangles[t].corners;
    writer.addTriangle(place[a], place[b], place[c], mesh.triangles[t].attributes);
  }
  if (withInlay)
    for (const ChangedRun* change : changes)
      if (change->inlay) writer.addMesh(change->inlay->mesh, source.runs[change->run], source.unitMm);
  return "\n" + writer.text(paint.spaces);
}

std::string wholeMesh(const Mesh& mesh, const ThreeMfRun& run, double unitMm, const std::string& prefix) {
  MeshWriter writer(prefix);
  writer.addMesh(mesh, run, unitMm);
  return fmt::format("<{0}mesh>\n{1}</{0}mesh>\n", prefix, writer.text());
}

}  // namespace qrelief
