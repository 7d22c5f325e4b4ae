// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/numbering.h"

#include <algorithm>
#include <array>
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

/// Colours of filaments to which nothing gives a colour, in turn.
constexpr std::array<Colour, 6> kFilamentColours = {
    {{235, 235, 230}, {25, 25, 30}, {200, 45, 40}, {45, 110, 190}, {235, 185, 40}, {60, 150, 80}}};

/// Returns the colours of filaments 1 to the last that a body or paint has as its number; empty if none has one.
std::vector<Colour> coloursOfNumbers(std::span<const ModelObject> objects) {
  std::vector<std::optional<Colour>> given;
  const auto take = [&](std::uint32_t filament, const std::optional<Colour>& colour) {
    if (filament == 0) return;
    given.resize(std::max<std::size_t>(given.size(), filament));
    if (!given[filament - 1]) given[filament - 1] = colour;
  };
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies) {
      take(body.filament, body.colour);
      if (body.paint) take(body.paint->filament, body.paint->colour);
    }
  std::vector<Colour> colours;
  for (const auto& colour : given)
    colours.push_back(colour.value_or(kFilamentColours[colours.size() % kFilamentColours.size()]));
  return colours;
}

bool isForBambu(Slicer slicer) { return slicer == Slicer::OrcaSlicer || slicer == Slicer::BambuStudio; }

}  // namespace

Numbering::Numbering(std::span<const ModelObject> objectsToWrite, const WriteOptions& options) {
  colours = coloursOfNumbers(objectsToWrite);
  hasNumbers_ = !colours.empty();
  if (!hasNumbers_) colours = coloursOf(objectsToWrite);
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
      numbered.bodies.push_back({&body, name, id, filamentOf(body.filament, body.colour),
                                 body.paint ? filamentOf(body.paint->filament, body.paint->colour) : 0});
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

std::size_t Numbering::filamentOf(std::uint32_t number, const std::optional<Colour>& colour) const {
  if (number != 0) return number;
  if (!colour || hasNumbers_) return 1;
  return static_cast<std::size_t>(std::find(colours.begin(), colours.end(), *colour) - colours.begin()) + 1;
}

}  // namespace qrelief
