// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/carving_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "math/tolerance.h"
#include "mesh/topology.h"
#include "messages/sentences.h"
#include "verification/solidity.h"

namespace qrelief::oracle {
namespace {

bool seenFromFront(const Mesh& mesh, const ProjectionFrame& frame, std::uint32_t t) {
  const Vec3 a = mesh.corner(t, 0);
  const Vec3 normal = glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a);
  return glm::dot(normal, frame.eye() - a) > 1e-6 * glm::length(normal) * glm::length(frame.eye() - a);
}

double distanceToOrigin(const std::array<Vec2, 3>& t) {
  bool inside = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 a = t[k], ab = t[(k + 1) % 3] - a;
    inside = inside && cross2(ab, -a) >= 0;
    nearest = std::min(nearest, glm::length(a + ab * std::clamp(glm::dot(-a, ab) / glm::dot(ab, ab), 0.0, 1.0)));
  }
  return inside ? 0 : nearest;
}

/// Returns the distance at which the ray meets a triangle from its front; infinite if it does not.
double hitDistance(const std::array<Vec3, 3>& t, Vec3 origin, Vec3 direction) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], w = origin - t[0];
  const double determinant = -glm::dot(direction, glm::cross(u, v));
  const Vec3 q = glm::cross(w, direction);
  const double beta = glm::dot(v, q), gamma = -glm::dot(u, q);
  if (determinant <= 0 || beta < 0 || gamma < 0 || beta + gamma > determinant)
    return std::numeric_limits<double>::infinity();
  return glm::dot(w, glm::cross(u, v)) / determinant;
}

/// Finds the first hits of rays from the eye; the triangles are sorted into bins of the plane.
class RayCaster {
 public:
  RayCaster(const Mesh& mesh, const ProjectionFrame& frame, double halfMm) : mesh_(mesh), frame_(frame), half_(halfMm) {
    bins_.resize(kBins * kBins);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      Vec2 lo(1e300), hi(-1e300);
      for (int k = 0; k < 3; ++k) {
        lo = glm::min(lo, frame.project(mesh.corner(t, k)));
        hi = glm::max(hi, frame.project(mesh.corner(t, k)));
      }
      if (hi.x < -half_ || hi.y < -half_ || lo.x > half_ || lo.y > half_) continue;
      for (int row = bin(lo.y); row <= bin(hi.y); ++row)
        for (int column = bin(lo.x); column <= bin(hi.x); ++column)
          bins_[static_cast<std::size_t>(row * kBins + column)].push_back(t);
    }
  }

  double distance(Vec2 p) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t t : bins_[static_cast<std::size_t>(bin(p.y) * kBins + bin(p.x))])
      nearest = std::min(nearest, hitDistance({mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)},
                                              frame_.eye(), frame_.rayDirection(p)));
    return nearest;
  }

 private:
  static constexpr int kBins = 64;
  int bin(double x) const { return static_cast<int>(std::clamp((x / half_ + 1) / 2 * kBins, 0.0, kBins - 1.0)); }

  const Mesh& mesh_;
  const ProjectionFrame& frame_;
  const double half_;
  std::vector<std::vector<std::uint32_t>> bins_;
};

}  // namespace

std::vector<std::uint32_t> frontPatch(const Mesh& mesh, const Adjacency& adjacency, const ProjectionFrame& frame,
                                      double reachMm) {
  const auto distance = [&](std::uint32_t t) {
    return distanceToOrigin(
        {frame.project(mesh.corner(t, 0)), frame.project(mesh.corner(t, 1)), frame.project(mesh.corner(t, 2))});
  };
  std::uint32_t seed = kNoTriangle;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!seenFromFront(mesh, frame, t) || distance(t) > 0) continue;
    const bool nearer = seed == kNoTriangle ||
                        frame.distanceAlongAxis(mesh.corner(t, 0)) < frame.distanceAlongAxis(mesh.corner(seed, 0));
    if (nearer) seed = t;
  }
  std::vector<std::uint32_t> patch, front{seed};
  std::vector<char> reached(mesh.triangles.size(), 0);
  reached[seed] = 1;
  while (!front.empty()) {
    const std::uint32_t t = front.back();
    front.pop_back();
    patch.push_back(t);
    for (const std::uint32_t other : adjacency[t]) {
      if (other == kNoTriangle || reached[other]) continue;
      if (!seenFromFront(mesh, frame, other) || distance(other) > reachMm) continue;
      reached[other] = 1;
      front.push_back(other);
    }
  }
  std::sort(patch.begin(), patch.end());
  return patch;
}

