// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <map>

#include "messages/sentences.h"

namespace qrelief::fuzz {
namespace {

bool finite(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

bool printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x20; });
}

template <class Index>
void checkTriangles(const std::vector<Triangle>& triangles, Index positions) {
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) require(v < positions, "every index has its position");
}

/// Requires a closed mesh: every edge lies in two triangles that run along it in opposite directions. Models without a
/// blocking finding are closed.
void checkClosed(const Mesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, std::array<int, 2>> uses;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      ++uses[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1];
    }
  for (const auto& [edge, ways] : uses) require(ways == std::array{1, 1}, "an engravable model is closed and oriented");
}

}  // namespace

void require(bool holds, std::string_view promise) {
  if (holds) return;
  fmt::print(stderr, "broken promise: {}\n", promise);
  std::abort();
}

void checkError(const Error& error) {
  require(error.kind == ErrorKind::BadInput || error.kind == ErrorKind::NoSolution, "refusals are typed");
  require(!sentence(error.message).empty() && sentence(error.message).back() != '.',
          "a refusal has a message without full stop");
  require(printable(sentence(error.message)) && printable(hint(error.message)), "messages hold no control characters");
}

void checkSoup(const Result<PolygonSoup>& soup) {
  if (!soup) {
    require(soup.error().kind == ErrorKind::BadInput, "what cannot be read is bad input");
    return checkError(soup.error());
  }
  require(!soup->triangles.empty() && soup->triangles.size() <= kLimits.maxTriangles, "1 to maxTriangles triangles");
  require(!soup->format.empty(), "the format has a name");
  require(std::all_of(soup->positions.begin(), soup->positions.end(), finite), "positions are finite");
  checkTriangles(soup->triangles, soup->positions.size());
  for (const Message& warning : soup->warnings)
    require(printable(sentence(warning)), "warnings hold no control characters");
  std::size_t next = 0;
  for (const ModelPart& part : soup->parts) {
    require(part.firstTriangle >= next && part.firstTriangle <= soup->triangles.size(), "parts ascend");
    next = part.firstTriangle;
  }
}

void checkPrepared(const Result<PreparedModel>& prepared) {
  if (!prepared) {
    require(prepared.error().kind == ErrorKind::BadInput, "what cannot be represented is bad input");
    return checkError(prepared.error());
  }
  const Mesh& mesh = prepared->mesh;
  require(!mesh.triangles.empty(), "a model has triangles");
  require(prepared->adjacency.size() == mesh.triangles.size(), "one adjacency a triangle");
  require(prepared->normals.size() == mesh.positions.size(), "one normal a vertex");
  checkTriangles(mesh.triangles, mesh.positions.size());
  for (const Triangle& t : mesh.triangles)
    require(t[0] != t[1] && t[1] != t[2] && t[2] != t[0], "a triangle has three corners");
  std::vector<std::array<float, 3>> places;
  for (const Vec3f& p : mesh.positions) {
    require(finite(Vec3(p)), "positions are finite");
    places.push_back({p.x + 0.0f, p.y + 0.0f, p.z + 0.0f});
  }
  std::sort(places.begin(), places.end());
  require(std::adjacent_find(places.begin(), places.end()) == places.end(), "no two positions are equal");
  for (const Finding& finding : prepared->findings)
    require(printable(sentence(finding.message)) && printable(hint(finding.message)), "findings are in words");
  if (prepared->engravable()) checkClosed(mesh);
}

}  // namespace qrelief::fuzz
