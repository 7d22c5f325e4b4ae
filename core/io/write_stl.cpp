// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_stl.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace qrelief {
namespace {

constexpr std::size_t kTitleBytes = 80;

void append(std::vector<std::uint8_t>& bytes, const void* value, std::size_t size) {
  const auto* raw = static_cast<const std::uint8_t*>(value);
  bytes.insert(bytes.end(), raw, raw + size);
}

}  // namespace

std::vector<std::uint8_t> writeStl(const Mesh& mesh, std::string_view title) {
  // Readers that trust the word take a file that begins with "solid" for text.
  std::string header = title.starts_with("solid") ? "binary " + std::string(title) : std::string(title);
  header.resize(kTitleBytes, ' ');
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kTitleBytes + 4 + 50 * mesh.triangles.size());
  append(bytes, header.data(), kTitleBytes);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  append(bytes, &count, sizeof(count));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3f normal(triangleNormal(mesh, t));
    append(bytes, &normal, sizeof(normal));
    for (const std::uint32_t v : mesh.triangles[t]) append(bytes, &mesh.positions[v], sizeof(Vec3f));
    const std::uint16_t attributes = 0;
    append(bytes, &attributes, sizeof(attributes));
  }
  return bytes;
}

}  // namespace qrelief
