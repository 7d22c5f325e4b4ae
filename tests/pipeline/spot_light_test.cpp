// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/spot_light.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr int kModules = 25;
constexpr double kSymbolMm = 30;

/// Returns a plate with a ridge 4 mm high and 2 mm wide along y.
Mesh ridged(double atX) {
  return shapes::plate(Vec2(80, 80), 6, 80, 4, [=](double x, double) { return std::abs(x - atX) < 1.1 ? 4.0 : 0.0; });
}

double lightOn(const Mesh& mesh, int ring = kLitRingModules, const std::vector<DirectionalLight>& lamps = {}) {
  return unevenLight(SurfaceRaster(mesh), boundingBox(mesh), makeFrame(Vec3(0), Vec3(0, 0, 1), Vec3(0, 1, 0), 250),
                     kSymbolMm, kModules, lamps, ring);
}

TEST(SpotLight, OfAPlaneIsEven) { EXPECT_LT(lightOn(shapes::plate(Vec2(80, 80), 6, 1, 1)), 1e-3); }

TEST(SpotLight, OfASmoothBendIsEven) {
  const Mesh bent = shapes::plate(Vec2(80, 80), 6, 80, 4, [](double x, double) { return -x * x / 100; });
  EXPECT_LT(lightOn(bent), kMostUnevenLight / 2);
}

TEST(SpotLight, OfALampIsUnevenOnABendButNotOnAPlane) {
  const std::vector<DirectionalLight> low = {{.azimuthDeg = 0, .elevationDeg = 20, .strength = 2}};
  const Mesh bent = shapes::plate(Vec2(80, 80), 6, 80, 4, [](double x, double) { return -x * x / 60; });
  EXPECT_LT(lightOn(shapes::plate(Vec2(80, 80), 6, 1, 1), kLitRingModules, low), 1e-3);
  EXPECT_GT(lightOn(bent, kLitRingModules, low), kMostUnevenLight);
  // From along the bend, the lamp lights it evenly.
  EXPECT_LT(lightOn(bent, kLitRingModules, {{.azimuthDeg = 90, .elevationDeg = 20, .strength = 2}}),
            lightOn(bent, kLitRingModules, low) / 2);
}

TEST(SpotLight, BesideARidgeIsUneven) {
  EXPECT_GT(lightOn(ridged(0)), kMostUnevenLight);
  // The ridge stands in the quiet zone, next to the symbol, which reaches 15 mm to each side.
  EXPECT_GT(lightOn(ridged(17)), kMostUnevenLight);
  EXPECT_LT(lightOn(ridged(18.5), 0), lightOn(ridged(18.5)));
  // Farther away the ridge takes a little light from all modules alike.
  EXPECT_LT(lightOn(ridged(30)), kMostUnevenLight / 2);
}

}  // namespace
}  // namespace qrelief
