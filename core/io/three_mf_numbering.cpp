// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf_numbering.h"

#include <algorithm>
#include <fmt/format.h>

namespace qrelief {
namespace {

bool isPainted(const ModelObject& object) {
  return std::any_of(object.bodies.begin(), object.bodies.end(),
                     [](const ModelBody& b) { return b.paint.has_value(); });
}

/// Returns the name of a colour's material; empty if nothing names it.
std::string materialOf(const Colour& colour, std::span<const ModelObject> objects) {
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies) {
      if (body.colour == colour && !body.material.empty()) return body.material;
      if (body.paint && body.paint->colour == colour && !body.paint->material.empty()) return body.paint->material;
    }
  return {};
}

bool isForBambu(Slicer slicer) { return slicer == Slicer::OrcaSlicer || slicer == Slicer::BambuStudio; }

}  // namespace

Numbering::Numbering(std::span<const ModelObject> objectsToWrite, const WriteOptions& options) {
  colours = coloursOf(objectsToWrite);
  for (const Colour& colour : colours) {
    const std::string name = materialOf(colour, objectsToWrite);
    materials.push_back(name.empty() ? fmt::format("Filament {}", materials.size() + 1) : name);
  }
  std::size_t nextId = colours.size() + 1;
  for (const ModelObject& object : objectsToWrite) {
    NumberedObject numbered;
    numbered.object = &object;
    numbered.name = !object.name.empty()         ? object.name
                    : objectsToWrite.size() == 1 ? options.title
                                                 : fmt::format("Object {}", objects.size() + 1);
    const bool isInFile =
        isForBambu(options.slicer) ? isColoured() : options.slicer == Slicer::Any && isPainted(object);
    numbered.isInOneMesh = options.slicer == Slicer::PrusaSlicer;
    numbered.hasComponents = !numbered.isInOneMesh && (object.bodies.size() > 1 || isInFile);
    if (isInFile) numbered.path = fmt::format("/3D/Objects/object_{}.model", objects.size() + 1);
    for (const ModelBody& body : object.bodies) {
      const std::string name = !body.name.empty() ? body.name : numbered.name;
      const std::size_t id = numbered.isInOneMesh ? nextId : nextId++;
      numbered.bodies.push_back(
          {&body, name, id, filamentOf(body.colour), body.paint ? filamentOf(body.paint->colour) : 0});
    }
    numbered.id = numbered.hasComponents || numbered.isInOneMesh ? nextId++ : numbered.bodies.front().id;
    objects.push_back(std::move(numbered));
  }
  materialsId = nextId;
}

bool Numbering::hasPaint() const {
  return std::any_of(objects.begin(), objects.end(), [](const NumberedObject& o) { return isPainted(*o.object); });
}

bool Numbering::hasPartFiles() const {
  return std::any_of(objects.begin(), objects.end(), [](const NumberedObject& o) { return !o.path.empty(); });
}

std::size_t Numbering::filamentOf(const std::optional<Colour>& colour) const {
  if (!colour) return 1;
  return static_cast<std::size_t>(std::find(colours.begin(), colours.end(), *colour) - colours.begin()) + 1;
}

}  // namespace qrelief
