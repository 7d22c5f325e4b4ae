// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_raster.h"

#include <cmath>

#include "render/gpu_surface.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr int kTexels = 96;

class SurfaceRasterTest : public GlTest {
 protected:
  /// Returns the share of texels where the raster and the GPU differ by more than 1° or 0.01 mm.
  static double differingShare(const Mesh& mesh, const ProjectionFrame& frame, double extentMm) {
    auto pass = GeometryPass::create();
    if (!pass) return 1;
    const GpuSurface gpu(std::make_shared<const GeometryPass>(std::move(*pass)), GpuMesh(mesh, vertexNormals(mesh)));
    const MapWindow window{extentMm, kTexels};
    const auto rendered = gpu.render(frame, window);
    const std::vector<float> drawn = SurfaceRaster(mesh).draw(frame, window);
    EXPECT_TRUE(rendered.has_value());
    EXPECT_EQ(rendered->size(), drawn.size());
    std::size_t differing = 0, shown = 0;
    for (std::size_t i = 0; i < drawn.size(); i += 4) {
      const Vec3 a(drawn[i], drawn[i + 1], drawn[i + 2]);
      const Vec3 b((*rendered)[i], (*rendered)[i + 1], (*rendered)[i + 2]);
      if (a != Vec3(0)) ++shown;
      const bool same = (a == Vec3(0)) == (b == Vec3(0)) && glm::length(a - b) < 0.0175 &&
                        std::abs(drawn[i + 3] - (*rendered)[i + 3]) < 0.01f;
      if (!same) ++differing;
    }
    EXPECT_GT(shown, drawn.size() / 4 / 20) << "it looks past the model";
    const std::size_t texels = drawn.size() / 4;
    return static_cast<double>(differing) / static_cast<double>(texels);
  }
};

TEST_F(SurfaceRasterTest, AgreesWithTheGpu) {
  const ProjectionFrame above = makeFrame({0, 0, 30}, {0, 0, 1}, {0, 1, 0}, 250);
  const ProjectionFrame aside = makeFrame({20, 10, 15}, {2, 1, 1}, {0, 0, 1}, 250);
  EXPECT_LT(differingShare(shapes::box({60, 50, 60}), above, 80), 0.01);
  EXPECT_LT(differingShare(shapes::box({60, 50, 60}), aside, 120), 0.02);
  EXPECT_LT(differingShare(shapes::icosphere(30, 4), above, 70), 0.02);
  EXPECT_LT(differingShare(shapes::bumpySphere(30, 3, 6, 6), aside, 60), 0.05);
  EXPECT_LT(differingShare(shapes::torus(40, 12, 64, 32), aside, 150), 0.05);
}

TEST_F(SurfaceRasterTest, ClipsAFacetThatReachesBehindTheEye) {
  // A wall of two facets runs along the line of sight, to 500 mm beyond the eye.
  const Mesh wall = shapes::translated(shapes::box({40, 40, 2000}), {60, 0, 0});
  EXPECT_LT(differingShare(wall, makeFrame({0, 0, 0}, {-0.2, 0, 1}, {0, 1, 0}, 250), 300), 0.02);
}

TEST_F(SurfaceRasterTest, IsEmptyBesideTheModel) {
  const std::vector<float> map =
      SurfaceRaster(shapes::box({10, 10, 10})).draw(makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 250), {100, kTexels});
  EXPECT_EQ(std::vector<float>(map.begin(), map.begin() + 4), std::vector<float>(4, 0.0f));
  const std::size_t middle = 4 * static_cast<std::size_t>(kTexels / 2 * kTexels + kTexels / 2);
  EXPECT_FLOAT_EQ(map[middle + 2], 1);
  EXPECT_FLOAT_EQ(map[middle + 3], 5);
}

}  // namespace
}  // namespace qrelief
