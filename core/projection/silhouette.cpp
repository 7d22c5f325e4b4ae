// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/silhouette.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <span>
#include <unordered_map>
#include <utility>

#include "math/round_down.h"
#include "math/tolerance.h"
#include "message_codes/place.h"
#include "projection/plane_grid.h"

namespace qrelief {
namespace {

/// Number of contour edges, each counted in every cell, that a search looks at before it enters no more facets that may
/// have occluders. Slivers that cross thousands of contour edges each would take their square.
constexpr std::size_t kMinLooks = 1'000'000, kLooksPerTriangle = 50;

/// Returns the size of the growing region when it reaches a point.
double reachOfPoint(Vec2 p, GrowingRegion region) {
  return region == GrowingRegion::Disc ? glm::length(p) : std::max(std::abs(p.x), std::abs(p.y));
}

/// Returns the fraction of a side, from a to b, at which the growing region meets it first.
double nearestFraction(Vec2 a, Vec2 b, GrowingRegion region) {
  const Vec2 along = b - a;
  if (region == GrowingRegion::Disc) {
    const double squared = glm::dot(along, along);
    return squared > 0 ? std::clamp(glm::dot(-a, along) / squared, 0.0, 1.0) : 0.5;
  }
  // The reach is convex and linear between the diagonals of the square.
  double best = reachOfPoint(a, region) <= reachOfPoint(b, region) ? 0 : 1;
  for (const double turn : {1.0, -1.0}) {
    const double slope = along.x - turn * along.y;
    const double fraction = slope != 0 ? (turn * a.y - a.x) / slope : -1;
    if (fraction > 0 && fraction < 1 &&
        reachOfPoint(a + along * fraction, region) < reachOfPoint(a + along * best, region))
      best = fraction;
  }
  return best;
}

/// Returns the point of an edge nearest to the centre, kept away from the edge's ends: paths go through edges, not
/// vertices.
Vec2 nearestInnerPoint(Vec2 a, Vec2 b, GrowingRegion region) {
  return a + (b - a) * std::clamp(nearestFraction(a, b, region), 0.001, 0.999);
}

/// Returns the least reach of a triangle's points.
double reachOfTriangle(const Triangle2& triangle, GrowingRegion region) {
  double reach = distanceToTriangle(Vec2(0), triangle);
  if (region == GrowingRegion::Disc || reach == 0) return reach;
  reach = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 a = triangle[k], b = triangle[(k + 1) % 3];
    reach = std::min(reach, reachOfPoint(a + (b - a) * nearestFraction(a, b, region), region));
  }
  return reach;
}

bool isWithin(const Triangle2& image, double radius) {
  const Vec2 low = glm::min(glm::min(image[0], image[1]), image[2]);
  const Vec2 high = glm::max(glm::max(image[0], image[1]), image[2]);
  if (low.x > radius || low.y > radius || high.x < -radius || high.y < -radius) return false;
  const double squared = radius * radius;
  for (const Vec2 p : image)
    if (glm::dot(p, p) <= squared) return true;
  return distanceToTriangle(Vec2(0), image) <= radius;
}

/// Returns the facets of the clusters that may face the eye and show within a square about the centre.
std::vector<std::uint32_t> facetsInView(const ClusteredTriangles& clusters, const ProjectionFrame& frame,
                                        double halfWidth) {
  const ViewPyramid pyramid(frame, 2 * halfWidth);
  const Vec3 eye = frame.eye();
  std::vector<std::uint32_t> facets;
  for (const TriangleCluster& cluster : clusters.clusters)
    if (pyramid.mayMeet(cluster.box) && !cluster.facesAwayFrom(eye))
      facets.insert(facets.end(), clusters.origins.begin() + cluster.begin, clusters.origins.begin() + cluster.end);
  return facets;
}

/// Returns half the edge of a square about the centre that contains the images of those facets that come within the
/// radius.
double reachOfFacets(const Mesh& mesh, std::span<const std::uint32_t> facets, const ProjectionFrame& frame,
                     double radius) {
  const double nearDepth = kNearPlaneFraction * frame.eyeDistance;
  double reach = radius;
  for (const std::uint32_t t : facets) {
    const std::array<Vec3, 3> corners{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    if (std::any_of(corners.begin(), corners.end(), [&](Vec3 p) { return frame.distanceAlongAxis(p) <= nearDepth; }))
      continue;  // is out of the eye's reach
    const Triangle2 image{frame.project(corners[0]), frame.project(corners[1]), frame.project(corners[2])};
    if (!isWithin(image, radius)) continue;
    for (const Vec2 p : image) reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
  }
  return reach;
}

/// Returns the facets, ascending, whose images may meet the image of a facet within the radius, or hide the centre. All
/// facets if these are more than a third: to choose them then takes longer than to look at the rest.
std::vector<std::uint32_t> facetsAbout(const Mesh& mesh, const ClusteredTriangles* clusters,
                                       const ProjectionFrame& frame, double radius) {
  const std::size_t many = mesh.triangles.size() / 3;
  if (clusters && std::isfinite(radius)) {
    std::vector<std::uint32_t> facets = facetsInView(*clusters, frame, radius);
    if (facets.size() <= many) facets = facetsInView(*clusters, frame, reachOfFacets(mesh, facets, frame, radius));
    if (facets.size() <= many) {
      std::sort(facets.begin(), facets.end());
      return facets;
    }
  }
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/// Returns facets and all their neighbours, ascending.
std::vector<std::uint32_t> withNeighbours(const std::vector<std::uint32_t>& facets, const Adjacency& adjacency) {
  if (facets.size() == adjacency.size()) return facets;
  std::vector<std::uint8_t> counts(adjacency.size(), 0);
  for (const std::uint32_t t : facets) {
    counts[t] = 1;
    for (const std::uint32_t across : adjacency[t])
      if (across != kNoTriangle) counts[across] = 1;
  }
  std::vector<std::uint32_t> all;
  for (std::uint32_t t = 0; t < counts.size(); ++t)
    if (counts[t]) all.push_back(t);
  return all;
}

/// A facet that occluders pass over.
struct ObstructedFacet {
  std::uint32_t triangle = 0;
  bool crossed = false;  // otherwise they only touch it
  double reach = 0;      // reach at which it was entered
  std::vector<Segment2> occluders;
};

enum class State : std::uint8_t {
  Excluded,  // does not face the eye, or lies outside the radius
  Clear,     // not reached yet; certainly without occluders
  Unseen,    // not reached yet
  Waiting,   // has occluders; reached, perhaps several times, but not entered
  Taken,
  Dropped  // its image overlaps the image of a facet met earlier
};

std::vector<Triangle2> imagesOf(std::span<const ContourEdge> edges) {
  std::vector<Triangle2> images;
  images.reserve(edges.size());
  for (const ContourEdge& edge : edges) images.push_back({edge.projected[0], edge.projected[1], edge.projected[1]});
  return images;
}

}  // namespace

/// Facets and contour edges about the centre, and their images. Regions and seeds share them.
struct SilhouetteSurroundings {
  const Mesh& mesh;
  const Adjacency& adjacency;
  ProjectionFrame frame;
  double radius;
  std::vector<std::uint32_t> facets;  // looked at, ascending: all that the patch and its occluders can belong to
  EyeView view;
  std::vector<ContourEdge> contours;
  PlaneGrid bins;             // of the contours
  std::vector<State> states;  // of all triangles, at first
  /// The last seed, and whether a code can be placed there.
  std::optional<std::pair<std::uint32_t, Status>> checked;

  SilhouetteSurroundings(const Mesh& ofMesh, const Adjacency& ofAdjacency, const ProjectionFrame& fromFrame,
                         double radiusMm, const ClusteredTriangles* clusters)
      : mesh(ofMesh),
        adjacency(ofAdjacency),
        frame(fromFrame),
        radius(radiusMm),
        facets(facetsAbout(mesh, clusters, frame, radius)),
        view(viewFrom(mesh, frame, withNeighbours(facets, adjacency))),
        contours(contourEdges(mesh, adjacency, frame, view, facets)),
        bins(imagesOf(contours), 2 * radius),
        states(mesh.triangles.size(), State::Excluded) {
    // Goes in order of storage, not of the flood: on large meshes memory access, not arithmetic, dominates the time.
    for (const std::uint32_t t : facets) {
      if (view.facing[t] != Facing::Front) continue;
      const Triangle2 image = view.triangle(mesh.triangles[t]);
      if (isWithin(image, radius)) states[t] = bins.anyNear(image) ? State::Unseen : State::Clear;
    }
  }
};

namespace {

class Flood {
 public:
  Flood(SilhouetteSurroundings& around, GrowingRegion region)
      : mesh_(around.mesh),
        adjacency_(around.adjacency),
        frame_(around.frame),
        eye_(around.frame.eye()),
        radius_(around.radius),
        region_(region),
        facets_(around.facets),
        view_(around.view),
        contours_(around.contours),
        bins_(around.bins),
        looksBefore_(around.bins.looked()),
        maxLooks_(kMinLooks + kLooksPerTriangle * mesh_.triangles.size()),
        state_(around.states) {}

  void run(std::uint32_t seed) {
    seed_ = seed;
    offer(seed, Vec2(0));
    for (;;) {
      if (!open_.empty()) {
        const std::uint32_t triangle = open_.back();
        open_.pop_back();
        leave(triangle, {}, Vec2(0));
      } else if (!waiting_.empty()) {
        const Entry entry = waiting_.top();
        waiting_.pop();
        if (state_[entry.triangle] == State::Taken) continue;
        state_[entry.triangle] = State::Taken;
        ObstructedFacet& facet = obstructed_[entry.record];
        facet.reach = entry.reach;
        leave(entry.triangle, std::vector<Segment2>(facet.occluders), entry.point);  // a copy: the list may grow
      } else {
        break;
      }
    }
    dropOverlapping();
  }

  VisiblePatch patch() const {
    VisiblePatch result;
    result.radiusMm = radius_;
    result.partlyHidden = !obstructed_.empty();
    result.looks = looked();
    for (const std::uint32_t t : facets_) {
      if (state_[t] != State::Taken) continue;
      result.triangles.push_back(t);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t across = adjacency_[t][k];
        if (across == kNoTriangle || state_[across] != State::Taken) addSilhouette(result, edgeOf(t, k));
      }
    }
    for (const ObstructedFacet& facet : obstructed_) {
      if (state_[facet.triangle] != State::Taken) continue;
      for (const Segment2& segment : facet.occluders) addSilhouette(result, segment);
    }
    return result;
  }

 private:
  /// An entry point into an obstructed facet: the nearest first, ties by index.
  struct Entry {
    double reach;
    std::uint32_t triangle;
    std::uint32_t record;
    Vec2 point;
    bool operator<(const Entry& other) const {
      return reach != other.reach ? reach > other.reach : triangle > other.triangle;
    }
  };

  std::size_t looked() const { return bins_.looked() - looksBefore_; }
  Triangle2 image(std::uint32_t triangle) const { return view_.triangle(mesh_.triangles[triangle]); }

  Segment2 edgeOf(std::uint32_t triangle, std::size_t k) const {
    const Triangle& t = mesh_.triangles[triangle];
    return {view_.projected[t[k]], view_.projected[t[(k + 1) % 3]]};
  }

  void addSilhouette(VisiblePatch& patch, const Segment2& segment) const {
    if (distanceToSegment(Vec2(0), segment) <= radius_) patch.silhouette.push_back(segment);
  }

  /// Offers a visible point of `triangle` on the edge over which the flood comes (in the seed: the centre).
  void offer(std::uint32_t triangle, Vec2 point) {
    State& state = state_[triangle];
    if (state == State::Unseen && looked() > maxLooks_) state = State::Excluded;
    if (state == State::Unseen) {
      ObstructedFacet facet = occludersOf(triangle);
      if (facet.occluders.empty()) {
        state = State::Clear;
      } else {
        state = State::Waiting;
        recordOf_[triangle] = static_cast<std::uint32_t>(obstructed_.size());
        obstructed_.push_back(std::move(facet));
      }
    }
    if (state == State::Clear) {
      state = State::Taken;
      open_.push_back(triangle);
    } else if (state == State::Waiting)
      waiting_.push({reachOfPoint(point, region_), triangle, recordOf_.at(triangle), point});
  }

  ObstructedFacet occludersOf(std::uint32_t triangle) {
    ObstructedFacet facet;
    facet.triangle = triangle;
    for (const std::uint32_t index : bins_.near(image(triangle))) {
      const std::optional<Occluder> occluder = occluderOf(mesh_, triangle, contours_[index], eye_, frame_, view_);
      if (!occluder) continue;
      facet.occluders.push_back(occluder->segment);
      facet.crossed = facet.crossed || occluder->crosses;
    }
    return facet;
  }

  /// Offers the neighbours of a facet: all of them, or those that a path from `from` reaches without meeting an
  /// occluder.
  void leave(std::uint32_t triangle, std::span<const Segment2> occluders, Vec2 from) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t across = adjacency_[triangle][k];
      if (across == kNoTriangle) continue;
      const State state = state_[across];
      if (state != State::Clear && state != State::Unseen && state != State::Waiting) continue;
      if (const std::optional<Vec2> point = clearPoint(edgeOf(triangle, k), from, occluders)) offer(across, *point);
    }
  }

