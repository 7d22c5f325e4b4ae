// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "mesh/mesh.h"
#include "mesh/polygon_soup.h"

/// Closed, outward-facing solids with shared vertices, whose measures are known in closed form. Millimetres.
namespace qrelief::shapes {

/// 8 vertices, 12 triangles, centred at the origin.
Mesh box(Vec3 size);

/// Regular, 4 vertices, centroid at the origin; volume edge³/(6·√2).
Mesh tetrahedron(double edge);

/// 20·4^level triangles with all vertices on the sphere about the origin.
Mesh icosphere(double radius, int level);

/// Icosphere whose radius varies smoothly between radius ± amplitude, about `waves` waves along each axis.
Mesh bumpySphere(double radius, double amplitude, int waves, int level);

/// Axis Z, centred at the origin; 2·aroundAxis·aroundTube triangles.
Mesh torus(double axisRadius, double tubeRadius, int aroundAxis, int aroundTube);

/// Axis Z, from -height/2 to height/2: full-height side strips and caps fanned about their centres; 4·segments
/// triangles.
Mesh cylinder(double radius, double height, int segments);

/// A block, centred in x and y, whose upper face is a grid of n × m squares, two triangles each, at z = height(x, y)
/// (0 if not given); the bottom is two triangles at z = -thickness.
Mesh plate(Vec2 size, double thickness, int n, int m, const std::function<double(double, double)>& height = {});

Mesh translated(Mesh mesh, Vec3 offset);

/// The same surface with every triangle turned round.
Mesh insideOut(Mesh mesh);

/// Both in one mesh, `a` first; nothing is welded.
Mesh together(const Mesh& a, const Mesh& b);

/// Icosphere(10, 3) with one vertex pulled through a neighbouring facet, 0.1 mm beyond their common edge, so that 5
/// pairs of triangles cross.
Mesh tangledSphere();

/// As a reader would hand it over.
PolygonSoup soupOf(const Mesh& mesh);

}  // namespace qrelief::shapes
