// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/printed_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "printing/cross_sections.h"
#include "printing/extruded_outline.h"

namespace qrelief {
namespace {

using Corners = PrintedLayers::Corners;
using Polygon = PrintedLayers::Polygon;

constexpr double kNodesPerFinest = 6;
constexpr double kNearestStepMm = 0.008;  // shortest step of a ray that grazes plastic
constexpr double kHitMm = 5e-4;
constexpr double kNearEnoughMm = 1e-3;
constexpr int kRefinements = 6;
constexpr int kFewTiles = 4;       // around a small triangle: all of them are computed without a closer test
constexpr double kMaxNodes = 4e7;  // memory limit, however large the code and fine the process
/// Edge of a tile: in multiples of the finest detail, and in halos. Limit on the tiles along the edge of the visible
/// square.
constexpr double kTileFinest = 10, kTileHalos = 4, kMaxTiles = 64;

/// Returns the part of a convex polygon on the side that a plane's normal points to [Sutherland, Hodgman 1974].
Polygon clipped(const Polygon& polygon, Vec3 origin, Vec3 normal) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double overA = glm::dot(a - origin, normal), overB = glm::dot(b - origin, normal);
    if (overA >= 0) result.add(a);
    if ((overA >= 0) != (overB >= 0)) result.add(a + (b - a) * (overA / (overA - overB)));
  }
  return result;
}

/// Returns, for each position, the sides of the visible square's pyramid that it lies beyond, a bit for each [outcodes,
/// Cohen, Sutherland].
std::vector<std::uint8_t> sidesBeyond(std::span<const Vec3> positions, const ProjectionFrame& frame, double extentMm) {
  const Vec3 inwards = frame.normal * -(extentMm / 2), across = frame.right * frame.eyeDistance,
             along = frame.up * frame.eyeDistance, eye = frame.eye();
  const std::array<Vec3, 4> sides{inwards - across, inwards + across, inwards - along, inwards + along};
  std::vector<std::uint8_t> codes;
  codes.reserve(positions.size());
  for (const Vec3& p : positions) {
    unsigned code = 0;
    for (unsigned k = 0; k < 4; ++k) code |= static_cast<unsigned>(glm::dot(p - eye, sides[k]) < 0) << k;
    codes.push_back(static_cast<std::uint8_t>(code));
  }
  return codes;
}

/// Returns true if the eye is on the triangle's front side.
bool faces(const Corners& triangle, Vec3 eye) {
  return glm::dot(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]), eye - triangle[0]) > 0;
}

/// Returns true if the eye sees the triangle through the square, unless other triangles hide it.
bool isWithin(const Corners& triangle, const ProjectionFrame& frame, double extentMm) {
  return std::all_of(triangle.begin(), triangle.end(), [&](Vec3 corner) {
    const double depth = frame.distanceAlongAxis(corner), edge = extentMm / 2 * depth / frame.eyeDistance;
    const Vec3 from = corner - frame.eye();
    return depth > 0 && std::abs(glm::dot(from, frame.right)) <= edge && std::abs(glm::dot(from, frame.up)) <= edge;
  });
}

/// Returns the part of a triangle that the eye sees through the square, unless other triangles hide it.
Polygon partWithin(const Corners& triangle, const ProjectionFrame& frame, double extentMm) {
  Polygon part(triangle);
  for (const Vec3 side : {frame.right, -frame.right, frame.up, -frame.up}) {
    // The plane through the eye and the square's edge on that side.
    part = clipped(part, frame.eye(), frame.normal * -(extentMm / 2) - side * frame.eyeDistance);
    if (part.empty()) return part;
  }
  return part;
}

struct Rectangle {
  Vec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  void add(Vec3 p) {
    low = glm::min(low, Vec2(p.x, p.y));
    high = glm::max(high, Vec2(p.x, p.y));
  }
};