  /// Finds a point of an edge that the straight path from `from` reaches without meeting an occluder. It first tries
  /// the point nearest to the centre (the proof of exactness needs no other); the others help regions other than discs.
  std::optional<Vec2> clearPoint(const Segment2& edge, Vec2 from, std::span<const Segment2> occluders) const {
    const Vec2 along = edge[1] - edge[0];
    for (const Vec2 point : {nearestInnerPoint(edge[0], edge[1], region_), edge[0] + along * 0.5,
                             edge[0] + along * 0.25, edge[0] + along * 0.75}) {
      const bool clear = std::none_of(occluders.begin(), occluders.end(), [&](const Segment2& occluder) {
        return distanceBetween({from, point}, occluder) <= view_.noiseMm;
      });
      if (clear) return point;
    }
    return {};
  }

  /// Drops the facet met later of each two whose images overlap. Facets without occluders are fully visible and never
  /// overlap one another, so one of the two is crossed.
  void dropOverlapping() {
    std::vector<std::uint32_t> crossed;  // records
    std::vector<Triangle2> images;
    for (std::uint32_t record = 0; record < obstructed_.size(); ++record) {
      const ObstructedFacet& facet = obstructed_[record];
      if (!facet.crossed || state_[facet.triangle] != State::Taken) continue;
      crossed.push_back(record);
      images.push_back(image(facet.triangle));
    }
    if (crossed.empty()) return;

    PlaneGrid bins(images, 2 * radius_);
    bool dropped = false;
    for (const std::uint32_t t : facets_) {
      if (state_[t] != State::Taken) continue;
      if (bins.looked() > maxLooks_) return dropCrossed();
      for (const std::uint32_t index : bins.near(image(t))) {
        const ObstructedFacet& facet = obstructed_[crossed[index]];
        if (facet.triangle == t || state_[facet.triangle] != State::Taken) continue;
        if (!imagesOverlap(mesh_, t, facet.triangle, eye_)) continue;
        const bool keepFacet = facet.triangle == seed_ || (t != seed_ && facet.reach <= reachOf(t));
        state_[keepFacet ? t : facet.triangle] = State::Dropped;
        dropped = true;
        if (keepFacet) break;
      }
    }
    if (dropped) keepConnected();
  }

