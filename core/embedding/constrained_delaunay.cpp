// SPDX-License-Identifier: GPL-3.0-or-later
#include "embedding/constrained_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>
#include <utility>

namespace qrelief {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

PlaneTriangulation toArrays(Triangulation& cdt) {
  PlaneTriangulation result;
  std::uint32_t count = 0;
  for (auto face = cdt.all_faces_begin(); face != cdt.all_faces_end(); ++face)
    face->info() = cdt.is_infinite(face) ? kNoNeighbour : count++;
  result.triangles.reserve(count);
  result.neighbours.reserve(count);
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    result.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    result.neighbours.push_back({face->neighbor(2)->info(), face->neighbor(0)->info(), face->neighbor(1)->info()});
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
      return fail(ErrorCode::Internal,
                  fmt::format("{} points of the arrangement coincide", points.size() - cdt.number_of_vertices()));
    std::vector<Triangulation::Vertex_handle> vertices(points.size());
    for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v) vertices[v->info()] = v;
    for (const auto& [a, b] : constraints) cdt.insert_constraint(vertices[a], vertices[b]);
    return toArrays(cdt);
  } catch (const std::exception& e) {  // Intersection_of_constraints_exception, or a failed check inside CGAL
    return fail(ErrorCode::Internal, fmt::format("the arrangement cannot be triangulated: {}", e.what()));
  }
}

}  // namespace qrelief
