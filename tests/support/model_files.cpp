// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/model_files.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

namespace qrelief::model_files {
namespace {

template <class T>
void append(Bytes& bytes, T value, bool bigEndian) {
  std::array<std::uint8_t, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if (bigEndian) std::reverse(raw.begin(), raw.end());
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

/// Writes the shortest decimals that read back as the same floats.
std::string decimals(Vec3f p) { return fmt::format("{} {} {}", p.x, p.y, p.z); }

}  // namespace

Bytes bytesOf(std::string_view text) { return Bytes(text.begin(), text.end()); }

std::string asciiStl(const Mesh& mesh, std::string_view lineEnd) {
  std::string text = fmt::format("solid shape{}", lineEnd);
  for (const Triangle& t : mesh.triangles) {
    text += fmt::format("  facet normal 0 0 0{0}    outer loop{0}", lineEnd);
    for (const std::uint32_t v : t) text += fmt::format("      vertex {}{}", decimals(mesh.positions[v]), lineEnd);
    text += fmt::format("    endloop{0}  endfacet{0}", lineEnd);
  }
  return text + fmt::format("endsolid shape{}", lineEnd);
}

std::string obj(const Mesh& mesh) {
  std::string text;
  for (const Vec3f& p : mesh.positions) text += fmt::format("v {}\n", decimals(p));
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
  return text;
}

std::string off(const Mesh& mesh) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.triangles.size());
  for (const Vec3f& p : mesh.positions) text += decimals(p) + "\n";
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("3 {} {} {}\n", a, b, c);
  return text;
}

Bytes ply(const Mesh& mesh, PlyKind kind) {
  const std::string_view format = kind == PlyKind::Ascii          ? "ascii"
                                  : kind == PlyKind::LittleEndian ? "binary_little_endian"
                                                                  : "binary_big_endian";
  std::string text = fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format, mesh.positions.size(), mesh.triangles.size());
  if (kind == PlyKind::Ascii) {
    for (const Vec3f& p : mesh.positions) text += decimals(p) + "\n";
    for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("3 {} {} {}\n", a, b, c);
    return bytesOf(text);
  }
  const bool bigEndian = kind == PlyKind::BigEndian;
  Bytes bytes = bytesOf(text);
  for (const Vec3f& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) append(bytes, p[axis], bigEndian);
  for (const Triangle& t : mesh.triangles) {
    bytes.push_back(3);
    for (const std::uint32_t v : t) append(bytes, v, bigEndian);
  }
  return bytes;
}

}  // namespace qrelief::model_files
