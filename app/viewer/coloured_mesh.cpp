// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/coloured_mesh.h"

#include <map>
#include <set>

namespace qrelief {
namespace {

constexpr std::size_t kMostPainted = 64;  // more colours come from a scan

bool isPainted(std::span<const std::optional<Colour>> colours) {
  std::set<Colour> different;
  for (const auto& colour : colours) {
    different.insert(colour.value_or(kPlainColour));
    if (different.size() > kMostPainted) return false;
  }
  return true;
}

std::vector<Colour> meanColours(const Mesh& mesh, std::span<const std::optional<Colour>> colours) {
  std::vector<std::array<std::uint32_t, 4>> sums(mesh.positions.size());  // and the count
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Colour colour = colours[t].value_or(kPlainColour);
    for (const std::uint32_t v : mesh.triangles[t]) {
      for (std::size_t k = 0; k < colour.size(); ++k) sums[v][k] += colour[k];
      ++sums[v][3];
    }
  }
  std::vector<Colour> means(sums.size(), kPlainColour);
  for (std::size_t v = 0; v < sums.size(); ++v)
    for (std::size_t k = 0; k < 3 && sums[v][3] > 0; ++k)
      means[v][k] = static_cast<std::uint8_t>(sums[v][k] / sums[v][3]);
  return means;
}

}  // namespace

std::vector<Colour> splitAtColours(DisplayMesh& display, std::span<const std::optional<Colour>> colours) {
  Mesh& mesh = display.mesh;
  if (colours.empty()) return {};
  if (!isPainted(colours)) return meanColours(mesh, colours);
  std::vector<std::optional<Colour>> ofVertices(mesh.positions.size());
  std::map<std::pair<std::uint32_t, Colour>, std::uint32_t> copies;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Colour colour = colours[t].value_or(kPlainColour);
    for (std::uint32_t& v : mesh.triangles[t]) {
      if (!ofVertices[v]) ofVertices[v] = colour;
      if (ofVertices[v] == colour) continue;
      const auto [copy, isNew] = copies.emplace(std::pair(v, colour), static_cast<std::uint32_t>(ofVertices.size()));
      if (isNew) {
        mesh.positions.push_back(Vec3f(mesh.positions[v]));
        display.normals.push_back(Vec3f(display.normals[v]));
        ofVertices.emplace_back(colour);
      }
      v = copy->second;
    }
  }
  std::vector<Colour> result;
  result.reserve(ofVertices.size());
  for (const auto& colour : ofVertices) result.push_back(colour.value_or(kPlainColour));
  return result;
}

GpuMesh colouredMesh(DisplayMesh display, std::span<const std::optional<Colour>> colours) {
  const std::vector<Colour> ofVertices = splitAtColours(display, colours);
  GpuMesh mesh(display.mesh, display.normals);
  if (!ofVertices.empty()) mesh.setColours(ofVertices);
  return mesh;
}

}  // namespace qrelief
