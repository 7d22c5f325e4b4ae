// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/reader_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.h"
#include "render/luminance_pass.h"
#include "verification/baked_light.h"

namespace qrelief {
namespace {

constexpr int kHorizonSamples = 64;
constexpr double kEveryBorderTexels = 8;

/// Blurs a square picture; border pixels continue outwards.
std::vector<double> gaussianBlur(const std::vector<double>& image, int width, double sigma) {
  if (sigma <= 0) return image;
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> kernel;
  double sum = 0;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(std::exp(-k * k / (2 * sigma * sigma)));
    sum += kernel.back();
  }
  const auto edge = static_cast<std::size_t>(width);
  std::vector<double> across(image.size()), out(image.size()), row(edge + 2 * static_cast<std::size_t>(reach));
  for (std::size_t y = 0; y < edge; ++y) {
    const double* const in = &image[y * edge];
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = in[std::clamp(static_cast<int>(x) - reach, 0, width - 1)];
    double* const to = &across[y * edge];
    for (std::size_t k = 0; k < kernel.size(); ++k)
      for (std::size_t x = 0; x < edge; ++x) to[x] += kernel[k] * row[x + k];
    for (std::size_t x = 0; x < edge; ++x) to[x] /= sum;
  }
  for (std::size_t y = 0; y < edge; ++y) {
    double* const to = &out[y * edge];
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const int from = std::clamp(static_cast<int>(y + k) - reach, 0, width - 1);
      const double* const in = &across[static_cast<std::size_t>(from) * edge];
      for (std::size_t x = 0; x < edge; ++x) to[x] += kernel[k] * in[x];
    }
    for (std::size_t x = 0; x < edge; ++x) to[x] /= sum;
  }
  return out;
}

double srgb(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// Converts linear values to greys: 255 · srgb(), rounded.
class GreyScale {
 public:
  GreyScale() {
    for (std::size_t k = 0; k < first_.size(); ++k)
      first_[k] = static_cast<std::uint8_t>(std::lround(255 * srgb(static_cast<double>(k) / kSteps)));
    for (std::size_t grey = 1; grey < least_.size(); ++grey) {  // by bisection
      double low = 0, high = 1;
      for (int k = 0; k < 50; ++k) {
        const double middle = (low + high) / 2;
        (std::lround(255 * srgb(middle)) < static_cast<long>(grey) ? low : high) = middle;
      }
      least_[grey] = high;
    }
  }
  std::uint8_t operator()(double linear) const {
    const double v = std::clamp(linear, 0.0, 1.0);
    std::size_t grey = first_[static_cast<std::size_t>(v * kSteps)];
    while (grey < 255 && v >= least_[grey + 1]) ++grey;
    return static_cast<std::uint8_t>(grey);
  }

 private:
  static constexpr int kSteps = 4096;
  std::array<std::uint8_t, kSteps + 1> first_{};  // grey at the start of each step
  std::array<double, 256> least_{};               // least linear value of each grey
};

}  // namespace

GreyImage photograph(const BottomUp<float>& luminance, const CameraOptions& camera) {
  const int width = luminance.columns();
  std::vector<double> middle;
  double mean = 0;
  for (int y = width / 5; y < width - width / 5; ++y)
    for (int x = width / 5; x < width - width / 5; ++x) {
      middle.push_back(luminance.at(y, x));
      mean += middle.back();
    }
  mean /= static_cast<double>(middle.size());
  const auto bright = middle.begin() + static_cast<std::ptrdiff_t>(middle.size() * 95 / 100);
  std::nth_element(middle.begin(), bright, middle.end());
  const double exposure = camera.exposure / std::max(*bright, 1e-6);

  std::vector<double> exposed;
  for (const float value : luminance)
    exposed.push_back(exposure * ((1 - camera.strayLight) * value + camera.strayLight * mean));
  const BottomUp<double> image(width, width, gaussianBlur(exposed, width, camera.blurPx));

  static const GreyScale kGreys;
  Random random(camera.seed);
  GreyImage picture{width, width, {}};
  for (int row = width - 1; row >= 0; --row) {
    for (int column = 0; column < width; ++column) {
      double value = image.at(row, column);
      if (camera.noise > 0)
        value += random.normal() * camera.noise * std::sqrt(std::max(value, 0.05) / camera.exposure);
      picture.pixels.push_back(kGreys(value));
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

ReaderView photographed(BottomUp<float> luminance, const ReaderViewOptions& options) {
  ReaderView view;
  view.clean = photograph(luminance);
  view.picture = photograph(
      luminance,
      {.blurPx = options.blurPx * options.texels / 700, .noise = options.noise, .strayLight = options.strayLight});
  view.luminance = std::move(luminance);
  return view;
}

Result<ReaderView> renderReaderView(const GeometryPass& pass, const GpuMesh& mesh, const ProjectionFrame& frame,
                                    const ReaderViewOptions& options,
                                    std::shared_ptr<const LuminancePrograms> programs) {
  auto maps = pass.render(mesh, frame, {options.extentMm, options.texels});
  QRELIEF_TRY(maps);
  const auto around = pass.render(mesh, frame, surroundingsOf(maps->window, frame, mesh.box()));
  QRELIEF_TRY(around);
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
  QRELIEF_TRY(luminancePass);
  luminancePass->run();
  BottomUp<float> luminance(options.texels, options.texels, luminancePass->readLuminance());
  const std::vector<float> surface = maps->framebuffer.readRgba(0);
  for (std::size_t i = 0; i < luminance.size(); ++i)
    if (surface[4 * i + 2] <= 0) luminance[i] = kBackground;

  return photographed(std::move(luminance), options);
}

}  // namespace qrelief
