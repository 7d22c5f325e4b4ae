// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/colour_changes.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kDensityGPerMm3 = 1.24e-3;  // PLA

/// Prints with layers of 0.2 mm and changes of 100 mm³ and 30 s.
ColourPrint upright(Vec3 up = {0, 0, 1}) {
  return {up, *processOf({0.4, 0.2, {}, PrintTechnique::Filament}), {100, 30}};
}

/// Returns a box from a corner.
Mesh block(Vec3 low, Vec3 size) { return shapes::translated(shapes::box(size), low + size / 2.0); }

TEST(ColourChanges, ACodeThatFacesUpCostsOneChangeForEachOfItsLayers) {
  // The second colour lies in the last two layers of ten: first, second; second, first.
  const ColourCost cost = colourCost(block({0, 0, 0}, {30, 30, 2}), block({5, 5, 1.6}, {20, 20, 0.4}), upright());
  EXPECT_EQ(cost.layers, 2);
  EXPECT_EQ(cost.changes, 2);
  EXPECT_NEAR(cost.secondG, 20 * 20 * 0.4 * kDensityGPerMm3, 0.01 * 20 * 20 * 0.4 * kDensityGPerMm3);
  EXPECT_NEAR(cost.firstWasteG, 100 * kDensityGPerMm3, 1e-12);
  EXPECT_NEAR(cost.secondWasteG, 100 * kDensityGPerMm3, 1e-12);
  EXPECT_DOUBLE_EQ(cost.wasteMinutes, 1);
}

TEST(ColourChanges, ACodeInTheMiddleCostsAChangeBack) {
  // Three layers of both colours: first, second; second, first; first, second; and the first again above them.
  const ColourCost cost = colourCost(block({0, 0, 0}, {30, 30, 4}), block({5, 5, 1}, {20, 20, 0.6}), upright());
  EXPECT_EQ(cost.layers, 3);
  EXPECT_EQ(cost.changes, 4);
  EXPECT_DOUBLE_EQ(cost.firstWasteG, cost.secondWasteG);
}

TEST(ColourChanges, ACodeOnAWallCostsAChangeForEachLayer) {
  const ColourCost cost = colourCost(block({0, 0, 0}, {40, 4, 40}), block({5, 0, 5}, {30, 0.8, 30}), upright());
  EXPECT_EQ(cost.layers, 150);
  EXPECT_EQ(cost.changes, 150);
  EXPECT_NEAR(cost.wasteG(), 150 * 100 * kDensityGPerMm3, 1e-9);
}

TEST(ColourChanges, AWipeTowerCarriesThePurgesUpToTheLastChange) {
  // PrusaSlicer 2.5 by default, purging 250 mm³ a change, on a cylinder 120 mm high (bench/colour_changes.mjs): with
  // the code on top, of 600 layers the last two have a change; lying, of 201 layers the last 100.
  const auto towerMm3 = [](const Mesh& body, const Mesh& inlay) {
    ColourPrint print = upright();
    print.change.purgeMm3 = 250;
    return colourCost(body, inlay, print).towerG / kDensityGPerMm3;
  };
  const double onTop = towerMm3(block({0, 0, 0}, {30, 30, 120}), block({5, 5, 119.6}, {20, 20, 0.4}));
  EXPECT_NEAR(onTop, 28145 - 2 * 250, 0.06 * onTop);
  const double lying = towerMm3(block({0, 0, 0}, {30, 30, 40.2}), block({5, 0, 20.2}, {20, 0.8, 20}));
  EXPECT_NEAR(lying, 32031 - 100 * 250, 0.06 * lying);
  // A code on the bottom: a solid layer with its brim, where it is more than a purge, and one with a wall.
  const double below = towerMm3(block({0, 0, 0}, {30, 30, 120}), block({5, 5, 0}, {20, 20, 0.4}));
  EXPECT_NEAR(below, 64 * 26.79 * 0.2 - 250 + 0.0914 * 2 * 82.79, 0.5);
}

TEST(ColourChanges, TheBuildDirectionDecides) {
  const Mesh body = block({0, 0, 0}, {40, 4, 40}), inlay = block({5, 0, 5}, {30, 0.8, 30});
  // Lying on its back, the wall's four layers of code come last; on its face they come first.
  const ColourCost up = colourCost(body, inlay, upright({0, -2, 0})),
                   down = colourCost(body, inlay, upright({0, 1, 0}));
  EXPECT_EQ(up.layers, 4);
  EXPECT_EQ(up.changes, 4);
  EXPECT_EQ(down.layers, 4);
  EXPECT_EQ(down.changes, 4);
}

TEST(ColourChanges, AWholeLayerOfTheSecondColourNeedsNoChangeWithinIt) {
  // A lid of the second colour: one change where it begins.
  const ColourCost cost = colourCost(block({0, 0, 0}, {20, 20, 2}), block({0, 0, 2}, {20, 20, 1}), upright());
  EXPECT_EQ(cost.layers, 5);
  EXPECT_EQ(cost.changes, 1);
  EXPECT_EQ(cost.firstWasteG, 0);
}

TEST(ColourChanges, SecondColourTooThinToPrintIsNone) {
  const ColourCost cost = colourCost(block({0, 0, 0}, {40, 4, 40}), block({5, 0, 5}, {30, 0.04, 30}), upright());
  EXPECT_EQ(cost.layers, 0);
  EXPECT_EQ(cost.changes, 0);
}

TEST(ColourChanges, PaintCountsDownToItsDepth) {
  const Mesh body = block({0, 0, 0}, {30, 30, 10});
  std::vector<std::uint32_t> top, side;
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t) {
    if (triangleNormal(body, t).z > 0.5) top.push_back(t);
    if (triangleNormal(body, t).x > 0.5) side.push_back(t);
  }
  const ColourCost above = colourCost(body, PaintedTriangles{top, 0.4}, upright());
  EXPECT_EQ(above.layers, 2);
  EXPECT_EQ(above.changes, 2);
  EXPECT_NEAR(above.secondG, 30 * 30 * 0.4 * kDensityGPerMm3, 1e-9);
  const ColourCost aside = colourCost(body, PaintedTriangles{side, 0.9}, upright());
  EXPECT_EQ(aside.layers, 50);
  EXPECT_EQ(aside.changes, 50);
}

TEST(ColourChanges, OneColourCostsNothing) {
  const Mesh body = block({0, 0, 0}, {30, 30, 2});
  EXPECT_EQ(colourCost(body, Mesh{}, upright()), ColourCost{});
  EXPECT_EQ(colourCost(body, PaintedTriangles{}, upright()), ColourCost{});
}

TEST(ColourChanges, OnlyFilamentIsChanged) {
  for (const NamedPrinter& named : namedPrinters()) {
    const auto change = usualFilamentChange(named.printer);
    EXPECT_EQ(change.has_value(), named.printer.technique == PrintTechnique::Filament) << named.name;
    if (change) {
      EXPECT_GE(change->purgeMm3, kLeastPurgeMm3);
    }
  }
}

}  // namespace
}  // namespace qrelief