/// Returns a grid without the nodes near its border.
LayerGrid cropped(const LayerGrid& grid, int border) {
  LayerGrid inner{grid.node(border, border), grid.stepMm, grid.columns - 2 * border, grid.rows - 2 * border, {}};
  inner.distanceMm.reserve(static_cast<std::size_t>(inner.columns) * static_cast<std::size_t>(inner.rows));
  for (int row = 0; row < inner.rows; ++row) {
    const auto from = grid.distanceMm.begin() + static_cast<std::ptrdiff_t>(grid.index(border, row + border));
    inner.distanceMm.insert(inner.distanceMm.end(), from, from + inner.columns);
  }
  return inner;
}

}  // namespace

PrintedLayers::PrintedLayers(const Solid& solid, const ProjectionFrame& frame, double extentMm,
                             const PrintProcess& process, double roughness)
    : process_(process), frame_(frame) {
  bedMm_ = std::numeric_limits<double>::infinity();
  for (const Triangle& t : solid.triangles)
    for (const std::uint32_t v : t) bedMm_ = std::min(bedMm_, solid.positions[v].z);
  findTiles(solid, extentMm);
  cut(solid, roughness);
}

/// A ray from the eye, with the greatest steps that distances from plastic allow.
struct PrintedLayers::Ray {
  Vec3 eye, direction;
  Vec2 perDirection;     ///< mm along the ray for 1 mm along an axis
  double perAcross = 0;  ///< mm along the ray for 1 mm of distance from an outline in a layer's plane
  double perFall = 0;    ///< mm along the ray for 1 mm of distance from a flank
  /// From this distance from an outline on, mm, the outline allows the larger step, and the flank does not matter.
  double freeMm = 0;

  Ray(Vec3 from, Vec3 along, double grooveMm) : eye(from), direction(along) {
    constexpr double kLeast = 1e-9;
    for (int axis = 0; axis < 2; ++axis) perDirection[axis] = 1 / std::max(std::abs(along[axis]), kLeast);
    const double across = std::sqrt(along.x * along.x + along.y * along.y);
    perAcross = 1 / std::max(across, kLeast);
    perFall = 1 / (across + std::abs(along.z));
    freeMm = perAcross > perFall ? grooveMm * perFall / (perAcross - perFall) : std::numeric_limits<double>::infinity();
  }

  Vec2 at(double t) const { return Vec2(eye) + Vec2(direction) * t; }
};

int PrintedLayers::layerAt(double z) const {
  return std::clamp(static_cast<int>(std::floor((z - bedMm_) / process_.layerMm)) - firstLayer_, 0,
                    static_cast<int>(layers_.size()) - 1);
}

/// Finds the tiles of each layer to compute.
void PrintedLayers::findTiles(const Solid& solid, double extentMm) {
  std::vector<std::uint32_t> whole;  // triangles within the square
  std::vector<Polygon> parts;        // of triangles that leave it
  Rectangle all;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  nearestMm_ = least;
  farthestMm_ = 0;
  const double h = process_.layerMm, margin = 2 * process_.cornerRadiusMm + h;
  const auto add = [&](const auto& corners) {
    for (const Vec3& corner : corners) {
      least = std::min(least, corner.z);
      most = std::max(most, corner.z);
      all.add(corner);
      nearestMm_ = std::min(nearestMm_, frame_.distanceAlongAxis(corner));  // a corner need not be the nearest point
      farthestMm_ = std::max(farthestMm_, glm::distance(corner, frame_.eye()));
    }
  };
  const std::vector<std::uint8_t> beyond = sidesBeyond(solid.positions, frame_, extentMm);
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    const auto& [a, b, c] = solid.triangles[t];
    if ((beyond[a] & beyond[b] & beyond[c]) != 0) continue;
    const Corners corners = solid.corners(t);
    if (!faces(corners, frame_.eye())) continue;
    if (isWithin(corners, frame_, extentMm)) {
      whole.push_back(static_cast<std::uint32_t>(t));
      add(corners);
    } else if (const Polygon part = partWithin(corners, frame_, extentMm); !part.empty()) {
      parts.push_back(part);
      add(part);
    }
  }
  if (whole.empty() && parts.empty()) return;
  nearestMm_ -= 2 * margin;
  farthestMm_ += 2 * margin;
  firstLayer_ = std::max(0, static_cast<int>(std::floor((least - bedMm_) / h)) - 2);
  const int lastLayer = static_cast<int>(std::floor((most - bedMm_) / h)) + 2;
  layers_.resize(static_cast<std::size_t>(lastLayer - firstLayer_ + 1));

  const Vec2 extent = all.high - all.low + 2 * margin;
  tileMm_ =
      std::max({kTileFinest * process_.finestMm, kTileHalos * haloMm(), glm::max(extent.x, extent.y) / kMaxTiles});
  // Off every grid that a model may have been drawn on, so that no vertex lies straight above a tile's corner.
  origin_ = all.low - margin - tileMm_ * Vec2(0.00381966011, 0.00414213562);
  tileColumns_ = static_cast<int>(std::floor((extent.x + margin) / tileMm_)) + 1;
  tileRows_ = static_cast<int>(std::floor((extent.y + margin) / tileMm_)) + 1;
  for (const std::uint32_t t : whole) addToLayers(Polygon(solid.corners(t)), margin);
  for (const Polygon& part : parts) addToLayers(part, margin);
}

