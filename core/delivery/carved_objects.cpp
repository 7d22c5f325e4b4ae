// SPDX-License-Identifier: GPL-3.0-or-later
#include "delivery/carved_objects.h"

#include <algorithm>
#include <optional>

#include "io/three_mf/filament_code.h"
#include "pipeline/engrave.h"

namespace qrelief {
namespace {

constexpr Colour kBodyColour = {235, 235, 230};
constexpr Colour kInlayColour = {25, 25, 30};
constexpr const char *kBodyMaterial = "Model", *kInlayMaterial = "QR code";

/// Returns, for each body of the model, the group that it is written with: itself, or all bodies of its object. Shells
/// of a file that names no bodies stay together.
std::vector<std::uint32_t> groupsOf(std::span<const Body> bodies, bool apart) {
  std::vector<std::uint32_t> groups;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    const auto sameGroup = [&](const Body& other) { return other.part == bodies[b].part; };
    const auto first = std::find_if(bodies.begin(), bodies.end(), sameGroup);
    groups.push_back(apart && !bodies[b].isShell ? b : static_cast<std::uint32_t>(first - bodies.begin()));
  }
  return groups;
}

}  // namespace

bool holdsColoursOf(const EngraveRequest& request, ModelFormat format) {
  if (format == ModelFormat::ThreeMf || format == ModelFormat::Obj) return true;
  if (format == ModelFormat::Stl) return request.marking.mark != Mark::Paint;
  return !request.marking.isInColour();
}

std::vector<Mark> marksInColour(ModelFormat format) {
  std::vector<Mark> marks;
  for (const Mark mark : {Mark::Inlay, Mark::Paint}) {
    EngraveRequest request;
    request.marking.mark = mark;
    if (holdsColoursOf(request, format)) marks.push_back(mark);
  }
  return marks;
}

std::vector<ModelObject> carvedObjects(const EngraveResult& result, std::span<const std::string> partNames,
                                       bool withInlay, bool apart) {
  const std::vector<std::uint32_t> groups = groupsOf(result.bodies, apart);
  std::vector<std::uint32_t> groupOf;
  for (const std::uint32_t body : result.mesh.bodyOf) groupOf.push_back(groups[body]);

  const bool hasFilaments =
      std::any_of(result.bodies.begin(), result.bodies.end(), [](const Body& body) { return body.filament != 0; });

  std::vector<ModelObject> objects;
  std::optional<std::uint32_t> part;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    const Body& body = result.bodies[g];
    if (groups[g] != g) continue;
    ModelBody written{body.name, result.mesh, {}};
    std::vector<std::uint32_t> painted = result.painted;
    if (!groupOf.empty()) {
      const std::vector<std::uint32_t> triangles = trianglesOf(groupOf, g);
      if (triangles.empty()) continue;
      written.mesh = submesh(result.mesh, triangles);
      painted = placesIn(triangles, painted);
    }
    if (part != body.part) {
      objects.push_back({body.part < partNames.size() ? partNames[body.part] : "", {}});
      objects.back().up = result.request.print.buildUp.resolve(result.placement.frame);
    }
    part = body.part;
    std::vector<ModelBody>& bodies = objects.back().bodies;
    if (bodies.empty() && !apart) written.name.clear();
    const bool isCarved = groups[result.carvedBody] == g;
    const bool hasInlay = isCarved && withInlay && result.inlay;
    if (apart) written.filament = body.filament;
    if (hasInlay || (isCarved && !painted.empty())) {
      written.colour = kBodyColour;
      written.material = kBodyMaterial;
    }
    const std::uint32_t codeFilament = apart && hasFilaments ? secondFilament(body.filament) : 0;
    if (isCarved && !painted.empty())
      written.paint = FacetPaint{kInlayColour, std::move(painted), kInlayMaterial, codeFilament};
    bodies.push_back(std::move(written));
    if (hasInlay) {
      bodies.push_back(codeBody(*result.inlay));
      bodies.back().filament = codeFilament;
    }
  }
  return objects;
}

ModelBody codeBody(const Mesh& inlay) { return {"QR code", inlay, kInlayColour, {}, kInlayMaterial}; }

std::array<Material, 2> filamentMaterials() { return {{{kBodyMaterial, kBodyColour}, {kInlayMaterial, kInlayColour}}}; }

}  // namespace qrelief
