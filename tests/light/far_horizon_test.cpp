// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/far_horizon.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "light/height_light.h"
#include "light/height_maps.h"

namespace qrelief {
namespace {

TEST(FarHorizon, AWallBesideTheMapDimsTheCellsThatFaceIt) {
  // A wall of height h at distance x, infinitely long, next to an open plane: V = (1 + x / √(x² + h²)) / 2.
  const double eye = 20000, wallHeight = 10, distance = 12;
  HeightMap around = planeMap(512, 200.0 / 512, eye);
  for (int row = 0; row < around.size; ++row)
    for (int column = 0; column < around.size; ++column)
      if ((column + 0.5 - around.size / 2.0) * around.patchMm > distance)
        around.height[static_cast<std::size_t>(row * around.size + column)] =
            static_cast<float>(eye * wallHeight / (eye - wallHeight));
  const HeightMap map = planeMap(32, 0.25, eye);
  const HeightLight light(map, farHorizonOf(map, &around, 1, 8));
  std::vector<Received> received;
  light.measure({.sampling = {2, 32}}, {}, received);
  const Received& middle = received[16 * 32 + 16];
  EXPECT_NEAR(middle.sky, (1 + distance / std::hypot(distance, wallHeight)) / 2, 0.02);
  EXPECT_NEAR(middle.pastWalls, 1, 1e-4);
}

TEST(FarHorizon, OfAPlaneIsThePlaneItself) {
  const HeightMap map = planeMap(32, 0.5, 250);
  const FarHorizon far = farHorizonOf(map, nullptr, 1, 4);
  ASSERT_EQ(far.cotangents.size(), 16u * FarHorizon::kDirections);
  for (int place = 0; place < 16; ++place) {
    const double x = (place % 4 * 8 + 4.5 - 16) * 0.5, y = (place / 4 * 8 + 4.5 - 16) * 0.5;
    // Towards the right, the line of sight leans by x over the distance to the line.
    EXPECT_NEAR(far.cotangents[static_cast<std::size_t>(place)], -x / std::hypot(250, y), 1e-5) << place;
  }
}

TEST(FarHorizon, ANarrowTowerHidesALampBetweenTheDirections) {
  // A tower of 2 by 2 mm and 30 mm high stands at (40, 7): at 10° from the map's right.
  const double eye = 20000;
  HeightMap around = planeMap(512, 200.0 / 512, eye);
  for (int row = 0; row < around.size; ++row)
    for (int column = 0; column < around.size; ++column) {
      const double x = (column + 0.5 - around.size / 2.0) * around.patchMm;
      const double y = (row + 0.5 - around.size / 2.0) * around.patchMm;
      if (std::abs(x - 40) < 1 && std::abs(y - 7) < 1)
        around.height[static_cast<std::size_t>(row * around.size + column)] = 30;
    }
  const HeightMap map = planeMap(32, 0.25, eye);
  const auto lampAt = [&](double azimuthDeg, double elevationDeg) {
    const std::vector<DirectionalLight> lamps = {
        {.azimuthDeg = azimuthDeg, .elevationDeg = elevationDeg, .strength = 1}};
    const HeightLight light(map, farHorizonOf(map, &around, 1, 16, lamps));
    std::vector<Received> received;
    light.measure({.sampling = {2, 12}, .lamps = lamps}, {}, received);
    return static_cast<double>(received[16 * 32 + 16].lampsUncarved);
  };
  EXPECT_EQ(lampAt(std::atan2(7.0, 40.0) * 180 / std::numbers::pi, 30), 0);
  EXPECT_NEAR(lampAt(15, 30), 0.5, 1e-3);
  EXPECT_NEAR(lampAt(std::atan2(7.0, 40.0) * 180 / std::numbers::pi, 45), std::sqrt(0.5), 1e-3);
}

}  // namespace
}  // namespace qrelief
