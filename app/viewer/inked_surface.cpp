// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/inked_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "pipeline/engrave.h"

namespace qrelief {
namespace {

constexpr double kExposure = 0.66;  // shown albedo of a reflectance of 1, so that the view's light does not saturate

/// Returns the inlay's triangles with indices of `mesh`, to which positions are added that it does not have.
/// @param firstNew  first of the triangles that may touch the inlay
std::vector<Triangle> joined(const Mesh& inlay, Mesh& mesh, std::size_t firstNew) {
  std::map<std::array<float, 3>, std::uint32_t> known;
  const auto key = [](Vec3f p) { return std::array{p.x, p.y, p.z}; };
  for (std::size_t t = firstNew; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) known.emplace(key(mesh.positions[v]), v);
  std::vector<std::uint32_t> place;
  place.reserve(inlay.positions.size());
  for (const Vec3f& position : inlay.positions) {
    const auto [at, isNew] = known.emplace(key(position), static_cast<std::uint32_t>(mesh.positions.size()));
    if (isNew) mesh.positions.push_back(position);
    place.push_back(at->second);
  }
  std::vector<Triangle> triangles = inlay.triangles;
  for (Triangle& triangle : triangles)
    for (std::uint32_t& v : triangle) v = place[v];
  return triangles;
}

Triangle sorted(Triangle triangle) {
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

/// Adds an inlay to the body in whose pockets it lies.
InkedSurface withInlay(const EngraveResult& result) {
  Mesh body = result.mesh;
  const std::size_t keptTriangles = result.keptTriangles;
  const std::vector<Triangle> inlay = joined(*result.inlay, body, keptTriangles);
  std::set<Triangle> ofBody, touching;
  for (std::size_t t = keptTriangles; t < body.triangles.size(); ++t) ofBody.insert(sorted(body.triangles[t]));
  for (const Triangle& triangle : inlay)
    if (ofBody.contains(sorted(triangle))) touching.insert(sorted(triangle));
  const auto isInside = [&](const Triangle& triangle) { return touching.contains(sorted(triangle)); };
  body.triangles.erase(std::remove_if(body.triangles.begin() + static_cast<std::ptrdiff_t>(keptTriangles),
                                      body.triangles.end(), isInside),
                       body.triangles.end());
  InkedSurface surface{std::move(body), {}};
  surface.isInk.assign(surface.mesh.triangles.size(), false);
  for (const Triangle& triangle : inlay) {
    if (isInside(triangle)) continue;
    surface.mesh.triangles.push_back(triangle);
    surface.isInk.push_back(true);
  }
  return surface;
}

/// Returns the grey of a reflectance, 0 … 1 [IEC 61966-2-1].
Colour greyOf(double reflectance) {
  const double grey = reflectance <= 0.0031308 ? 12.92 * reflectance : 1.055 * std::pow(reflectance, 1 / 2.4) - 0.055;
  const auto level = static_cast<std::uint8_t>(std::lround(255 * grey));
  return {level, level, level};
}

}  // namespace

SurfaceColours coloursOf(const Ink& ink) {
  return {Vec3f(static_cast<float>(kExposure * ink.light)), Vec3f(static_cast<float>(kExposure * ink.dark))};
}

InkedSurface inkedSurface(const EngraveResult& result) {
  if (result.inlay) return withInlay(result);
  InkedSurface surface{result.mesh, std::vector<bool>(result.mesh.triangles.size(), false)};
  for (const std::uint32_t triangle : result.painted) surface.isInk[triangle] = true;
  return surface;
}

std::vector<std::optional<Colour>> inkedColours(const InkedSurface& surface, const EngraveResult& result,
                                                std::span<const std::optional<Colour>> ofModel) {
  const Ink ink = result.request.marking.ink();
  const auto body = [&](std::size_t t) -> std::optional<Colour> {
    if (ofModel.empty()) return greyOf(ink.light);
    return ofModel[t < result.keptTriangles ? result.origins[t].facet : result.placement.seed];
  };
  std::vector<std::optional<Colour>> colours;
  colours.reserve(surface.isInk.size());
  for (std::size_t t = 0; t < surface.isInk.size(); ++t)
    colours.push_back(surface.isInk[t] ? greyOf(ink.dark) : body(t));
  return colours;
}

}  // namespace qrelief