/// Adds tiles to all layers that a part shapes: layers up to one and a half layers away from it.
void PrintedLayers::addToLayers(const Polygon& part, double marginMm) {
  const double h = process_.layerMm;
  double least = part.front().z, most = part.front().z;
  for (const Vec3& corner : part) {
    least = std::min(least, corner.z);
    most = std::max(most, corner.z);
  }
  const int begin = std::max(0, static_cast<int>(std::floor((least - bedMm_) / h - 1.5)) - firstLayer_);
  const int end = std::min(static_cast<int>(layers_.size()),
                           static_cast<int>(std::floor((most - bedMm_) / h + 1.5)) - firstLayer_ + 1);
  const TileRange all = tilesRound(part, marginMm);
  for (int layer = begin; layer < end; ++layer) {
    Layer& of = layers_[layer];
    if (all.count() <= kFewTiles) {
      addRange(of, all);
      continue;
    }
    Polygon within = clipped(part, Vec3(0, 0, topOf(layer) - 2.5 * h), Vec3(0, 0, 1));
    if (!within.empty()) within = clipped(within, Vec3(0, 0, topOf(layer) + 1.5 * h), Vec3(0, 0, -1));
    if (!within.empty()) addTiles(of, within, marginMm);
  }
}

PrintedLayers::TileRange PrintedLayers::tilesRound(const Polygon& polygon, double marginMm) const {
  Rectangle bounds;
  for (const Vec3& corner : polygon) bounds.add(corner);
  const auto tileAt = [&](double coordinate, int axis, int count) {
    return std::clamp(static_cast<int>(std::floor((coordinate - origin_[axis]) / tileMm_)), 0, count - 1);
  };
  return {tileAt(bounds.low.x - marginMm, 0, tileColumns_), tileAt(bounds.high.x + marginMm, 0, tileColumns_),
          tileAt(bounds.low.y - marginMm, 1, tileRows_), tileAt(bounds.high.y + marginMm, 1, tileRows_)};
}

void PrintedLayers::addRange(Layer& layer, const TileRange& range) const {
  if (layer.numbers.empty())
    layer.numbers.assign(static_cast<std::size_t>(tileColumns_) * static_cast<std::size_t>(tileRows_), kNoTile);
  for (int row = range.firstRow; row <= range.lastRow; ++row)
    for (int column = range.firstColumn; column <= range.lastColumn; ++column) {
      int& number = layer.numbers[row * tileColumns_ + column];
      if (number != kNoTile) continue;
      number = layer.count++;
    }
}

void PrintedLayers::addTiles(Layer& layer, const Polygon& within, double marginMm) const {
  const TileRange all = tilesRound(within, marginMm);
  for (int row = all.firstRow; row <= all.lastRow; ++row) {
    TileRange strip = all;
    if (all.lastRow > all.firstRow) {
      const double low = origin_.y + row * tileMm_ - marginMm;
      Polygon part = clipped(within, Vec3(0, low, 0), Vec3(0, 1, 0));
      if (!part.empty()) part = clipped(part, Vec3(0, low + tileMm_ + 2 * marginMm, 0), Vec3(0, -1, 0));
      if (part.empty()) continue;
      strip = tilesRound(part, marginMm);
    }
    strip.firstRow = strip.lastRow = row;
    addRange(layer, strip);
  }
}

