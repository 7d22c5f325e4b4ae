// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/occlusion.h"

#include <algorithm>
#include <cmath>

#include "math/orientation.h"
#include "math/tolerance.h"

namespace qrelief {
namespace {

using Corners = std::array<Vec3, 3>;

Corners cornersOf(const Mesh& mesh, std::uint32_t triangle) {
  return {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
}

/// Returns +1 if the eye sees `p` to the left of the line from corner k to the next, 0 on the line. A point is inside
/// the facet's image if the result is +1 for all three sides.
int insideOfSide(const Corners& corners, std::size_t k, Vec3 p, Vec3 eye) {
  return sideOfPlane(corners[k], corners[(k + 1) % 3], p, eye);
}

/// Returns true if the boxes around two images are apart despite rounding.
bool certainlySeparate(const Triangle2& triangle, const Segment2& segment, double noise) {
  const Vec2 low = glm::min(glm::min(triangle[0], triangle[1]), triangle[2]) - noise;
  const Vec2 high = glm::max(glm::max(triangle[0], triangle[1]), triangle[2]) + noise;
  const Vec2 from = glm::min(segment[0], segment[1]);
  const Vec2 to = glm::max(segment[0], segment[1]);
  return from.x > high.x || to.x < low.x || from.y > high.y || to.y < low.y;
}

/// Returns the part of a segment in a counter-clockwise triangle, or outside it by at most `noise`.
std::optional<Segment2> clipped(const Segment2& segment, const Triangle2& triangle, double noise) {
  double enter = 0;
  double leave = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 side = triangle[(k + 1) % 3] - triangle[k];
    const double slack = noise * glm::length(side);
    const double from = cross2(side, segment[0] - triangle[k]) + slack;
    const double to = cross2(side, segment[1] - triangle[k]) + slack;
    if (from < 0 && to < 0) return {};
    if (from < 0) enter = std::max(enter, from / (from - to));
    if (to < 0) leave = std::min(leave, from / (from - to));
  }
  if (enter > leave) return {};
  const Vec2 along = segment[1] - segment[0];
  return Segment2{segment[0] + along * enter, segment[0] + along * leave};
}

/// Returns the point of the segment nearest to the triangle's middle, for a overlap found by exact tests but too small
/// for `clipped`.
Segment2 touchingPoint(const Segment2& segment, const Triangle2& triangle) {
  const Vec2 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  const Vec2 along = segment[1] - segment[0];
  const double squared = glm::dot(along, along);
  const double fraction = squared > 0 ? std::clamp(glm::dot(middle - segment[0], along) / squared, 0.0, 1.0) : 0;
  const Vec2 point = segment[0] + along * fraction;
  return {point, point};
}

enum class Overlap { None, Touches, Crosses };

/// Classifies the overlap of a facet's image and the image of an edge that starts at corner `shared` of the facet; the
/// corner itself does not count.
Overlap overlapFromCorner(const Corners& corners, std::size_t shared, Vec3 otherEnd, Vec3 eye) {
  const int left = insideOfSide(corners, shared, otherEnd, eye);
  const int right = insideOfSide(corners, (shared + 2) % 3, otherEnd, eye);
  if (left < 0 || right < 0) return Overlap::None;
  return left > 0 && right > 0 ? Overlap::Crosses : Overlap::Touches;
}

/// Classifies the overlap of the images of an edge and a facet that share no corner: it looks for a side that separates
/// them.
Overlap overlapElsewhere(const Corners& corners, const std::array<Vec3, 2>& ends, Vec3 eye) {
  bool crosses = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const int inner = std::max(insideOfSide(corners, k, ends[0], eye), insideOfSide(corners, k, ends[1], eye));
    if (inner < 0) return Overlap::None;
    crosses = crosses && inner > 0;
  }
  int least = 1;
  int most = -1;
  for (const Vec3 corner : corners) {
    const int side = sideOfPlane(ends[0], ends[1], corner, eye);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  if (least > 0 || most < 0) return Overlap::None;
  return crosses && least < 0 && most > 0 ? Overlap::Crosses : Overlap::Touches;
}

/// Returns the part of the edge's image in front of the facet's plane.
/// @param inFront  on which side of the plane the edge's ends lie
Segment2 partInFront(const Corners& corners, const ContourEdge& edge, const std::array<int, 2>& inFront,
                     const ProjectionFrame& frame) {
  Segment2 part = edge.projected;
  if (inFront[0] * inFront[1] >= 0) return part;
  const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double from = glm::dot(normal, edge.ends[0] - corners[0]);
  const double to = glm::dot(normal, edge.ends[1] - corners[0]);
  const double fraction = from == to ? 0.5 : std::clamp(from / (from - to), 0.0, 1.0);
  part[inFront[0] < 0 ? 0 : 1] = frame.project(edge.ends[0] + (edge.ends[1] - edge.ends[0]) * fraction);
  return part;
}

}  // namespace

std::optional<Occluder> occluderOf(const Mesh& mesh, std::uint32_t triangle, const ContourEdge& edge, Vec3 eye,
                                   const ProjectionFrame& frame, const EyeView& view) {
  const Triangle& vertices = mesh.triangles[triangle];
  const Triangle2 image = view.triangle(vertices);
  if (certainlySeparate(image, edge.projected, view.noiseMm)) return {};

  const Corners corners = cornersOf(mesh, triangle);
  std::array<int, 2> shared{-1, -1};  // the facet's corner at which the edge begins, ends
  std::array<int, 2> inFront{0, 0};
  for (std::size_t end = 0; end < 2; ++end) {
    for (int k = 0; k < 3; ++k)
      if (vertices[k] == edge.vertices[end]) shared[end] = k;
    if (shared[end] < 0) inFront[end] = sideOfPlane(corners[0], corners[1], corners[2], edge.ends[end]);
  }
  if (inFront[0] <= 0 && inFront[1] <= 0) return {};  // an edge of the facet, or no part of it is nearer

  Overlap overlap;
  if (shared[0] >= 0)
    overlap = overlapFromCorner(corners, static_cast<std::size_t>(shared[0]), edge.ends[1], eye);
  else if (shared[1] >= 0)
    overlap = overlapFromCorner(corners, static_cast<std::size_t>(shared[1]), edge.ends[0], eye);
  else
    overlap = overlapElsewhere(corners, edge.ends, eye);
  if (overlap == Overlap::None) return {};

  const Segment2 part = partInFront(corners, edge, inFront, frame);
  const std::optional<Segment2> segment = clipped(part, image, view.noiseMm);
  const bool throughPlane = inFront[0] * inFront[1] < 0;
  if (!segment && throughPlane) return {};  // it passes behind the facet
  return Occluder{segment ? *segment : touchingPoint(part, image), overlap == Overlap::Crosses};
}

bool imagesOverlap(const Mesh& mesh, std::uint32_t first, std::uint32_t second, Vec3 eye) {
  const std::array<Corners, 2> both{cornersOf(mesh, first), cornersOf(mesh, second)};
  for (std::size_t which = 0; which < 2; ++which) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Corners& other = both[1 - which];
      const bool parts =
          std::all_of(other.begin(), other.end(), [&](Vec3 p) { return insideOfSide(both[which], k, p, eye) <= 0; });
      if (parts) return false;
    }
  }
  return true;
}

