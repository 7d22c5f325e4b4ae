// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu_mesh.h"

namespace qrelief {

GpuMesh::GpuMesh(const Mesh& mesh, std::span<const Vec3f> normals)
    : array_(gl::VertexArray::create()), box_(boundingBox(mesh)) {
  std::vector<Vec3f> relative(mesh.positions.size());
  for (std::size_t v = 0; v < relative.size(); ++v) relative[v] = Vec3f(Vec3(mesh.positions[v]) - origin());
  array_.bind();
  positions_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(relative)));
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  normals_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(normals));
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  ClusteredTriangles clustered = clusterTriangles(mesh);
  clusters_ = std::move(clustered.clusters);
  indices_ = gl::Buffer(GL_ELEMENT_ARRAY_BUFFER, std::as_bytes(std::span(clustered.triangles)));
  glBindVertexArray(0);
}

void GpuMesh::setValues(std::span<const float> values) {
  array_.bind();
  values_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(values));
  glEnableVertexAttribArray(2);
  glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
}

void GpuMesh::setColours(std::span<const Colour> colours) {
  array_.bind();
  colours_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(colours));
  glEnableVertexAttribArray(3);
  glVertexAttribPointer(3, 3, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
  glBindVertexArray(0);
}

void GpuMesh::drawRange(std::uint32_t begin, std::uint32_t end) const {
  if (begin == end) return;
  const std::size_t offset = begin * sizeof(Triangle);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * (end - begin)), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr): GL wants it so
}

void GpuMesh::draw() const {
  array_.bind();
  if (!clusters_.empty()) drawRange(0, clusters_.back().end);
  glBindVertexArray(0);
}

void GpuMesh::draw(const ViewPyramid& pyramid) const {
  array_.bind();
  std::uint32_t begin = 0, end = 0;  // of the present run of visible clusters
  for (const TriangleCluster& cluster : clusters_) {
    if (!pyramid.mayMeet(cluster.box)) continue;
    if (cluster.begin != end) {
      drawRange(begin, end);
      begin = cluster.begin;
    }
    end = cluster.end;
  }
  drawRange(begin, end);
  glBindVertexArray(0);
}

}  // namespace qrelief
