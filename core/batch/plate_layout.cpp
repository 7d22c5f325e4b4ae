// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/plate_layout.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "math/affine.h"

namespace qrelief {
namespace {

double roundedUp(double mm) { return std::ceil(100 * mm) / 100; }

}  // namespace

std::vector<Vec3> plateOffsets(const Box3& box, std::size_t copies, double gapMm) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(copies))));
  const Vec3 size = box.size();
  std::vector<Vec3> offsets;
  for (std::size_t i = 0; i < copies; ++i) {
    const std::size_t column = i % columns, row = i / columns;
    offsets.emplace_back(roundedUp(static_cast<double>(column) * (size.x + gapMm) - box.min.x),
                         roundedUp(static_cast<double>(row) * (size.y + gapMm) - box.min.y), roundedUp(-box.min.z));
  }
  return offsets;
}

std::vector<ModelObject> namedCopy(std::vector<ModelObject> objects, const std::string& id, const std::string& text) {
  for (ModelObject& object : objects) {
    object.name = object.name.empty() ? id : id + " " + object.name;
    object.description = text;
  }
  return objects;
}

std::vector<ModelObject> onPlate(std::vector<std::vector<ModelObject>> copies) {
  Box3 box;  // holds each copy
  for (const std::vector<ModelObject>& copy : copies)
    for (const ModelObject& object : copy)
      for (const ModelBody& body : object.bodies)
        for (const Vec3f& p : body.mesh.positions) box.add(turnedUp(object.up)(Vec3(p)));
  const std::vector<Vec3> offsets = plateOffsets(box, copies.size());
  std::vector<ModelObject> objects;
  for (std::size_t i = 0; i < copies.size(); ++i)
    for (ModelObject& object : copies[i]) {
      object.offsetMm = offsets[i];
      objects.push_back(std::move(object));
    }
  return objects;
}

std::string plateName(std::size_t plate, std::size_t plates) {
  return fmt::format("plate-{:0{}}.3mf", plate + 1, std::max<std::size_t>(3, std::to_string(plates).size()));
}

}  // namespace qrelief
