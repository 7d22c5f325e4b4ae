// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/colour_changes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "math/box.h"
#include "math/frame.h"
#include "printing/cross_sections.h"
#include "printing/extruded_outline.h"

namespace qrelief {
namespace {

/// PLA, as in the filament profiles of PrusaSlicer and Bambu Studio.
constexpr double kDensityGPerMm3 = 1.24e-3;

/// Purge of a change: slicers ask for 200 to 300 mm³ between distant colours; this is the middle.
constexpr double kUsualPurgeMm3 = 250;
/// Loading and unloading: 29 s and 28 s in Bambu Studio's profile of the X1C and P1S. Pushing out the purge: an
/// assumed flow of 12 mm³/s, the usual limit of PLA through a nozzle of 0.4 mm.
constexpr double kSwapSeconds = 57, kPurgeMm3PerSecond = 12;

/// Wipe tower of PrusaSlicer 2.5 by default: its width, the gap between the walls in its layers without a change, its
/// brim, and the width of its lines in nozzles.
constexpr double kTowerWidthMm = 60, kTowerGapMm = 10, kTowerBrimMm = 2, kTowerLineNozzles = 1.25;

constexpr double kNodesPerFinest = 6;
/// Plastic that a bead's round side leaves out, in layers, as a mean width behind the outline. A half circle would
/// leave out twice as much; fill that overlaps its outer walls makes up for half (bench/colour_changes.mjs).
constexpr double kRoundSide = (1 - std::numbers::pi / 4) / 4;
/// Turns a model so that the printer's vertical is z.
struct Upright {
  ProjectionFrame axes;

  explicit Upright(Vec3 up) : axes(makeFrame(Vec3(0), up, {0, 1, 0}, 1)) {}

  Vec3 operator()(Vec3 p) const { return {glm::dot(p, axes.right), glm::dot(p, axes.up), glm::dot(p, axes.normal)}; }

  std::vector<Vec3> positions(const Mesh& mesh) const {
    std::vector<Vec3> positions;
    positions.reserve(mesh.positions.size());
    for (const Vec3f& p : mesh.positions) positions.push_back((*this)(Vec3(p)));
    return positions;
  }

