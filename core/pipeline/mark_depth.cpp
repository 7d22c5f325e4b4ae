// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mark_depth.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "qr/module_pattern.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr double kCoveredFraction = 0.95;
constexpr double kLeastCosine = 0.5;  // of the angle between ray and normal

/// Calls visit(index of the submodule) for each submodule of a module.
template <class Visit>
void forSubmodules(const Symbol& symbol, int row, int column, const Visit& visit) {
  for (int k = 0; k < kN * kN; ++k)
    visit(static_cast<std::size_t>((kN * row + k / kN) * kN * symbol.size + kN * column + k % kN));
}

template <class Visit>
void forDarkModules(const Symbol& symbol, const Visit& visit) {
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column)
      if (symbol.isDark(row, column)) visit(row, column);
}

}  // namespace

double opaqueDepthMm(double facing, const Printer& printer) {
  return std::max(kInlayLayers * printer.layerMm * std::abs(std::cos(facing)),
                  kInlayLines * lineWidthMm(printer) * std::abs(std::sin(facing)));
}

double deepestInlayMm(const Printer& printer) {
  return std::max(opaqueDepthMm(0, printer), opaqueDepthMm(std::numbers::pi / 2, printer));
}

double inlayDepthMm(const Mesh& mesh, const Placement& placement, const Vec3& buildUp, const Printer& printer) {
  struct Need {
    double depthMm, areaMm2;
  };
  const ProjectionFrame& frame = placement.frame;
  const Vec3 up = glm::normalize(buildUp);
  const auto needOf = [&](Vec3 normal, Vec3 ray) {
    const double facing = std::acos(std::clamp(glm::dot(normal, up), -1.0, 1.0));
    return opaqueDepthMm(facing, printer) / std::max(kLeastCosine, -glm::dot(normal, ray));
  };
  std::vector<Need> needs;
  double all = 0;
  for (const std::uint32_t t : placement.patch.triangles) {
    const Vec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2), middle = (a + b + c) / 3.0;
    const Vec2 seen = glm::abs(frame.project(middle));
    if (std::max(seen.x, seen.y) > placement.symbolMm / 2) continue;
    const Vec3 normal = triangleNormal(mesh, t);
    const double area = glm::length(glm::cross(b - a, c - a)) / 2;
    needs.push_back({needOf(normal, glm::normalize(middle - frame.eye())), area});
    all += area;
  }
  if (needs.empty()) return needOf(frame.normal, -frame.normal);  // a facet that is larger than the code
  std::sort(needs.begin(), needs.end(), [](const Need& x, const Need& y) { return x.depthMm < y.depthMm; });
  double covered = 0;
  for (const Need& need : needs)
    if ((covered += need.areaMm2) >= kCoveredFraction * all) return need.depthMm;
  return needs.back().depthMm;
}

DepthField noPockets(const Symbol& symbol, double symbolMm) {
  const auto edge = static_cast<std::size_t>(kN * symbol.size);
  return {kN * symbol.size, symbolMm, std::vector<double>(edge * edge, 0)};
}

InlayPockets inlayPockets(const Symbol& symbol, double symbolMm, const std::vector<double>& limitMm, double wantedMm) {
  assert(wantedMm > 0);
  std::vector<double> moduleLimit(symbol.dark.size(), 0);
  double depth = wantedMm;
  InlayPockets pockets{noPockets(symbol, symbolMm)};
  const auto limitOf = [&](int row, int column) -> double& { return moduleLimit[row * symbol.size + column]; };
  forDarkModules(symbol, [&](int row, int column) {
    double least = std::numeric_limits<double>::infinity();
    forSubmodules(symbol, row, column, [&](std::size_t i) { least = std::min(least, limitMm[i]); });
    limitOf(row, column) = least;
    if (least >= kLeastInlayDepth * wantedMm)
      depth = std::min(depth, least);
    else
      ++pockets.leftOut;
  });
  const double quantised = quantisedDepth(depth, depth < wantedMm ? depth : std::numeric_limits<double>::infinity());
  bool isAny = false;
  forDarkModules(symbol, [&](int row, int column) {
    if (limitOf(row, column) < kLeastInlayDepth * wantedMm) return;
    isAny = true;
    forSubmodules(symbol, row, column, [&](std::size_t i) { pockets.depths.depthMm[i] = quantised; });
  });
  pockets.depthMm = isAny ? quantised : 0;
  return pockets;
}

DepthField paintedModules(const Symbol& symbol, double symbolMm) {
  DepthField field = noPockets(symbol, symbolMm);
  forDarkModules(symbol, [&](int row, int column) {
    forSubmodules(symbol, row, column, [&](std::size_t i) { field.depthMm[i] = kDepthQuantumMm; });
  });
  return field;
}

}  // namespace qrelief
