// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "mesh/topology.h"

namespace qrelief::shapes {
namespace {

constexpr double kPi = std::numbers::pi;

std::uint32_t addVertex(Mesh& mesh, Vec3 position) {
  mesh.positions.emplace_back(position);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// Adds the quad a b c d, counter-clockwise seen from outside.
void addQuad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// Unit icosphere in double precision, so that rounding happens once, after the radius is applied.
struct UnitSphere {
  std::vector<Vec3> directions;
  std::vector<Triangle> triangles;
};

UnitSphere icosahedron() {
  const double g = std::numbers::phi;
  UnitSphere s;
  for (const Vec3 p : {Vec3(-1, g, 0), Vec3(1, g, 0), Vec3(-1, -g, 0), Vec3(1, -g, 0), Vec3(0, -1, g), Vec3(0, 1, g),
                       Vec3(0, -1, -g), Vec3(0, 1, -g), Vec3(g, 0, -1), Vec3(g, 0, 1), Vec3(-g, 0, -1), Vec3(-g, 0, 1)})
    s.directions.push_back(glm::normalize(p));
  s.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return s;
}

UnitSphere subdivided(const UnitSphere& coarse) {
  UnitSphere fine{coarse.directions, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [it, isNew] =
        middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(fine.directions.size()));
    if (isNew) fine.directions.push_back(glm::normalize(coarse.directions[a] + coarse.directions[b]));
    return it->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  return fine;
}

Mesh radialSphere(int level, const std::function<double(Vec3)>& radius) {
  UnitSphere sphere = icosahedron();
  for (int i = 0; i < level; ++i) sphere = subdivided(sphere);
  Mesh mesh;
  for (const Vec3& d : sphere.directions) addVertex(mesh, d * radius(d));
  mesh.triangles = std::move(sphere.triangles);
  return mesh;
}

}  // namespace

Mesh box(Vec3 size) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) addVertex(mesh, size * (Vec3(i & 1, i >> 1 & 1, i >> 2 & 1) - 0.5));
  addQuad(mesh, 0, 2, 3, 1);
  addQuad(mesh, 4, 5, 7, 6);
  addQuad(mesh, 0, 1, 5, 4);
  addQuad(mesh, 2, 6, 7, 3);
  addQuad(mesh, 0, 4, 6, 2);
  addQuad(mesh, 1, 3, 7, 5);
  return mesh;
}

Mesh tetrahedron(double edge) {
  const double k = edge / std::sqrt(8.0);
  Mesh mesh;
  for (const Vec3 p : {Vec3(1, 1, 1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1)}) addVertex(mesh, p * k);
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

Mesh icosphere(double radius, int level) {
  return radialSphere(level, [=](Vec3) { return radius; });
}

Mesh bumpySphere(double radius, double amplitude, int waves, int level) {
  return radialSphere(level, [=](Vec3 d) {
    return radius + amplitude * std::cos(kPi * waves * d.x) * std::cos(kPi * waves * d.y) * std::cos(kPi * waves * d.z);
  });
}

Mesh torus(double axisRadius, double tubeRadius, int aroundAxis, int aroundTube) {
  Mesh mesh;
  for (int i = 0; i < aroundAxis; ++i)
    for (int j = 0; j < aroundTube; ++j) {
      const double u = 2 * kPi * i / aroundAxis;
      const double v = 2 * kPi * j / aroundTube;
      const double r = axisRadius + tubeRadius * std::cos(v);
      addVertex(mesh, {r * std::cos(u), r * std::sin(u), tubeRadius * std::sin(v)});
    }
  const auto at = [=](int i, int j) {
    return static_cast<std::uint32_t>(i % aroundAxis * aroundTube + j % aroundTube);
  };
  for (int i = 0; i < aroundAxis; ++i)
    for (int j = 0; j < aroundTube; ++j) addQuad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return mesh;
}

Mesh cylinder(double radius, double height, int segments) {
  Mesh mesh;
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * kPi * i / segments;
    for (const double z : {-height / 2, height / 2})
      addVertex(mesh, {radius * std::cos(angle), radius * std::sin(angle), z});
  }
  const std::uint32_t bottom = addVertex(mesh, {0, 0, -height / 2});
  const std::uint32_t top = addVertex(mesh, {0, 0, height / 2});
  for (int i = 0; i < segments; ++i) {
    const auto a = static_cast<std::uint32_t>(2 * i);
    const auto b = static_cast<std::uint32_t>(2 * ((i + 1) % segments));
    addQuad(mesh, a, b, b + 1, a + 1);
    mesh.triangles.push_back({bottom, b, a});
    mesh.triangles.push_back({top, a + 1, b + 1});
  }
  return mesh;
}

