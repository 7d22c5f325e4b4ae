// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_stl.h"

#include <algorithm>
#include <cstring>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>
#include <string>

#include "io/write_model.h"

namespace qrelief {
namespace {

constexpr std::size_t kTitleBytes = 80;

void append(std::vector<std::uint8_t>& bytes, const void* value, std::size_t size) {
  const auto* raw = static_cast<const std::uint8_t*>(value);
  bytes.insert(bytes.end(), raw, raw + size);
}

}  // namespace

std::vector<std::uint8_t> writeStl(const Mesh& mesh, std::string_view title) {
  // Some parsers take any file that begins with "solid" for text.
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

std::vector<std::uint8_t> writeAsciiStl(const Mesh& mesh, std::string_view title) {
  const std::string name = oneLine(title);
  std::vector<std::uint8_t> bytes;
  const auto out = std::back_inserter(bytes);
  fmt::format_to(out, FMT_COMPILE("solid {}\n"), name);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3f normal(triangleNormal(mesh, t));
    fmt::format_to(out, FMT_COMPILE("facet normal {} {} {}\nouter loop\n"), normal.x, normal.y, normal.z);
    for (const std::uint32_t v : mesh.triangles[t]) {
      const Vec3f& p = mesh.positions[v];
      fmt::format_to(out, FMT_COMPILE("vertex {} {} {}\n"), p.x, p.y, p.z);
    }
    fmt::format_to(out, FMT_COMPILE("endloop\nendfacet\n"));
  }
  fmt::format_to(out, FMT_COMPILE("endsolid {}\n"), name);
  return bytes;
}

}  // namespace qrelief
