// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_ply.h"

#include <cstring>
#include <fmt/format.h>

#include "io/write_model.h"

namespace qrelief {
namespace {

constexpr std::size_t kFaceBytes = 1 + sizeof(Triangle);

}  // namespace

std::vector<std::uint8_t> writePly(std::span<const ModelObject> objects, const WriteOptions& options) {
  std::size_t vertices = 0, triangles = 0;
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies) {
      vertices += body.mesh.positions.size();
      triangles += body.mesh.triangles.size();
    }
  const std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}; millimetres\nelement vertex {}\nproperty float x\n"
      "property float y\nproperty float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      oneLine(options.title), vertices, triangles);
  std::vector<std::uint8_t> bytes(header.size() + sizeof(Vec3f) * vertices + kFaceBytes * triangles);
  std::uint8_t* vertex = std::copy(header.begin(), header.end(), bytes.data());
  std::uint8_t* face = vertex + sizeof(Vec3f) * vertices;
  std::uint32_t first = 0;
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies) {
      for (const Vec3f& p : body.mesh.positions) {
        std::memcpy(vertex, &p, sizeof(p));
        vertex += sizeof(p);
      }
      for (const auto& [a, b, c] : body.mesh.triangles) {
        const Triangle corners = {first + a, first + b, first + c};
        *face = 3;
        std::memcpy(face + 1, corners.data(), sizeof(corners));
        face += kFaceBytes;
      }
      first += static_cast<std::uint32_t>(body.mesh.positions.size());
    }
  return bytes;
}

}  // namespace qrelief
