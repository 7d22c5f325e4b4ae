// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/constrained_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <algorithm>
#include <utility>

#include "message_codes/place.h"

namespace qrelief {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

/// A triangle of the triangulation, rotated so that its lowest index comes first.
struct Face {
  Triangle corners;
  int first;  // CGAL's index of the first corner
  Triangulation::Face_handle handle;
};

/// Converts the triangulation to arrays. It is unique (CGAL breaks ties of cocircular points by symbolic perturbation),
/// but CGAL's order depends on the standard library; sorting makes the result the same everywhere.
PlaneTriangulation toArrays(Triangulation& cdt) {
  std::vector<Face> faces;
  faces.reserve(cdt.number_of_faces());
  for (auto face = cdt.all_faces_begin(); face != cdt.all_faces_end(); ++face) {
    face->info() = kNoNeighbour;
    if (cdt.is_infinite(face)) continue;
    const std::uint32_t a = face->vertex(0)->info(), b = face->vertex(1)->info(), c = face->vertex(2)->info();
    const int first = a < b && a < c ? 0 : b < c ? 1 : 2;
    faces.push_back({first == 0 ? Triangle{a, b, c} : first == 1 ? Triangle{b, c, a} : Triangle{c, a, b}, first, face});
  }
  std::sort(faces.begin(), faces.end(), [](const Face& x, const Face& y) { return x.corners < y.corners; });
  for (std::uint32_t k = 0; k < faces.size(); ++k) faces[k].handle->info() = k;
  PlaneTriangulation result;
  result.triangles.reserve(faces.size());
  result.neighbours.reserve(faces.size());
  for (const Face& face : faces) {
    result.triangles.push_back(face.corners);
    const auto across = [&](int k) { return face.handle->neighbor((face.first + k + 2) % 3)->info(); };
    result.neighbours.push_back({across(0), across(1), across(2)});
  }
  return result;
}

}  // namespace

Result<PlaneTriangulation> triangulateConstrained(std::span<const Vec2> points,
                                                  std::span<const std::array<std::uint32_t, 2>> constraints) {
  try {
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> sites;
    sites.reserve(points.size());
    for (std::uint32_t k = 0; k < points.size(); ++k) sites.emplace_back(Kernel::Point_2(points[k].x, points[k].y), k);
    Triangulation cdt;
    cdt.insert(sites.begin(), sites.end());
    if (cdt.number_of_vertices() != points.size())
      return fail(ErrorKind::Internal, message<"arrangement-points-coincide">(
                                           with::count<"count">(points.size() - cdt.number_of_vertices())));
    std::vector<Triangulation::Vertex_handle> vertices(points.size());
    for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v) vertices[v->info()] = v;
    for (const auto& [a, b] : constraints) cdt.insert_constraint(vertices[a], vertices[b]);
    return toArrays(cdt);
  } catch (const std::exception& e) {  // Intersection_of_constraints_exception, or a failed check inside CGAL
    return fail(ErrorKind::Internal, message<"arrangement-not-triangulated">(with::term<"reason">(e.what())));
  }
}

}  // namespace qrelief
