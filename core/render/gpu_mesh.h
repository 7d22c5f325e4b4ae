// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "base/colour.h"
#include "gl/objects.h"
#include "mesh/mesh.h"
#include "mesh/triangle_clusters.h"

namespace qrelief {

/// A mesh in GPU memory: positions relative to the middle of its box (so that far-away models keep their digits) and
/// smooth normals; attributes 0 and 1. Attribute 2 is a number per vertex, 0 unless set, and attribute 3 its colour.
class GpuMesh {
 public:
  GpuMesh() = default;
  /// @param normals  unit, one per vertex
  GpuMesh(const Mesh& mesh, std::span<const Vec3f> normals);

  /// @param values  one per vertex
  void setValues(std::span<const float> values);
  /// @param colours  one per vertex; black unless set
  void setColours(std::span<const Colour> colours);

  void draw() const;
  /// Draws all but the clusters that certainly lie outside the pyramid (model coordinates).
  void draw(const ViewPyramid& pyramid) const;
  Vec3 origin() const { return box_.centre(); }
  const Box3& box() const { return box_; }

 private:
  void drawRange(std::uint32_t begin, std::uint32_t end) const;

  gl::VertexArray array_;
  gl::Buffer positions_, normals_, values_, colours_, indices_;
  std::vector<TriangleCluster> clusters_;
  Box3 box_;
};

}  // namespace qrelief
