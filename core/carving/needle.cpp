// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/needle.h"

#include <algorithm>
#include <cmath>

namespace qrelief {
namespace {

/// Height below which a facet is a needle, in lowest heights. Twice the lowest, because an oblique outline is cut into
/// pieces shorter than the facet's height.
constexpr double kNeedleHeights = 2;

class NeedleFlipper {
 public:
  NeedleFlipper(Footprint& footprint, const Mesh& mesh) : footprint_(footprint), mesh_(mesh) {
    std::vector<Vec3f> positions;
    for (const std::uint32_t v : footprint.vertices) positions.push_back(mesh.positions[v]);
    lowest_ = kNeedleHeights * lowestHeight(positions);
  }

  void run() {
    std::vector<std::uint32_t> needles;
    for (std::uint32_t f = 0; f < footprint_.corners.size(); ++f)
      if (height(footprint_.corners[f]) < lowest_) needles.push_back(f);
    if (needles.empty()) return;
    around_.resize(footprint_.points.size());
    for (std::uint32_t f = 0; f < footprint_.corners.size(); ++f)
      for (const std::uint32_t v : footprint_.corners[f]) around_[v].push_back(f);
    while (!needles.empty()) {
      const std::uint32_t needle = needles.back();
      needles.pop_back();
      const std::uint32_t other = flip(needle);
      if (other == kNoFacet) continue;
      for (const std::uint32_t f : {needle, other})
        if (height(footprint_.corners[f]) < lowest_) needles.push_back(f);
    }
  }

 private:
  Vec3f position(std::uint32_t local) const { return mesh_.positions[footprint_.vertices[local]]; }

  double height(const Triangle& t) const { return triangleHeight(position(t[0]), position(t[1]), position(t[2])); }

  bool counterClockwise(const Triangle& t) const {
    const Vec2 a = footprint_.points[t[0]];
    return cross2(footprint_.points[t[1]] - a, footprint_.points[t[2]] - a) > 0;
  }

  /// Returns the triangle rotated so that its longest edge comes first.
  Triangle longestFirst(const Triangle& t) const {
    const auto length = [&](std::size_t k) {
      return glm::length(Vec3(position(t[(k + 1) % 3])) - Vec3(position(t[k])));
    };
    const std::size_t k = length(0) >= length(1) && length(0) >= length(2) ? 0 : length(1) >= length(2) ? 1 : 2;
    return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
  }

  /// Returns the facet with the edge b → a, and in `turned` its corners with this edge first; or kNoFacet.
  std::uint32_t facetBeyond(std::uint32_t a, std::uint32_t b, Triangle& turned) const {
    for (const std::uint32_t f : around_[a]) {
      const Triangle& t = footprint_.corners[f];
      for (std::size_t k = 0; k < 3; ++k) {
        turned = {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
        if (turned[0] == b && turned[1] == a) return f;
      }
    }
    return kNoFacet;
  }

  /// Flips a facet's longest edge if that raises the lower of the two facets at it. The sorted list of all heights
  /// rises with each flip, so flipping ends. Returns the other facet, or kNoFacet if nothing was flipped.
  std::uint32_t flip(std::uint32_t needle) {
    const auto [a, b, c] = longestFirst(footprint_.corners[needle]);
    Triangle turned{};
    const std::uint32_t other = facetBeyond(a, b, turned);
    if (other == kNoFacet) return kNoFacet;
    const Triangle first{a, turned[2], c}, second{turned[2], b, c};
    const double before = std::min(height(footprint_.corners[needle]), height(footprint_.corners[other]));
    if (std::min(height(first), height(second)) <= before) return kNoFacet;
    if (!counterClockwise(first) || !counterClockwise(second)) return kNoFacet;
    footprint_.corners[needle] = first;
    footprint_.corners[other] = second;
    footprint_.reshaped[needle] = footprint_.reshaped[other] = 1;
    std::erase(around_[b], needle);
    std::erase(around_[a], other);
    around_[turned[2]].push_back(needle);
    around_[c].push_back(other);
    return other;
  }

  Footprint& footprint_;
  const Mesh& mesh_;
  double lowest_ = 0;
  std::vector<std::vector<std::uint32_t>> around_;  // vertex → facets
};

}  // namespace

double lowestHeight(std::span<const Vec3f> positions) {
  constexpr double kUnits = 4;
  float largest = 0;
  for (const Vec3f& p : positions) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return kUnits * (std::nextafter(largest, HUGE_VALF) - largest);
}

double triangleHeight(Vec3f a, Vec3f b, Vec3f c) {
  const Vec3 ab = Vec3(b) - Vec3(a), ac = Vec3(c) - Vec3(a);
  const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
  return longest > 0 ? glm::length(glm::cross(ab, ac)) / longest : 0;
}

void flipNeedles(Footprint& footprint, const Mesh& mesh) {
  footprint.reshaped.assign(footprint.corners.size(), 0);
  NeedleFlipper(footprint, mesh).run();
}

}  // namespace qrelief