  Box3 box(const Mesh& mesh) const {
    Box3 box;
    for (const Vec3f& p : mesh.positions) box.add((*this)(Vec3(p)));
    return box;
  }
};

/// Returns a plane in the middle of every layer from the print's lowest point to its highest.
CuttingPlanes layersOf(const Box3& box, double layerMm) {
  const int count = std::max(1, static_cast<int>(std::lround(box.size().z / layerMm)));
  return {box.min.z + layerMm / 2, layerMm, count};
}

/// Returns for each layer whether it cuts a body.
std::vector<char> cutLayers(const Upright& upright, const Mesh& body, const CuttingPlanes& planes) {
  std::vector<double> heights;
  heights.reserve(body.positions.size());
  for (const Vec3f& p : body.positions) heights.push_back(glm::dot(Vec3(p), upright.axes.normal));
  std::vector<char> cut(static_cast<std::size_t>(planes.count), 0);
  for (const auto& [a, b, c] : body.triangles) {
    const auto [low, high] = std::minmax({heights[a], heights[b], heights[c]});
    const int end = planes.firstAbove(high);
    for (int k = planes.firstAbove(low); k < end; ++k) cut[k] = 1;
  }
  return cut;
}

/// Returns the area that the process prints of a cross-section, mm².
double printedAreaMm2(std::span<const Segment2> outline, const PrintProcess& process) {
  if (outline.empty()) return 0;
  Vec2 low = outline[0][0], high = low;
  for (const Segment2& segment : outline)
    for (const Vec2 end : segment) {
      low = glm::min(low, end);
      high = glm::max(high, end);
    }
  const double step = process.finestMm / kNodesPerFinest, margin = 2 * process.cornerRadiusMm + 2 * step;
  const Vec2 nodes = glm::ceil((high - low + 2 * margin) / step);
  const LayerWindow window{low - margin, step, static_cast<int>(nodes.x) + 1, static_cast<int>(nodes.y) + 1};
  const LayerGrid extruded = layOutline(outline, window, window.origin - step, 0, process);
  const double inside = process.thinnestLineMm > 0 ? -kRoundSide * process.layerMm : 0;
  const auto count = std::count_if(extruded.distanceMm.begin(), extruded.distanceMm.end(),
                                   [&](float distance) { return static_cast<double>(distance) < inside; });
  return static_cast<double>(count) * step * step;
}

/// Returns the plastic of a wipe tower without the purges, mm³. It ends at the last layer with a change. The first
/// layer is solid and has a brim. Layers with changes have a wall around the purges. All others have two walls, and
/// lines across that carry the layer above.
/// @param changes  in each layer
double wipeTowerMm3(const std::vector<int>& changes, double purgeMm3, const PrintProcess& process) {
  const int most = *std::max_element(changes.begin(), changes.end());
  if (most == 0 || purgeMm3 <= 0) return 0;
  const double layer = process.layerMm, line = kTowerLineNozzles * process.finestMm;
  const double lineMm2 = layer * (line - layer * (1 - std::numbers::pi / 4));  // with round sides
  const double lengthMm = most * purgeMm3 / lineMm2 / kTowerWidthMm * line;
  const double wallMm = 2 * (kTowerWidthMm + lengthMm);
  const double insideMm = kTowerWidthMm - 6 * line;  // the lines across end three lines from either side
  const double acrossMm = (1 + std::floor(insideMm / kTowerGapMm)) * lengthMm + insideMm;
  const double solidMm3 = (kTowerWidthMm + 2 * kTowerBrimMm) * (lengthMm + 2 * kTowerBrimMm) * layer;
  double sum = std::max(0.0, solidMm3 - changes.front() * purgeMm3);
  const auto end = std::find_if(changes.rbegin(), changes.rend(), [](int count) { return count > 0; }).base();
  for (auto count = changes.begin() + 1; count < end; ++count)
    sum += lineMm2 * (*count > 0 ? wallMm : 2 * wallMm + acrossMm);
  return sum;
}

/// Prices the changes between two sets of layers. Layers with neither filament, in a model of several pieces, change
/// nothing.
ColourCost priced(const std::vector<char>& first, const std::vector<char>& second, double secondMm3,
                  const ColourPrint& print) {
  constexpr int kNone = -1, kFirst = 0, kSecond = 1;
  ColourCost cost;
  int held = kNone, toFirst = 0, toSecond = 0;
  std::vector<int> changes(second.size(), 0);
  const auto need = [&](int filament, std::size_t layer) {
    if (held == 1 - filament) {
      ++(filament == kFirst ? toFirst : toSecond);
      ++changes[layer];
    }
    held = filament;
  };
  for (std::size_t k = 0; k < second.size(); ++k) {
    if (second[k]) ++cost.layers;
    const int begin = held == kSecond ? kSecond : kFirst;
    for (const int filament : {begin, 1 - begin})
      if (filament == kFirst ? first[k] : second[k]) need(filament, k);
  }
  const double purgeG = print.change.purgeMm3 * kDensityGPerMm3;
  cost.changes = toFirst + toSecond;
  cost.secondG = secondMm3 * kDensityGPerMm3;
  cost.firstWasteG = toFirst * purgeG;
  cost.secondWasteG = toSecond * purgeG;
  cost.wasteMinutes = cost.changes * print.change.seconds / 60;
  cost.towerG = wipeTowerMm3(changes, print.change.purgeMm3, print.process) * kDensityGPerMm3;
  return cost;
}

}  // namespace

std::optional<FilamentChange> usualFilamentChange(const Printer& printer) {
  if (printer.technique != PrintTechnique::Filament) return std::nullopt;
  return FilamentChange{kUsualPurgeMm3, kSwapSeconds + kUsualPurgeMm3 / kPurgeMm3PerSecond};
}

ColourCost colourCost(const Mesh& body, const Mesh& inlay, const ColourPrint& print) {
  if (inlay.triangles.empty()) return {};
  const Upright upright(print.up);
  Box3 box = upright.box(body);
  const Box3 inlaid = upright.box(inlay);
  box.add(inlaid.min);
  box.add(inlaid.max);
  const CuttingPlanes planes = layersOf(box, print.process.layerMm);
  std::vector<char> second;
  double secondMm3 = 0;
  // Corners of the mesh have neither the x nor the y of a corner that lies outside the box.
  const Vec2 low = Vec2(inlaid.min) - 1.0, high = Vec2(inlaid.max) + 1.0;
  for (const std::vector<Segment2>& outline :
       cutByPlanes(upright.positions(inlay), inlay.triangles, planes, low, high).outlines) {
    const double area = printedAreaMm2(outline, print.process);
    second.push_back(area > 0);
    secondMm3 += area * print.process.layerMm;
  }
  return priced(cutLayers(upright, body, planes), second, secondMm3, print);
}

ColourCost colourCost(const Mesh& body, const PaintedTriangles& painted, const ColourPrint& print) {
  if (painted.triangles.empty()) return {};
  const Upright upright(print.up);
  const CuttingPlanes planes = layersOf(upright.box(body), print.process.layerMm);
  std::vector<char> second(static_cast<std::size_t>(planes.count), 0);
  double areaMm2 = 0;
  for (const std::uint32_t t : painted.triangles) {
    const Vec3 normal = triangleNormal(body, t);
    const double deeper = -painted.depthMm * glm::dot(normal, upright.axes.normal);
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < 3; ++k) {
      const double z = glm::dot(body.corner(t, k), upright.axes.normal);
      low = std::min({low, z, z + deeper});
      high = std::max({high, z, z + deeper});
    }
    // Planes at `low` itself count as above it, like vertices in cutByPlanes().
    const auto planeAbove = [&](double z) {
      return std::clamp(static_cast<int>(std::ceil((z - planes.firstMm) / planes.stepMm - 1e-6)), 0, planes.count);
    };
    for (int k = planeAbove(low); k < planeAbove(high); ++k) second[k] = 1;
    areaMm2 +=
        glm::length(glm::cross(body.corner(t, 1) - body.corner(t, 0), body.corner(t, 2) - body.corner(t, 0))) / 2;
  }
  return priced(cutLayers(upright, body, planes), second, areaMm2 * painted.depthMm, print);
}

}  // namespace qrelief