Mesh plate(Vec2 size, double thickness, int n, int m, const std::function<double(double, double)>& height) {
  Mesh mesh;
  const auto at = [=](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = size.x * (static_cast<double>(i) / n - 0.5);
      const double y = size.y * (static_cast<double>(j) / m - 0.5);
      addVertex(mesh, {x, y, height ? height(x, y) : 0.0});
    }
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) addQuad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));

  // Rim of the upper face, counter-clockwise from above, one side at a time: front, right, back, left.
  std::array<std::vector<std::uint32_t>, 4> sides;
  for (int i = 0; i <= n; ++i) sides[0].push_back(at(i, 0));
  for (int j = 0; j <= m; ++j) sides[1].push_back(at(n, j));
  for (int i = n; i >= 0; --i) sides[2].push_back(at(i, m));
  for (int j = m; j >= 0; --j) sides[3].push_back(at(0, j));
  std::array<std::uint32_t, 4> bottom{};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3f corner = mesh.positions[sides[k].front()];
    bottom[k] = addVertex(mesh, {corner.x, corner.y, -thickness});
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint32_t next = bottom[(k + 1) % 4];
    for (std::size_t i = 0; i + 1 < sides[k].size(); ++i)
      mesh.triangles.push_back({bottom[k], sides[k][i + 1], sides[k][i]});
    mesh.triangles.push_back({bottom[k], next, sides[k].back()});
  }
  addQuad(mesh, bottom[0], bottom[3], bottom[2], bottom[1]);
  return mesh;
}

Mesh translated(Mesh mesh, Vec3 offset) {
  for (Vec3f& p : mesh.positions) p = Vec3f(Vec3(p) + offset);
  return mesh;
}

Mesh insideOut(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

Mesh together(const Mesh& a, const Mesh& b) {
  Mesh mesh = a;
  const auto offset = static_cast<std::uint32_t>(a.positions.size());
  mesh.positions.insert(mesh.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& [i, j, k] : b.triangles) mesh.triangles.push_back({i + offset, j + offset, k + offset});
  return mesh;
}

Mesh tangledSphere() {
  constexpr std::uint32_t vertex = 100;
  Mesh mesh = icosphere(10, 3);
  const auto t = std::find_if(mesh.triangles.begin(), mesh.triangles.end(),
                              [](const Triangle& triangle) { return triangle[0] == vertex; });
  const Vec3f middle = (mesh.positions[(*t)[1]] + mesh.positions[(*t)[2]]) * 0.5f;
  Vec3f& pulled = mesh.positions[vertex];
  pulled = middle + (middle - pulled) * 0.001f;
  return mesh;
}

bool isClosed(const Mesh& mesh) {
  const EdgeTable edges = buildEdgeTable(mesh.triangles);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.at(e).size() != 2) return false;
  return true;
}

PolygonSoup soupOf(const Mesh& mesh) {
  PolygonSoup soup;
  for (const Vec3f& p : mesh.positions) soup.positions.emplace_back(p);
  soup.triangles = mesh.triangles;
  return soup;
}

}  // namespace qrelief::shapes
