// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_model.h"

#include <algorithm>

#include "io/three_mf/write_3mf.h"
#include "io/write_obj.h"
#include "io/write_ply.h"
#include "io/write_stl.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

/// Joins all bodies into one surface, for formats without objects.
Mesh joined(std::span<const ModelObject> objects) {
  Mesh mesh;
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), body.mesh.positions.begin(), body.mesh.positions.end());
      for (const auto& [a, b, c] : body.mesh.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
    }
  return mesh;
}

Status checkRequest(std::span<const ModelObject> objects, ModelFormat format, const WriteOptions& options) {
  if (options.ascii && format != ModelFormat::Stl)
    return fail(ErrorKind::BadUsage, message<"write-text-no-choice">(with::term<"format">(nameOf(format))));
  const auto any = [&](auto has) { return std::any_of(objects.begin(), objects.end(), has); };
  const bool holdsBodies = format == ModelFormat::ThreeMf || format == ModelFormat::Obj;
  const bool holdsPaint =
      format == ModelFormat::ThreeMf || (format == ModelFormat::Obj && !options.materialFile.empty());
  if ((!holdsBodies && any([](const ModelObject& o) { return o.bodies.size() > 1; })) ||
      (!holdsPaint && any([](const ModelObject& o) { return !o.bodies.empty() && o.bodies.front().paint; })))
    return fail(ErrorKind::BadUsage, message<"write-several-bodies">(with::term<"format">(nameOf(format))));
  if (options.palette && !hasPalette(options.slicer)) return fail(ErrorKind::BadUsage, message<"write-no-palette">());
  return {};
}

}  // namespace

Result<std::vector<std::uint8_t>> writeModel(std::span<const ModelObject> objects, ModelFormat format,
                                             const WriteOptions& options) {
  QRELIEF_TRY(checkRequest(objects, format, options));
  switch (format) {
    case ModelFormat::Stl:
      return options.ascii ? writeAsciiStl(joined(objects), options.title) : writeStl(joined(objects), options.title);
    case ModelFormat::Obj:
      return writeObj(objects, options);
    case ModelFormat::Ply:
      return writePly(objects, options);
    case ModelFormat::ThreeMf:
      return write3mf(objects, options);
    case ModelFormat::Off:
    case ModelFormat::Gltf:
    case ModelFormat::Unknown:
      break;
  }
  if (format == ModelFormat::Unknown) return fail(ErrorKind::BadUsage, message<"write-format-unknown">());
  return fail(ErrorKind::BadUsage, message<"write-format">(with::term<"format">(nameOf(format))));
}

Result<std::vector<std::uint8_t>> writeModel(const Mesh& mesh, ModelFormat format, const WriteOptions& options) {
  const ModelObject object{options.title, {{{}, mesh, std::nullopt}}};
  return writeModel(std::span(&object, 1), format, options);
}

std::vector<Colour> coloursOf(std::span<const ModelObject> objects) {
  std::vector<Colour> colours;
  const auto add = [&](Colour colour) {
    if (std::find(colours.begin(), colours.end(), colour) == colours.end()) colours.push_back(colour);
  };
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies) {
      if (body.colour) add(*body.colour);
      if (body.paint) add(body.paint->colour);
    }
  return colours;
}

std::vector<std::uint32_t> trianglesOf(std::span<const std::uint32_t> partOf, std::uint32_t part) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t t = 0; t < partOf.size(); ++t)
    if (partOf[t] == part) triangles.push_back(static_cast<std::uint32_t>(t));
  return triangles;
}

std::vector<std::uint32_t> placesIn(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> subset) {
  std::vector<std::uint32_t> places;
  for (const std::uint32_t t : subset) {
    const auto it = std::lower_bound(triangles.begin(), triangles.end(), t);
    if (it != triangles.end() && *it == t) places.push_back(static_cast<std::uint32_t>(it - triangles.begin()));
  }
  return places;
}

Mesh submesh(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  Mesh part;
  std::vector<std::uint32_t> used;
  used.reserve(3 * triangles.size());
  for (const std::uint32_t t : triangles) used.insert(used.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const std::uint32_t v : used) part.positions.push_back(mesh.positions[v]);
  const auto place = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  };
  for (const std::uint32_t t : triangles) {
    const auto& [a, b, c] = mesh.triangles[t];
    part.triangles.push_back({place(a), place(b), place(c)});
  }
  return part;
}

std::vector<ModelObject> objectsOf(const Mesh& mesh, std::span<const std::uint32_t> partOf,
                                   std::span<const std::string> names) {
  const std::size_t parts = partOf.empty() ? 1 : *std::max_element(partOf.begin(), partOf.end()) + std::size_t{1};
  std::vector<ModelObject> objects(parts);
  for (std::size_t p = 0; p < parts; ++p) {
    if (p < names.size()) objects[p].name = names[p];
    objects[p].bodies.resize(1);
  }
  if (partOf.empty()) {
    objects.front().bodies.front().mesh = mesh;
    return objects;
  }
  std::vector<std::vector<std::uint32_t>> ofPart(parts);
  for (std::size_t t = 0; t < partOf.size(); ++t) ofPart[partOf[t]].push_back(static_cast<std::uint32_t>(t));
  for (std::size_t p = 0; p < parts; ++p) objects[p].bodies.front().mesh = submesh(mesh, ofPart[p]);
  std::erase_if(objects, [](const ModelObject& o) { return o.bodies.front().mesh.triangles.empty(); });
  return objects;
}

}  // namespace qrelief
