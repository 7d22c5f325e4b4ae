// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/placement.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "mesh/ray.h"
#include "projection/size.h"

namespace qrelief {
namespace {

constexpr int kMaxRounds = 5;
constexpr double kSettledShare = 0.01;

/// Below this a module is neither printed nor read by anything at hand (finest resin printers: 0.05 mm pixels, four to
/// a module).
constexpr double kLeastModuleMm = 0.2;

class Stopwatch {
 public:
  explicit Stopwatch(double& sumMs) : sumMs_(sumMs) {}
  ~Stopwatch() {
    sumMs_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  double& sumMs_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

PlacementSearch::PlacementSearch(const PreparedModel& model, const GpuMesh& gpu, const GeometryPass& pass, int modules,
                                 const PlacementRequest& request)
    : model_(&model), gpu_(&gpu), pass_(&pass), modules_(modules), request_(request) {}

double PlacementSearch::outerFactor() const {
  return request_.quietZone ? (modules_ + 2.0 * kQuietZoneModules) / modules_ : 1.0;
}

ProjectionFrame PlacementSearch::frameFor(Vec3 normal) const {
  ProjectionFrame frame = makeFrame(placement_.frame.centre, normal, request_.upHint, request_.eyeDistanceMm);
  const double angle = request_.rotateDeg * std::numbers::pi / 180;
  const Vec3 right = frame.right * std::cos(angle) + frame.up * std::sin(angle);
  frame.up = frame.up * std::cos(angle) - frame.right * std::sin(angle);
  frame.right = right;
  return frame;
}

Status PlacementSearch::start() {
  const auto surface = closestPoint(model_->mesh, request_.centreMm);
  if (!surface) return fail(ErrorCode::BadInput, "The model has no surface");
  placement_.seed = surface->triangle;
  placement_.frame.centre = surface->position;
  surfaceNormal_ = triangleNormal(model_->mesh, surface->triangle);
  if (request_.direction) return measure(*request_.direction);
  if (request_.sizeMode == SizeMode::Fixed) return {};
  return measure(surfaceNormal_);
}

Status PlacementSearch::measure(Vec3 normal) {
  const Stopwatch stopwatch(sizeMs_);
  const bool fixed = request_.sizeMode == SizeMode::Fixed;
  const ProjectionFrame frame = frameFor(normal);
  const double largest = std::max(request_.maxSizeMm, fixed ? request_.sizeMm : 0.0) * outerFactor();
  auto patch =
      findVisiblePatch(model_->mesh, model_->adjacency, frame, placement_.seed, largest * std::numbers::sqrt2 / 2);
  if (!patch) return tl::unexpected(patch.error());

  placement_.frame = frame;
  placement_.patch = std::move(*patch);
  const double free = std::min(largest, freeSize(placement_.patch.silhouette)) / outerFactor();
  const double oriented = std::min(largest, orientedSize(placement_.patch.silhouette)) / outerFactor();
  placement_.guaranteedMm = free;
  fitMm_ = request_.sizeMode == SizeMode::Free ? std::min(free, request_.maxSizeMm)
           : fixed                             ? oriented
                                               : std::min(oriented, request_.maxSizeMm);
  placement_.symbolMm = fixed ? request_.sizeMm : fitMm_;
  placement_.moduleMm = placement_.symbolMm / modules_;
  if (fixed && fitMm_ < request_.sizeMm) {
    return fail(
        ErrorCode::NoSolution,
        fmt::format("A code of {:.4g} mm{} does not fit here; the largest that does is {:.4g} mm ({:.4g} mm at any "
                    "rotation)",
                    request_.sizeMm, request_.quietZone ? " with its quiet zone" : "", std::floor(oriented * 100) / 100,
                    std::floor(free * 100) / 100),
        "Ask for a smaller size, turn the code, or choose a spot farther from edges and overhangs");
  }
  if (placement_.moduleMm < kLeastModuleMm && (fixed || fitMm_ >= request_.maxSizeMm)) {
    return fail(
        ErrorCode::NoSolution,
        fmt::format("A code of {:.4g} mm is asked for: its modules would be {:.2g} mm wide", placement_.symbolMm,
                    placement_.moduleMm),
        fmt::format("Allow a larger size (at least {:.3g} mm), or shorten the text", kLeastModuleMm * modules_));
  }
  if (placement_.moduleMm < kLeastModuleMm) {
    return fail(
        ErrorCode::NoSolution,
        fmt::format("Only a code of {:.3g} mm fits here: its modules would be {:.2g} mm wide", placement_.symbolMm,
                    placement_.moduleMm),
        "Choose a spot farther from edges and overhangs, or shorten the text; if the whole model is that small, "
        "check its unit");
  }
  return {};
}

/// The direction that varies least may be one from which the code does not fit: then the next best is tried.
Status PlacementSearch::measureBestDirection() {
  std::vector<DirectionIteration> candidates = placement_.iterations;
  std::stable_sort(
      candidates.begin() + 1, candidates.end(),
      [](const DirectionIteration& a, const DirectionIteration& b) { return a.varianceMm2 < b.varianceMm2; });
  std::rotate(candidates.begin(), candidates.begin() + 1, candidates.end());  // the single facet's normal comes last
  Status first = measure(direction_->normal());
  if (first) return first;
  for (const DirectionIteration& candidate : candidates)
    if (measure(candidate.normal)) return {};
  return first;
}

Result<bool> PlacementSearch::step() {
  if (!started_) {
    started_ = true;
    if (const Status begun = start(); !begun) return tl::unexpected(begun.error());
    return request_.direction.has_value();
  }
  if (!direction_) {
    DirectionOptions options;
    options.method = request_.directionMethod;
    options.sizeMm = request_.sizeMode == SizeMode::Fixed ? request_.sizeMm : fitMm_;
    direction_.emplace(*pass_, *gpu_, placement_.frame.centre, surfaceNormal_, request_.upHint, request_.eyeDistanceMm,
                       options);
  }
  {
    const Stopwatch stopwatch(directionMs_);
    const Result<bool> found = direction_->step();
    if (!found) return found;
    if (!*found) return false;
    placement_.iterations = direction_->iterations();
  }
  const double before = fitMm_;
  if (const Status measured = measureBestDirection(); !measured) return tl::unexpected(measured.error());
  direction_.reset();
  ++round_;
  if (request_.sizeMode == SizeMode::Fixed || round_ >= kMaxRounds) return true;
  return std::abs(fitMm_ - before) < kSettledShare * before;
}

}  // namespace qrelief
