// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "mesh/mesh.h"
#include "mesh/polygon_soup.h"

/// Closed, outward-facing solids with shared vertices and measures in closed form. Millimetres.
namespace qrelief::shapes {

/// Returns a box centred at the origin: 8 vertices, 12 triangles.
Mesh box(Vec3 size);

/// Returns a regular tetrahedron: 4 vertices, centroid at the origin; volume edge³/(6·√2).
Mesh tetrahedron(double edge);

/// Returns a sphere of 20·4^level triangles with all vertices on the sphere about the origin.
Mesh icosphere(double radius, int level);

/// Returns an icosphere whose radius varies smoothly within radius ± amplitude, about `waves` waves along each axis.
Mesh bumpySphere(double radius, double amplitude, int waves, int level);

/// Returns a torus about Z, centred at the origin: 2·aroundAxis·aroundTube triangles.
Mesh torus(double axisRadius, double tubeRadius, int aroundAxis, int aroundTube);

/// Returns a cylinder about Z, from -height/2 to height/2, with full-height side strips and caps fanned about their
/// centres: 4·segments triangles.
Mesh cylinder(double radius, double height, int segments);

/// Returns a block, centred in x and y. Its upper face is a grid of n × m squares, two triangles each, at z =
/// height(x, y), or at 0 without `height`. The bottom is two triangles at z = -thickness.
Mesh plate(Vec2 size, double thickness, int n, int m, const std::function<double(double, double)>& height = {});

Mesh translated(Mesh mesh, Vec3 offset);

/// Returns the same surface with every triangle flipped.
Mesh insideOut(Mesh mesh);

/// Returns both in one mesh, `a` first; nothing is welded.
Mesh together(const Mesh& a, const Mesh& b);

/// Returns icosphere(10, 3) with one vertex pulled through a neighbouring facet, 1 µm beyond their common edge, so
/// that 5 pairs of triangles cross.
Mesh tangledSphere();

/// Returns true if every edge belongs to two triangles.
bool isClosed(const Mesh& mesh);

/// Returns the soup that a reader would return.
PolygonSoup soupOf(const Mesh& mesh);

}  // namespace qrelief::shapes
