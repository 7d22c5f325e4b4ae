// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/coloured_mesh.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr Colour kRed{255, 0, 0};
using Colours = std::vector<std::optional<Colour>>;

TEST(ColouredMesh, BordersBetweenColoursAreSharp) {
  const Mesh sphere = shapes::icosphere(10, 2);
  DisplayMesh display = splitAtCreases(sphere);
  Colours colours(sphere.triangles.size());
  for (std::size_t t = 0; t < colours.size(); t += 2) colours[t] = kRed;
  const std::vector<Colour> ofVertices = splitAtColours(display, colours);
  ASSERT_EQ(ofVertices.size(), display.mesh.positions.size());
  ASSERT_EQ(display.normals.size(), display.mesh.positions.size());
  for (std::size_t t = 0; t < colours.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(ofVertices[display.mesh.triangles[t][k]], colours[t].value_or(kPlainColour));
      EXPECT_EQ(display.mesh.corner(t, static_cast<int>(k)), sphere.corner(t, static_cast<int>(k)));
    }
}

TEST(ColouredMesh, TheVerticesOfAScanHaveTheMeanOfTheFacetsAround) {
  const Mesh sphere = shapes::icosphere(10, 2);
  DisplayMesh display = splitAtCreases(sphere);
  const std::size_t vertices = display.mesh.positions.size();
  Colours colours;
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t)
    colours.emplace_back(Colour{static_cast<std::uint8_t>(t % 200), 7, 0});
  const std::vector<Colour> ofVertices = splitAtColours(display, colours);
  EXPECT_EQ(display.mesh.positions.size(), vertices);
  int sum = 0, count = 0;
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t)
    for (const std::uint32_t v : sphere.triangles[t])
      if (v == sphere.triangles[0][0]) {
        sum += (*colours[t])[0];
        ++count;
      }
  EXPECT_EQ(ofVertices[display.mesh.triangles[0][0]], (Colour{static_cast<std::uint8_t>(sum / count), 7, 0}));
}

}  // namespace
}  // namespace qrelief