std::optional<CentreObstruction> whatHidesCentre(const Mesh& mesh, const ProjectionFrame& frame, const EyeView& view,
                                                 std::span<const std::uint32_t> facets) {
  const Vec3 eye = frame.eye();
  std::optional<CentreObstruction> nearest;
  for (const std::uint32_t t : facets) {
    const Triangle& vertices = mesh.triangles[t];
    if (view.inFront[vertices[0]] && view.inFront[vertices[1]] && view.inFront[vertices[2]] &&
        certainlySeparate(view.triangle(vertices), {Vec2(0), Vec2(0)}, view.noiseMm))
      continue;
    const Corners corners = cornersOf(mesh, t);
    int least = 1;
    int most = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const int side = insideOfSide(corners, k, frame.centre, eye);
      least = std::min(least, side);
      most = std::max(most, side);
    }
    if (least * most < 0 || (least == 0 && most == 0)) continue;  // off the ray's line, or edge-on

    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double fraction = glm::dot(normal, corners[0] - eye) / glm::dot(normal, frame.centre - eye);
    const double fromEye = fraction * frame.eyeDistance;
    const double toCentre = frame.eyeDistance - fromEye;
    if (!(fromEye > 0 && toCentre > kOnSurfaceMm)) continue;
    if (!nearest) nearest = CentreObstruction{t, fromEye, toCentre};
    if (fromEye < nearest->fromEyeMm) {
      nearest->triangle = t;
      nearest->fromEyeMm = fromEye;
    }
    nearest->clearDistanceMm = std::min(nearest->clearDistanceMm, toCentre);
  }
  return nearest;
}

}  // namespace qrelief