/// Returns the margin of outline considered beyond a tile, so that the tile does not depend on where it ends.
double PrintedLayers::haloMm() const { return 2 * process_.cornerRadiusMm + kExtrudedReachMm; }

void PrintedLayers::cut(const Solid& solid, double roughness) {
  int tiles = 0;
  for (const Layer& layer : layers_) tiles += layer.count;
  if (tiles == 0) return;
  const double finest =
      std::max(roughness * process_.finestMm / kNodesPerFinest, std::sqrt(tiles * tileMm_ * tileMm_ / kMaxNodes));
  steps_ = std::max(1, static_cast<int>(std::floor(tileMm_ / finest)));
  stepMm_ = tileMm_ / steps_;
  stepsPerMm_ = 1 / stepMm_;
  haloSteps_ = static_cast<int>(std::ceil(haloMm() / stepMm_));
  const CuttingPlanes planes{bedMm_ + (firstLayer_ + 0.5) * process_.layerMm, process_.layerMm,
                             static_cast<int>(layers_.size())};
  const Vec2 corner = origin_ - (haloMm() + 2 * tileMm_) * Vec2(1.00381966011, 1.00414213562);
  const Vec2 opposite = origin_ + tileMm_ * Vec2(tileColumns_, tileRows_) + haloMm();
  const CrossSections sections = cutByPlanes(solid.positions, solid.triangles, planes, corner, opposite);
  parallelFor(layers_.size(), [&](std::size_t k) {
    Layer& layer = layers_[k];
    if (layer.count == 0) return;
    layer.tiles = std::make_unique<Tile[]>(static_cast<std::size_t>(layer.count));
    layer.outlines = nearTiles(layer, sections.outlines[k]);
    layer.windings = windingNumbers(sections.outlines[k], {firstWindow(), tileMm_, tileColumns_, tileRows_}, corner,
                                    sections.windings[k]);
  });
}

/// Returns the lower left corner of the first tile's window, slightly beyond its halo.
Vec2 PrintedLayers::firstWindow() const {
  return origin_ - stepMm_ * Vec2(haloSteps_ + 0.38196601125, haloSteps_ + 0.41421356237);
}

/// Finds the segments that touch each tile's window.
std::vector<std::vector<Segment2>> PrintedLayers::nearTiles(const Layer& layer,
                                                            std::span<const Segment2> outline) const {
  const double beyond = stepMm_ * (2 * haloSteps_ + 1);  // by how much a window is wider than a tile
  std::vector<std::vector<Segment2>> near(static_cast<std::size_t>(layer.count));
  for (const Segment2& segment : outline) {
    const Vec2 low = (glm::min(segment[0], segment[1]) - firstWindow() - tileMm_ - beyond) / tileMm_;
    const Vec2 high = (glm::max(segment[0], segment[1]) - firstWindow()) / tileMm_;
    const int lastRow = static_cast<int>(std::min(std::floor(high.y), tileRows_ - 1.0));
    const int lastColumn = static_cast<int>(std::min(std::floor(high.x), tileColumns_ - 1.0));
    for (int row = static_cast<int>(std::max(0.0, std::ceil(low.y))); row <= lastRow; ++row)
      for (int column = static_cast<int>(std::max(0.0, std::ceil(low.x))); column <= lastColumn; ++column)
        if (const int number = layer.numbers[row * tileColumns_ + column]; number != kNoTile)
          near[number].push_back(segment);
  }
  return near;
}

LayerGrid PrintedLayers::layTile(const Layer& layer, int tile) const {
  const Vec2 place(tile % tileColumns_, tile / tileColumns_);
  const int nodes = steps_ + 1 + 2 * haloSteps_;
  const LayerWindow window{origin_ + tileMm_ * place - stepMm_ * haloSteps_, stepMm_, nodes, nodes};
  return cropped(layOutline(layer.outlines[layer.numbers[tile]], window, firstWindow() + tileMm_ * place,
                            layer.windings[tile], process_),
                 haloSteps_);
}

