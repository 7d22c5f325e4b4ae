// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu_mesh.h"

namespace qrelief {

GpuMesh::GpuMesh(const Mesh& mesh, std::span<const Vec3f> normals)
    : array_(gl::VertexArray::create()),
      indexCount_(static_cast<GLsizei>(3 * mesh.triangles.size())),
      box_(boundingBox(mesh)) {
  std::vector<Vec3f> relative(mesh.positions.size());
  for (std::size_t v = 0; v < relative.size(); ++v) relative[v] = Vec3f(Vec3(mesh.positions[v]) - origin());
  array_.bind();
  positions_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(relative)));
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  normals_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(normals));
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  indices_ = gl::Buffer(GL_ELEMENT_ARRAY_BUFFER, std::as_bytes(std::span(mesh.triangles)));
  glBindVertexArray(0);
}

void GpuMesh::setValues(std::span<const float> values) {
  array_.bind();
  values_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(values));
  glEnableVertexAttribArray(2);
  glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
}

void GpuMesh::draw() const {
  array_.bind();
  glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
}

}  // namespace qrelief
