// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/construction.h"

#include <array>
#include <cmath>
#include <numbers>

#include "projection/size.h"

namespace qrelief {
namespace {

constexpr ConstructionColours kColours;
constexpr float kPlaneLine = 0.45f, kPlaneGround = 0.10f;  // opacities
constexpr double kPlaneFade = 0.35;                        // width of the plane's margin, in edges of the square
constexpr int kCircleSides = 96;                           // every other one is drawn
constexpr int kDashes = 9;                                 // of the line from C to S, with as many gaps but one
constexpr double kThinPx = 1.5, kLinePx = 2, kStrongPx = 3, kDotPx = 9, kHeadPx = 11;
constexpr double kHeadShare = 0.12;      // length of an arrow's head, in lengths of the arrow
constexpr double kSameDirection = 1e-9;  // squared distance of equal unit vectors

/// Collects the strokes of a drawing.
class Pen {
 public:
  Pen(const ProjectionFrame& frame, double pixelRatio) : frame_(frame), pixelRatio_(pixelRatio) {}

  void line(Vec3 from, Vec3 to, Vec3f colour, double px) { taper(from, to, colour, px, px); }
  void line(Vec2 from, Vec2 to, Vec3f colour, double px) { line(frame_.onPlane(from), frame_.onPlane(to), colour, px); }
  void dot(Vec3 at, Vec3f colour) { line(at, at, colour, kDotPx); }
  void arrow(Vec3 from, Vec3 to, Vec3f colour, double px) {
    const Vec3 neck = glm::mix(to, from, kHeadShare);
    line(from, neck, colour, px);
    taper(neck, to, colour, kHeadPx, 0);
  }
  std::vector<Stroke> strokes;

 private:
  void taper(Vec3 from, Vec3 to, Vec3f colour, double px, double endPx) {
    strokes.push_back({from, to, colour, px * pixelRatio_, endPx * pixelRatio_});
  }
  const ProjectionFrame& frame_;
  double pixelRatio_;
};

std::array<Vec2, 4> cornersOf(double edge) {
  const double half = edge / 2;
  return {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)};
}

/// Draws the circle about C that touches the silhouette at S, and the way from C to S.
void drawClosest(Pen& pen, const ProjectionFrame& frame, Vec2 closest) {
  const double radius = glm::length(closest);
  const auto onCircle = [&](int side) {
    const double angle = 2 * std::numbers::pi * side / kCircleSides;
    return radius * Vec2(std::cos(angle), std::sin(angle));
  };
  for (int side = 0; side < kCircleSides; side += 2)
    pen.line(onCircle(side), onCircle(side + 1), kColours.silhouette, kThinPx);
  for (int dash = 0; dash < kDashes; ++dash) {
    const auto at = [&](int end) { return closest * (end / (2.0 * kDashes - 1)); };
    pen.line(at(2 * dash), at(2 * dash + 1), kColours.silhouette, kThinPx);
  }
  pen.dot(frame.onPlane(closest), kColours.silhouette);
}

}  // namespace

Construction constructionOf(const Placement& placement, double roomFactor) {
  Construction construction{placement.frame,
                            placement.patch.silhouette,
                            nearestSilhouettePoint(placement.patch.silhouette),
                            placement.largestMm,
                            placement.largestMm * roomFactor,
                            {},
                            {}};
  for (const DirectionIteration& iteration : placement.iterations) {
    const Vec3 apart = iteration.normal - placement.frame.normal;
    if (!construction.chosen && glm::dot(apart, apart) < kSameDirection)
      construction.chosen = construction.directions.size();
    construction.directions.push_back({iteration.normal, iteration.varianceMm2});
  }
  return construction;
}

LineDrawing drawingOf(const Construction& construction, double pixelRatio) {
  const ProjectionFrame& frame = construction.frame;
  const double half = construction.squareMm / 2;
  Pen pen(frame, pixelRatio);
  const std::array<Vec2, 4> corners = cornersOf(construction.squareMm);
  for (const Vec2 corner : corners) pen.line(frame.eye(), frame.onPlane(corner), kColours.projection, kThinPx);
  pen.dot(frame.eye(), kColours.projection);
  for (const Segment2& segment : construction.silhouette)
    pen.line(segment[0], segment[1], kColours.silhouette, kLinePx);
  for (std::size_t i = 0; i < 4; ++i) pen.line(corners[i], corners[(i + 1) % 4], kColours.square, kStrongPx);
  if (construction.closest) drawClosest(pen, frame, *construction.closest);
  for (std::size_t i = 0; i < construction.directions.size(); ++i) {
    const bool isChosen = i == construction.chosen;
    pen.arrow(frame.centre, construction.tip(construction.directions[i]), kColours.directions,
              isChosen ? kStrongPx : kThinPx);
  }
  pen.dot(frame.centre, kColours.plane);
  return {std::move(pen.strokes), GridPlane{frame.centre,
                                            frame.right,
                                            frame.up,
                                            {half, half},
                                            kPlaneFade * construction.squareMm,
                                            {kColours.plane, kPlaneLine},
                                            {kColours.plane, kPlaneGround}}};
}

}  // namespace qrelief