/// A ray over a tile: gives the plastic's distance along the ray, layer by layer.
class PrintedLayers::RayInTile {
 public:
  static constexpr int kOutside = -1;

  int tile = kOutside;  ///< row-major among the tiles of a layer
  double leaves = 0;    ///< distance along the ray to the tile's border, mm, at least kNearestStepMm beyond the point

  /// @param low      the tile's lower left corner
  /// @param perStep  steps of its grid in a mm
  void start(const Ray& ray, Vec2 low, double perStep, const PrintProcess& process) {
    u_ = (ray.eye.x - low.x) * perStep;
    v_ = (ray.eye.y - low.y) * perStep;
    uPerMm_ = ray.direction.x * perStep;
    vPerMm_ = ray.direction.y * perStep;
    wPerMm_ = ray.direction.z * (2 / process.layerMm);
    grooveMm_ = process.grooveMm;
  }
  void enter(const LayerGrid& grid, double eyeOverMiddleMm, const PrintProcess& process) {
    grid_ = &grid;
    w_ = eyeOverMiddleMm * (2 / process.layerMm);
  }

  /// Returns the distance from the outline, in the layer's plane. @param t  along the ray, mm, within the tile
  double distanceInPlane(double t) const {
    const double u = u_ + uPerMm_ * t, v = v_ + vPerMm_ * t;
    const int column = std::clamp(static_cast<int>(u), 0, grid_->columns - 2);
    const int row = std::clamp(static_cast<int>(v), 0, grid_->rows - 2);
    const auto right = static_cast<float>(u - column), up = static_cast<float>(v - row);
    const float* const corner = &grid_->distanceMm[grid_->index(column, row)];
    const float* const above = corner + grid_->columns;
    const float low = corner[0] + right * (corner[1] - corner[0]), high = above[0] + right * (above[1] - above[0]);
    return static_cast<double>(low + up * (high - low));
  }

  /// Returns how far the round flank lies behind the outline.
  double groove(double t) const {
    const double w = w_ + wPerMm_ * t;
    return grooveMm_ * (1 - std::sqrt(std::max(0.0, 1 - w * w)));
  }

  double distance(double t) const { return distanceInPlane(t) + groove(t); }

 private:
  const LayerGrid* grid_ = nullptr;
  double grooveMm_ = 0;
  double u_ = 0, v_ = 0, w_ = 0, uPerMm_ = 0, vPerMm_ = 0, wPerMm_ = 0;  // in steps, and in half layers
};

double PrintedLayers::firstHit(Vec2 at, double fromMm) const {
  if (layers_.empty()) return 0;
  const Ray ray(frame_.eye(), frame_.rayDirection(at), process_.grooveMm);
  const double top = topOf(static_cast<int>(layers_.size()) - 1), bottom = topOf(-1);
  const double eyeZ = ray.eye.z, climb = ray.direction.z, perClimb = 1 / climb;
  double begin = std::max(nearestMm_, fromMm), end = farthestMm_;
  if (climb != 0) {
    const double a = (top - eyeZ) * perClimb, b = (bottom - eyeZ) * perClimb;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  } else if (eyeZ >= top || eyeZ < bottom) {
    return 0;
  }
  int layer = layerAt(eyeZ + climb * (begin + 1e-9));
  RayInTile inTile = tileAt(ray, begin);
  while (begin < end && layer >= 0 && layer < static_cast<int>(layers_.size())) {
    double leaves = end;
    if (climb != 0) leaves = std::min(end, (topOf(climb > 0 ? layer : layer - 1) - eyeZ) * perClimb);
    if (const double met = hitInLayer(layer, ray, inTile, begin, leaves); met > 0) return met;
    begin = std::max(begin, leaves);
    if (climb == 0) break;
    layer += climb > 0 ? 1 : -1;
  }
  return 0;
}