  /// Drops all crossed facets but the seed, and those that overlap the seed.
  void dropCrossed() {
    bool isSeedCrossed = false;
    for (const ObstructedFacet& facet : obstructed_) {
      if (!facet.crossed || state_[facet.triangle] != State::Taken) continue;
      if (facet.triangle == seed_)
        isSeedCrossed = true;
      else
        state_[facet.triangle] = State::Dropped;
    }
    if (isSeedCrossed)
      for (const std::uint32_t t : facets_)
        if (state_[t] == State::Taken && t != seed_ && imagesOverlap(mesh_, t, seed_, eye_)) state_[t] = State::Dropped;
    keepConnected();
  }

  double reachOf(std::uint32_t triangle) const {
    const auto record = recordOf_.find(triangle);
    return record == recordOf_.end() ? reachOfTriangle(image(triangle), region_) : obstructed_[record->second].reach;
  }

  void keepConnected() {
    std::vector<std::uint8_t> connected(state_.size(), 0);
    std::vector<std::uint32_t> stack{seed_};
    connected[seed_] = 1;
    while (!stack.empty()) {
      const std::uint32_t triangle = stack.back();
      stack.pop_back();
      for (const std::uint32_t across : adjacency_[triangle]) {
        if (across == kNoTriangle || state_[across] != State::Taken || connected[across]) continue;
        connected[across] = 1;
        stack.push_back(across);
      }
    }
    for (const std::uint32_t t : facets_)
      if (state_[t] == State::Taken && !connected[t]) state_[t] = State::Dropped;
  }

