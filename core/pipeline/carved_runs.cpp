// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/carved_runs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "math/box.h"
#include "pipeline/carved_objects.h"
#include "pipeline/carved_parts.h"

namespace qrelief {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr double kOnFacetMm =
    1e-4;  // rounding of corners to 32-bit floats, and a facet that is not quite flat after it
constexpr double kSameNormal = 0.999;
constexpr double kInsideSlack = 1e-4;  // of a facet, in its barycentric coordinates

/// Finds the facet on which a point lies, among few facets.
class CutFacets {
 public:
  CutFacets(const Mesh& mesh, std::vector<std::uint32_t> facets, const ProjectionFrame& frame)
      : mesh_(mesh), facets_(std::move(facets)), frame_(frame) {
    Box3 box;
    for (const std::uint32_t f : facets_)
      for (int k = 0; k < 3; ++k) box.add(flat(mesh_.corner(f, k)));
    origin_ = box.min;
    side_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(facets_.size()))));
    cell_ = std::max({box.size().x, box.size().y, 1e-9}) / static_cast<double>(side_) * 1.000001;
    cells_.resize(side_ * side_);
    for (const std::uint32_t f : facets_) {
      Box3 own;
      for (int k = 0; k < 3; ++k) own.add(flat(mesh_.corner(f, k)));
      for (std::size_t y = indexOf(own.min.y - origin_.y); y <= indexOf(own.max.y - origin_.y); ++y)
        for (std::size_t x = indexOf(own.min.x - origin_.x); x <= indexOf(own.max.x - origin_.x); ++x)
          cells_[y * side_ + x].push_back(f);
    }
  }

  /// @param normal  of the surface there, unit length
  /// @returns a triangle of the mesh; kNone if the point lies on none
  std::uint32_t find(Vec3 point, Vec3 normal) const {
    const Vec3 at = flat(point) - origin_;
    if (facets_.empty() || at.x < -cell_ || at.y < -cell_) return kNone;
    for (const std::uint32_t f : cells_[indexOf(at.y) * side_ + indexOf(at.x)])
      if (isOn(f, point, normal)) return f;
    return kNone;
  }

 private:
  Vec3 flat(Vec3 p) const { return {glm::dot(p, frame_.right), glm::dot(p, frame_.up), 0}; }
  std::size_t indexOf(double offset) const {
    return std::min(side_ - 1, static_cast<std::size_t>(std::max(0.0, offset) / cell_));
  }

  bool isOn(std::uint32_t f, Vec3 point, Vec3 normal) const {
    const Vec3 a = mesh_.corner(f, 0), b = mesh_.corner(f, 1), c = mesh_.corner(f, 2);
    const Vec3 area = glm::cross(b - a, c - a);
    const double twice = glm::length(area);
    if (!(twice > 0) || glm::dot(area, normal) < kSameNormal * twice) return false;
    if (std::abs(glm::dot(area, point - a)) > kOnFacetMm * twice) return false;
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      if (glm::dot(glm::cross(q - p, point - p), area) < -kInsideSlack * twice * twice) return false;
    return true;
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> facets_;
  ProjectionFrame frame_;
  Vec3 origin_{0};
  std::size_t side_ = 1;
  double cell_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

/// Origins of a carved mesh's facets.
class Origins {
 public:
  Origins(const PreparedModel& before, const EngraveResult& result) : before_(before), result_(result) {
    std::vector<std::uint32_t> own(before.mesh.triangles.size());
    std::iota(own.begin(), own.end(), 0u);
    old_ = partsAfterCarving(before.mesh, own, result.mesh, result.keptTriangles, kNone);
    const auto newOnes = std::find(old_.begin(), old_.end(), kNone);  // kept facets come first, in their old order
    std::set_difference(own.begin(), own.end(), old_.begin(), newOnes, std::back_inserter(cut_));
  }

  const std::vector<std::uint32_t>& cut() const { return cut_; }
  /// Returns the old facet that a facet is; kNone for new facets.
  std::uint32_t old(std::size_t t) const { return old_[t]; }

  /// Returns the attributes that each facet keeps.
  std::vector<KeptAttributes> attributes() const {
    using What = KeptAttributes::What;
    const CutFacets cutFacets(before_.mesh, cut_, result_.placement.frame);
    std::vector<char> isSeen(before_.mesh.triangles.size(), 0);
    for (const std::uint32_t t : result_.placement.patch.triangles) isSeen[t] = 1;
    std::vector<KeptAttributes> attributes(result_.mesh.triangles.size());
    for (std::size_t t = 0; t < attributes.size(); ++t) {
      const Vec3 a = result_.mesh.corner(t, 0), b = result_.mesh.corner(t, 1), c = result_.mesh.corner(t, 2);
      const Vec3 middle = (a + b + c) / 3.0, area = glm::cross(b - a, c - a);
      const double twice = glm::length(area);
      const bool isOld = old_[t] != kNone;
      if ((!isOld || isSeen[old_[t]]) && isUnderCode(middle)) continue;
      const std::uint32_t facet = isOld ? old_[t] : twice > 0 ? cutFacets.find(middle, area / twice) : kNone;
      if (facet != kNone) attributes[t] = {isOld ? What::All : What::WholePaint, before_.originOfTriangle[facet]};
    }
    return attributes;
  }

 private:
  bool isUnderCode(Vec3 point) const {
    const Placement& place = result_.placement;
    if (place.frame.distanceAlongAxis(point) <= 0) return false;
    const Vec2 p = place.frame.project(point);
    return std::max(std::abs(p.x), std::abs(p.y)) <= place.symbolMm / 2;
  }

  const PreparedModel& before_;
  const EngraveResult& result_;
  std::vector<std::uint32_t> old_, cut_;
};

std::size_t runOf(const ThreeMfSource& source, std::uint32_t triangle) {
  const auto after = std::upper_bound(source.runs.begin(), source.runs.end(), triangle,
                                      [](std::size_t t, const ThreeMfRun& run) { return t < run.firstTriangle; });
  return static_cast<std::size_t>(after - source.runs.begin()) - 1;
}

}  // namespace