/// Returns the ray over the tile that contains its point at `t`.
PrintedLayers::RayInTile PrintedLayers::tileAt(const Ray& ray, double t) const {
  const Vec2 place = (ray.at(t) - origin_) / tileMm_, before = glm::floor(place);
  double way = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    const double rest = ray.direction[axis] > 0 ? before[axis] + 1 - place[axis] : place[axis] - before[axis];
    way = std::min(way, rest * tileMm_ * ray.perDirection[axis]);
  }
  RayInTile inTile;
  inTile.leaves = t + std::max(way, kNearestStepMm);
  if (!(place.x >= 0 && place.y >= 0 && place.x < tileColumns_ && place.y < tileRows_)) return inTile;
  inTile.tile = static_cast<int>(place.y) * tileColumns_ + static_cast<int>(place.x);
  inTile.start(ray, origin_ + tileMm_ * before, stepsPerMm_, process_);
  return inTile;
}

/// Returns null where nothing is visible.
const LayerGrid* PrintedLayers::gridOf(int layer, const RayInTile& inTile) const {
  const Layer& of = layers_[layer];
  if (of.count == 0 || inTile.tile == RayInTile::kOutside) return nullptr;
  const int number = of.numbers[inTile.tile];
  if (number == kNoTile) return nullptr;
  Tile& tile = of.tiles[number];
  if (!tile.isLaid)
    std::call_once(tile.once, [&] {
      tile.grid = layTile(of, inTile.tile);
      tile.isLaid = true;
    });
  return &tile.grid;
}

double PrintedLayers::hitInLayer(int layer, const Ray& ray, RayInTile& inTile, double begin, double end) const {
  if (layers_[layer].count == 0 || begin >= end) return 0;
  // The ray cannot hit plastic before it passes the outline. Between outline and flank, perFall bounds how fast the
  // distance falls along the ray; flanks are steeper only where the ray almost hits them.
  const double eyeOverMiddleMm = ray.eye.z - (topOf(layer) - process_.layerMm / 2);
  double before = begin;
  for (double t = begin;;) {
    if (t >= inTile.leaves) inTile = tileAt(ray, t);
    if (const LayerGrid* grid = gridOf(layer, inTile)) {
      inTile.enter(*grid, eyeOverMiddleMm, process_);
      for (;;) {
        const double inPlane = inTile.distanceInPlane(t);
        double step = inPlane * ray.perAcross;
        if (inPlane < ray.freeMm) {
          const double distance = inPlane + inTile.groove(t);
          if (distance < kHitMm) return t == begin ? t : refined(layer, ray, before, t);
          step = std::max(step, distance * ray.perFall);
        }
        if (t >= end) return 0;
        before = t;
        t = std::min(end, t + std::max(step, kNearestStepMm));
        if (t >= inTile.leaves) break;
      }
    } else {
      if (t >= end) return 0;
      before = t;
      t = std::min(end, inTile.leaves);
    }
  }
}

/// Returns where the distance falls to kHitMm between two points of a ray [regula falsi, Illinois variant].
double PrintedLayers::refined(int layer, const Ray& ray, double outside, double inside) const {
  const double eyeOverMiddleMm = ray.eye.z - (topOf(layer) - process_.layerMm / 2);
  const auto over = [&](double t) -> double {  // outside the tiles, any value above 0
    RayInTile inTile = tileAt(ray, t);
    const LayerGrid* const grid = gridOf(layer, inTile);
    if (!grid) return kNearestStepMm;
    inTile.enter(*grid, eyeOverMiddleMm, process_);
    return inTile.distance(t) - kHitMm;
  };
  double overOutside = over(outside), overInside = over(inside);
  for (int k = 0; k < kRefinements && inside - outside > kNearEnoughMm; ++k) {
    const double t = outside + (inside - outside) * (overOutside / (overOutside - overInside));
    const double value = over(t);
    (value < 0 ? inside : outside) = t;
    (value < 0 ? overInside : overOutside) = value;
    (value < 0 ? overOutside : overInside) /= 2;  // so that both ends move
  }
  return inside;
}

}  // namespace qrelief
