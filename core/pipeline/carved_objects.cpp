// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/carved_objects.h"

#include <algorithm>

namespace qrelief {
namespace {

constexpr Colour kBodyColour = {235, 235, 230};
constexpr Colour kInlayColour = {25, 25, 30};
constexpr const char *kBodyMaterial = "Model", *kInlayMaterial = "QR code";

/// Returns the index of the object with the carved part. Parts without triangles have no object.
std::size_t carvedObject(const EngraveResult& result) {
  std::vector<std::uint32_t> parts = result.partOfTriangle;
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  return static_cast<std::size_t>(std::lower_bound(parts.begin(), parts.end(), result.carvedPart) - parts.begin());
}

std::vector<std::uint32_t> paintedOfCarvedPart(const EngraveResult& result) {
  if (result.partOfTriangle.empty()) return result.painted;
  return placesIn(trianglesOf(result.partOfTriangle, result.carvedPart), result.painted);
}

}  // namespace

bool holdsColoursOf(const EngraveRequest& request, ModelFormat format) {
  if (format == ModelFormat::ThreeMf || format == ModelFormat::Obj) return true;
  if (format == ModelFormat::Stl) return request.marking.mark != Mark::Paint;
  return !request.marking.isInColour() && !request.marking.inlay;
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
                                       bool withInlay) {
  std::vector<ModelObject> objects = objectsOf(result.mesh, result.partOfTriangle, partNames);
  const bool hasInlay = withInlay && result.inlay;
  if (!hasInlay && result.painted.empty()) return objects;
  ModelObject& carved = objects[carvedObject(result)];
  ModelBody& body = carved.bodies.front();
  body.colour = kBodyColour;
  body.material = kBodyMaterial;
  if (!result.painted.empty()) body.paint = FacetPaint{kInlayColour, paintedOfCarvedPart(result), kInlayMaterial};
  if (hasInlay) carved.bodies.push_back(codeBody(*result.inlay));
  return objects;
}

ModelBody codeBody(const Mesh& inlay) { return {"QR code", inlay, kInlayColour, {}, kInlayMaterial}; }

std::array<Material, 2> filamentMaterials() { return {{{kBodyMaterial, kBodyColour}, {kInlayMaterial, kInlayColour}}}; }

std::vector<ModelObject> copyOnPlate(std::vector<ModelObject> objects, const std::string& id, const std::string& text,
                                     Vec3 offsetMm) {
  for (ModelObject& object : objects) {
    object.name = object.name.empty() ? id : id + " " + object.name;
    object.description = text;
    object.offsetMm = offsetMm;
  }
  return objects;
}

}  // namespace qrelief