std::vector<std::uint32_t> frontPatchWithHole(const Mesh& mesh, const ProjectionFrame& frame) {
  std::vector<std::uint32_t> patch = frontPatch(mesh, buildAdjacency(mesh.triangles), frame, 10);
  const auto isInside = [&](std::uint32_t t) { return glm::length(mesh.corner(t, 0)) < 0.8; };
  patch.erase(std::find_if(patch.begin(), patch.end(), isInside));
  return patch;
}

Result<EmbedResult> carve(const Mesh& mesh, const ProjectionFrame& frame, const DepthField& field,
                          const EmbedOptions& options) {
  const Adjacency adjacency = buildAdjacency(mesh.triangles);
  return embedDepthField(mesh, frame, frontPatch(mesh, adjacency, frame, field.symbolMm), field, options);
}

DepthField fieldOf(int size, double symbolMm, const std::function<double(int, int)>& depthMm) {
  DepthField field{size, symbolMm, {}};
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      field.depthMm.push_back(std::round(depthMm(row, column) / kDepthQuantumMm) * kDepthQuantumMm);
  return field;
}

Mesh welded(const Mesh& mesh) {
  Mesh result;
  std::map<std::array<float, 3>, std::uint32_t> index;
  for (const Triangle& t : mesh.triangles) {
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3f p = mesh.positions[t[k]];
      const auto [entry, isNew] =
          index.emplace(std::array{p.x, p.y, p.z}, static_cast<std::uint32_t>(result.positions.size()));
      if (isNew) result.positions.push_back(p);
      corners[k] = entry->second;
    }
    result.triangles.push_back(corners);
  }
  return result;
}

std::string solidProblems(const EmbedResult& result) {
  const auto report = checkSolidity(welded(result.mesh), result.newTriangles);
  if (!report) return sentence(report.error().message);
  std::string all = report->vertices == result.mesh.positions.size() ? "" : "vertices coincide; ";
  for (const Message& problem : report->problems()) all += sentence(problem) + "; ";
  return all;
}

long eulerCharacteristic(const Mesh& mesh) {
  return static_cast<long>(mesh.positions.size()) - static_cast<long>(mesh.triangles.size()) / 2;
}

double largestDepthError(const Mesh& original, const Mesh& carved, const ProjectionFrame& frame,
                         const DepthField& field, double marginMm, int samples) {
  const RayCaster before(original, frame, field.symbolMm / 2), after(carved, frame, field.symbolMm / 2);
  double largest = 0;
  const double h = field.submoduleMm();
  for (int row = 0; row < field.size; ++row)
    for (int column = 0; column < field.size; ++column)
      for (int k = 0; k < samples; ++k) {
        // A plastic-number sequence covers the submodule evenly and avoids its lines of symmetry, where edges of a
        // model may lie.
        const Vec2 place(std::fmod(0.47 + 0.7548776662466927 * k, 1.0), std::fmod(0.58 + 0.5698402909980532 * k, 1.0));
        const Vec2 inside = place * (h - 2 * marginMm) + marginMm;
        const Vec2 p = field.corner(row, column) + Vec2(inside.x, -inside.y);
        largest = std::max(largest, std::abs(after.distance(p) - before.distance(p) - field.depth(row, column)));
      }
  return largest;
}

double pocketVolume(const ProjectionFrame& frame, const DepthField& field,
                    const std::function<double(Vec2)>& distance) {
  constexpr int kPoints = 8;  // midpoint rule along each edge of a submodule
  const double step = field.submoduleMm() / kPoints;
  double volume = 0;
  for (int row = 0; row < field.size; ++row)
    for (int column = 0; column < field.size; ++column) {
      const double d = field.depth(row, column);
      for (int k = 0; d > 0 && k < kPoints * kPoints; ++k) {
        const int below = k / kPoints;
        const Vec2 p = field.corner(row, column) + Vec2(k % kPoints + 0.5, -(below + 0.5)) * step;
        const double onPlane = glm::length(frame.onPlane(p) - frame.eye());
        const double cosine = frame.eyeDistance / onPlane;
        const double t = distance(p);
        const double scale = t / onPlane;
        volume += step * step * scale * scale * cosine * (d + d * d / t + d * d * d / (3 * t * t));
      }
    }
  return volume;
}

double wallArea(const DepthField& field) {
  const auto depth = [&](int row, int column) {
    return row < 0 || column < 0 || row >= field.size || column >= field.size ? 0.0 : field.depth(row, column);
  };
  double area = 0;
  for (int row = 0; row <= field.size; ++row)
    for (int column = 0; column <= field.size; ++column)
      area +=
          std::abs(depth(row, column) - depth(row - 1, column)) + std::abs(depth(row, column) - depth(row, column - 1));
  return area * field.submoduleMm();
}

}  // namespace qrelief::oracle
