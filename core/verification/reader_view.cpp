// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/reader_view.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "render/luminance_pass.h"
#include "verification/baked_light.h"

namespace qrelief {
namespace {

constexpr int kHorizonSamples = 64;
constexpr double kEveryBorderTexels = 8;

/// Of a square picture.
std::vector<double> gaussianBlur(const std::vector<double>& image, int width, double sigma) {
  if (sigma <= 0) return image;
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> kernel;
  double sum = 0;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(std::exp(-k * k / (2 * sigma * sigma)));
    sum += kernel.back();
  }
  const auto pass = [&](const std::vector<double>& in, int stepX, int stepY) {
    std::vector<double> out(in.size());
    for (int y = 0; y < width; ++y) {
      for (int x = 0; x < width; ++x) {
        double value = 0;
        for (int k = -reach; k <= reach; ++k) {
          const int sx = std::clamp(x + k * stepX, 0, width - 1);
          const int sy = std::clamp(y + k * stepY, 0, width - 1);
          value += kernel[static_cast<std::size_t>(k + reach)] * in[static_cast<std::size_t>(sy * width + sx)];
        }
        out[static_cast<std::size_t>(y * width + x)] = value / sum;
      }
    }
    return out;
  };
  return pass(pass(image, 1, 0), 0, 1);
}

double srgb(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

}  // namespace

GreyImage photograph(const std::vector<float>& luminance, int width, const CameraOptions& camera) {
  std::vector<double> middle;
  double mean = 0;
  for (int y = width / 5; y < width - width / 5; ++y)
    for (int x = width / 5; x < width - width / 5; ++x) {
      middle.push_back(luminance[static_cast<std::size_t>(y * width + x)]);
      mean += middle.back();
    }
  mean /= static_cast<double>(middle.size());
  const auto bright = middle.begin() + static_cast<std::ptrdiff_t>(middle.size() * 95 / 100);
  std::nth_element(middle.begin(), bright, middle.end());
  const double exposure = camera.exposure / std::max(*bright, 1e-6);

  std::vector<double> image(luminance.size());
  for (std::size_t i = 0; i < image.size(); ++i)
    image[i] = exposure * ((1 - camera.strayLight) * luminance[i] + camera.strayLight * mean);
  image = gaussianBlur(image, width, camera.blurPx);

  Random random(camera.seed);
  GreyImage picture{width, width, std::vector<std::uint8_t>(image.size())};
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      double value = image[static_cast<std::size_t>((width - 1 - y) * width + x)];
      if (camera.noise > 0)
        value += random.normal() * camera.noise * std::sqrt(std::max(value, 0.05) / camera.exposure);
      picture.pixels[static_cast<std::size_t>(y * width + x)] =
          static_cast<std::uint8_t>(std::lround(255 * srgb(value)));
    }
  }
  return picture;
}

GreyImage blurred(const GreyImage& image, double sigmaPx) {
  const std::vector<double> blurredPixels =
      gaussianBlur(std::vector<double>(image.pixels.begin(), image.pixels.end()), image.width, sigmaPx);
  GreyImage result{image.width, image.height, {}};
  for (const double pixel : blurredPixels) result.pixels.push_back(static_cast<std::uint8_t>(std::lround(pixel)));
  return result;
}

Result<ReaderView> renderReaderView(const GeometryPass& pass, const GpuMesh& mesh, const ProjectionFrame& frame,
                                    const ReaderViewOptions& options,
                                    std::shared_ptr<const LuminancePrograms> programs) {
  auto maps = pass.render(mesh, frame, {options.extentMm, options.texels});
  if (!maps) return tl::unexpected(maps.error());
  const auto around = pass.render(mesh, frame, surroundingsOf(maps->window, frame, mesh.box()));
  if (!around) return tl::unexpected(around.error());
  const LuminanceOptions light{.cellTexels = 1,
                               .sampling = {1, 3},
                               .turnSlices = true,
                               .radiusMm = options.radiusMm,
                               .everyBorderMm = static_cast<float>(kEveryBorderTexels * maps->window.texelMm()),
                               .reliefMm = options.reliefMm,
                               .horizonSamples = kHorizonSamples,
                               .horizonStartMm = options.radiusMm,
                               .albedo = options.albedo,
                               .lights = options.lights};
  auto luminancePass = LuminancePass::create(*maps, &*around, frame.eyeDistance, light, std::move(programs));
  if (!luminancePass) return tl::unexpected(luminancePass.error());
  luminancePass->run();
  std::vector<float> luminance = luminancePass->readLuminance();
  const std::vector<float> surface = maps->framebuffer.readRgba(0);
  for (std::size_t i = 0; i < luminance.size(); ++i)
    if (surface[4 * i + 2] <= 0) luminance[i] = kBackground;

  ReaderView view;
  view.clean = photograph(luminance, options.texels);
  view.picture = photograph(
      luminance, options.texels,
      {.blurPx = options.blurPx * options.texels / 700, .noise = options.noise, .strayLight = options.strayLight});
  view.luminance = std::move(luminance);
  return view;
}

}  // namespace qrelief
