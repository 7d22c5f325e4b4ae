// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polygon_list.h"

#include <cmath>
#include <fmt/format.h>

#include "io/triangulate_polygon.h"

namespace qrelief {
namespace {

Status checkPositions(const std::vector<Vec3>& positions, const std::string& format) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3& p = positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return fail(ErrorKind::BadInput,
                  fmt::format("Vertex {} of {} of the {} file is at ({}, {}, {}), which is not finite", i + 1,
                              positions.size(), format, p.x, p.y, p.z),
                  "Export the model again; something went wrong when it was made");
  }
  return {};
}

Status checkPolygons(const PolygonList& list, const std::string& format) {
  std::size_t corner = 0;
  for (std::size_t f = 0; f < list.sizes.size(); ++f) {
    for (std::uint32_t k = 0; k < list.sizes[f]; ++k, ++corner)
      if (list.corners[corner] >= list.positions.size())
        return fail(ErrorKind::BadInput,
                    fmt::format("Face {} of {} of the {} file asks for vertex {} (counted from 0), but there are {}",
                                f + 1, list.sizes.size(), format, list.corners[corner], list.positions.size()),
                    "The file is damaged; export the model again");
  }
  if (list.triangles == 0)
    return fail(ErrorKind::BadInput,
                fmt::format("The {} file holds {} vertices, but no face", format, list.positions.size()),
                "Export the model as a surface mesh, with faces");
  return {};
}

void triangulateFace(const PolygonList& list, std::span<const std::uint32_t> face, PolygonSoup& soup,
                     std::size_t& notSimple) {
  std::vector<Vec3> corners;
  for (const std::uint32_t v : face) corners.push_back(list.positions[v]);
  const PolygonTriangles cut = triangulatePolygon(corners);
  for (const auto& [a, b, c] : cut.triangles) soup.triangles.push_back({face[a], face[b], face[c]});
  if (!cut.simple) ++notSimple;
}

}  // namespace

tl::unexpected<Error> tooManyTriangles(std::size_t limit) {
  return fail(ErrorKind::BadInput, fmt::format("The model has more than the {} triangles that are accepted", limit),
              "Reduce (decimate) the model first");
}

Status PolygonList::reserve(std::uint64_t vertices, std::uint64_t faces) {
  if (faces > maxTriangles || vertices > 3 * std::uint64_t{maxTriangles}) return tooManyTriangles(maxTriangles);
  positions.reserve(static_cast<std::size_t>(vertices));
  sizes.reserve(static_cast<std::size_t>(faces));
  corners.reserve(static_cast<std::size_t>(3 * faces));
  return {};
}

Status PolygonList::add(std::span<const std::uint32_t> polygon) {
  if (polygon.size() > 2) triangles += polygon.size() - 2;
  if (triangles > maxTriangles) return tooManyTriangles(maxTriangles);
  corners.insert(corners.end(), polygon.begin(), polygon.end());
  sizes.push_back(static_cast<std::uint32_t>(polygon.size()));
  return {};
}

Result<PolygonSoup> triangulated(PolygonList&& list, std::string format) {
  if (Status s = checkPositions(list.positions, format); !s) return tl::unexpected(s.error());
  if (Status s = checkPolygons(list, format); !s) return tl::unexpected(s.error());

  PolygonSoup soup;
  std::size_t tooSmall = 0;
  std::size_t notSimple = 0;
  soup.triangles.reserve(list.triangles);
  const std::uint32_t* face = list.corners.data();
  for (const std::uint32_t size : list.sizes) {
    if (size == 3)
      soup.triangles.push_back({face[0], face[1], face[2]});
    else if (size < 3)
      ++tooSmall;
    else
      triangulateFace(list, {face, size}, soup, notSimple);
    face += size;
  }
  if (tooSmall > 0)
    soup.warnings.push_back(fmt::format("{} faces with fewer than three corners were passed over", tooSmall));
  if (notSimple > 0)
    soup.warnings.push_back(fmt::format(
        "{} polygons cross themselves or have no area; they were cut into triangles all the same", notSimple));
  soup.positions = std::move(list.positions);
  soup.format = std::move(format);
  return soup;
}

std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, kLongest)) text += c >= ' ' && c < 127 ? c : '?';
  return text + (word.size() > kLongest ? "...'" : "'");
}

std::string notANumber(std::string_view word) {
  return word.empty() ? std::string("a number is missing") : fmt::format("{} is not a number", quoted(word));
}

}  // namespace qrelief
