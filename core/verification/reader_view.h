// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/grid.h"
#include "base/result.h"
#include "light/directional_light.h"
#include "math/frame.h"
#include "render/geometry_pass.h"
#include "render/luminance_pass.h"

namespace qrelief {

/// 8-bit grey picture, row 0 at the top.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Pictures of the carved model as a phone at the eye sees it under a uniform sky and lamps.
struct ReaderView {
  GreyImage picture;  ///< exposed, blurred, with noise and sRGB gamma; for decoding
  GreyImage clean;    ///< without blur and noise; for display
  double pixelsPerModule = 0;
  BottomUp<float> luminance;  ///< linear, of the same width; the pictures are made from it
};

/// Share of light that a phone's lens scatters over the picture.
inline constexpr double kStrayLight = 0.05;

struct ReaderViewOptions {
  double extentMm = 50;  ///< edge of the square on the QR plane that fills the picture
  int texels = 560;      ///< along the edge of the square
  float radiusMm = 4;    ///< reach of the march for pockets
  float reliefMm = 2;    ///< depth of the deepest pocket
  float albedo = 0.7f;
  std::vector<DirectionalLight> lights = {};  ///< in addition to the uniform sky, at most kMaxLights
  double blurPx = 1.0;                        ///< standard deviation, at 700 texels; scales with the size
  double noise = 0.02;                        ///< standard deviation at white, linear
  double strayLight = kStrayLight;            ///< share of light scattered in the lens
};

/// Simulates a phone's pictures of a luminance that was computed elsewhere.
/// @param luminance  linear, options.texels along its edge, 1 = unoccluded
ReaderView photographed(BottomUp<float> luminance, const ReaderViewOptions& options);

/// Renders the mesh itself, to judge the output of the embedding and not the map that the depth search worked on.
Result<ReaderView> renderReaderView(const GeometryPass& pass, const GpuMesh& mesh, const ProjectionFrame& frame,
                                    const ReaderViewOptions& options,
                                    std::shared_ptr<const LuminancePrograms> programs = nullptr);

struct CameraOptions {
  double blurPx = 0;       ///< standard deviation, ≥ 0
  double noise = 0;        ///< standard deviation at white, linear
  double strayLight = 0;   ///< share of light scattered in the lens, 0 … 1
  double exposure = 0.85;  ///< linear value of the 95th percentile of the picture's middle; brighter pixels are clipped
  std::uint64_t seed = 1;  ///< seed of the noise
};

/// Simulates a camera's picture of linear luminance: exposure, stray light, Gaussian blur, shot noise (seeded: the same
/// on every run), sRGB gamma, 8 bits.
/// @param luminance  square
GreyImage photograph(const BottomUp<float>& luminance, const CameraOptions& camera = {});

/// Applies a Gaussian blur; border pixels continue outwards.
/// @param sigmaPx  ≥ 0
GreyImage blurred(const GreyImage& image, double sigmaPx);

}  // namespace qrelief
