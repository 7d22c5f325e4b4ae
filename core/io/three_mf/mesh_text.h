// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/three_mf/rewrite_3mf.h"
#include "io/three_mf/xml_tags.h"

namespace qrelief {

/// An object of a model part as text: the position of its mesh, and each vertex and triangle.
struct MeshText {
  struct TriangleText {
    Triangle corners;
    std::string attributes;  ///< except the corners, each after a blank
  };
  std::size_t begin = 0, end = 0;          ///< bytes between "<mesh>" and "</mesh>"
  std::size_t objectEnd = 0;               ///< byte after "</object>"
  std::string prefix;                      ///< of the elements' names, with a colon
  std::vector<std::string_view> vertices;  ///< whole tags
  std::vector<TriangleText> triangles;
};

/// Finds an object with a mesh. @returns none if the text has none with that id
std::optional<MeshText> findMesh(std::string_view model, std::uint32_t object);

/// Attributes of painted triangles, each after a blank.
struct PaintAttributes {
  std::string names;   ///< with their values; empty if no triangle is painted
  std::string spaces;  ///< declarations of namespaces that the model part lacks
};

/// Writes the text between "<mesh>" and "</mesh>": the runs' new triangles in place of their old ones, then the inlay's
/// triangles if it is a volume of the mesh.
/// @param changes   of this mesh, ascending by the run's first triangle
/// @param withInlay  appends the inlay
std::string changedMesh(const MeshText& mesh, const ThreeMfSource& source, std::span<const ChangedRun* const> changes,
                        const PaintAttributes& paint, bool withInlay);

/// Writes a mesh alone, with its element.
std::string wholeMesh(const Mesh& mesh, const ThreeMfRun& run, double unitMm, const std::string& prefix);

}  // namespace qrelief