Result<std::vector<ChangedRun>> carvedRuns(const PreparedModel& before, const EngraveResult& result, bool withInlay) {
  const ThreeMfSource& source = *before.source;
  const Origins origins(before, result);
  const auto runOfOld = [&](std::uint32_t facet) { return runOf(source, before.originOfTriangle[facet]); };
  const std::size_t carved = runOfOld(origins.cut().empty() ? result.placement.seed : origins.cut().front());
  for (const std::uint32_t facet : origins.cut())
    if (runOfOld(facet) != carved) return fail(ErrorKind::NoSolution, message("rewrite-several-bodies"));

  std::vector<std::uint32_t> runs(result.mesh.triangles.size(), static_cast<std::uint32_t>(carved));
  for (std::size_t t = 0; t < runs.size(); ++t)
    if (origins.old(t) != kNone) runs[t] = static_cast<std::uint32_t>(runOfOld(origins.old(t)));
  const std::vector<KeptAttributes> attributes = origins.attributes();
  std::vector<ChangedRun> changes;
  for (std::size_t r = 0; r < source.runs.size(); ++r) {
    if (r != carved && before.equalsSource) continue;
    ChangedRun change;
    change.run = r;
    const std::vector<std::uint32_t> triangles = trianglesOf(runs, static_cast<std::uint32_t>(r));
    change.mesh = submesh(result.mesh, triangles);
    for (const std::uint32_t t : triangles) change.kept.push_back(attributes[t]);
    change.painted = placesIn(triangles, result.painted);
    if (r == carved && withInlay && result.inlay) change.inlay = codeBody(*result.inlay);
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace qrelief