  const Mesh& mesh_;
  const Adjacency& adjacency_;
  const ProjectionFrame& frame_;
  Vec3 eye_;
  double radius_;
  GrowingRegion region_;
  const std::vector<std::uint32_t>& facets_;
  const EyeView& view_;
  const std::vector<ContourEdge>& contours_;
  PlaneGrid& bins_;
  std::size_t looksBefore_, maxLooks_;
  std::uint32_t seed_ = 0;
  std::vector<State> state_;
  std::vector<std::uint32_t> open_;  // taken, without occluders, not yet left
  std::priority_queue<Entry> waiting_;
  std::vector<ObstructedFacet> obstructed_;
  std::unordered_map<std::uint32_t, std::uint32_t> recordOf_;  // triangle → index in obstructed_; only looked up
};

/// Returns an error if no code can be placed at the centre.
Status checkCentre(const SilhouetteSurroundings& around, std::uint32_t seed) {
  const EyeView& view = around.view;
  const ProjectionFrame& frame = around.frame;
  if (view.facing[seed] == Facing::Away)
    return fail(ErrorKind::NoSolution, message<"centre-faces-away">(with::index<"triangle">(seed)));
  if (view.facing[seed] == Facing::FrontOutOfReach)
    return fail(ErrorKind::NoSolution, message<"centre-behind-eye">(with::index<"triangle">(seed),
                                                                    with::lengthMm<"distance">(frame.eyeDistance)));
  if (const std::optional<CentreObstruction> obstruction = whatHidesCentre(around.mesh, frame, view, around.facets))
    return fail(ErrorKind::NoSolution,
                message<"centre-hidden">(with::index<"triangle">(obstruction->triangle),
                                         with::lengthMm<"fromEye">(obstruction->fromEyeMm),
                                         with::lengthMm<"before">(frame.eyeDistance - obstruction->fromEyeMm),
                                         with::lengthMm<"clear">(downToThreeDigits(obstruction->clearDistanceMm))));
  return {};
}

}  // namespace

SilhouetteFinder::SilhouetteFinder(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                   double radiusMm, const ClusteredTriangles* clusters) {
  assert(adjacency.size() == mesh.triangles.size() && radiusMm > 0);
  around_ = std::make_unique<SilhouetteSurroundings>(mesh, adjacency, frame, radiusMm, clusters);
}
SilhouetteFinder::~SilhouetteFinder() = default;

double SilhouetteFinder::radiusMm() const { return around_->radius; }

Result<VisiblePatch> SilhouetteFinder::find(std::uint32_t seed, GrowingRegion region) {
  assert(seed < around_->mesh.triangles.size());
  auto& checked = around_->checked;
  if (!checked || checked->first != seed) checked.emplace(seed, checkCentre(*around_, seed));
  QRELIEF_TRY(checked->second);
  Flood flood(*around_, region);
  flood.run(seed);
  return flood.patch();
}

}  // namespace qrelief
