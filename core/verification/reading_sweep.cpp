// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/reading_sweep.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "qr/module_pattern.h"
#include "qr/symbol.h"
#include "verification/reader_view.h"
#include "verification/reading_variants.h"
#include "verification/resample.h"
#include "verification/view_trials.h"

namespace qrelief {
namespace {

constexpr double kPhoneBlurPx = 0.6;
constexpr std::array kBlurs = {0.1, 0.2, 0.3, 0.4, 0.5};

std::vector<ReadingView> plannedViews(const SweepOptions& options) {
  std::vector<ReadingView> views;
  for (const FrontalView& view : kFrontalViews)
    views.push_back({.lamp = options.underLamps,
                     .pixelsPerModule = view.pixelsPerModule,
                     .phase = view.phase,
                     .blurModules = view.blurModules});
  if (!options.ranges) return views;
  for (const double distance : kDistancesPx)
    views.push_back(
        {.test = ReadingTest::Distance, .pixelsPerModule = distance, .blurModules = kPhoneBlurPx / distance});
  for (const double blur : kBlurs) views.push_back({.test = ReadingTest::Blur, .blurModules = blur});
  for (const double noise : {0.05, 0.1}) views.push_back({.test = ReadingTest::Noise, .noise = noise});
  for (const double exposure : {0.3, 1.2}) views.push_back({.test = ReadingTest::Exposure, .exposure = exposure});
  for (const double blur : {0.07, 0.2}) views.push_back({.test = ReadingTest::Lamp, .lamp = true, .blurModules = blur});
  for (ReadingView& view : views) view.lamp = view.lamp || options.underLamps;
  for (const double tilt : kTiltsDeg)
    for (const double azimuth : kAzimuthsDeg)
      for (const bool lamp : {false, true})
        if (lamp || !options.underLamps)
          views.push_back({.test = ReadingTest::Tilt, .lamp = lamp, .tiltDeg = tilt, .azimuthDeg = azimuth});
  return views;
}

/// Returns the last value, counted from the first, up to which everything reads.
template <class Reads, std::size_t Count>
std::optional<double> lastReading(const std::array<double, Count>& values, const Reads& reads) {
  std::optional<double> last;
  for (const double value : values) {
    if (!reads(value)) break;
    last = value;
  }
  return last;
}

}  // namespace

std::string_view readingTestName(ReadingTest test) {
  constexpr std::array<std::string_view, 7> kNames = {"frontal", "lamp",  "tilt",    "distance",
                                                      "blur",    "noise", "exposure"};
  return kNames[static_cast<std::size_t>(test)];
}

ReadingSweep::ReadingSweep(const BakedLight& light, const ProjectionFrame& frame, int modules, double symbolMm,
                           std::string text, std::vector<Decoder> decoders, const SweepOptions& options)
    : light_(&light),
      frame_(frame),
      modules_(modules),
      symbolMm_(symbolMm),
      text_(std::move(text)),
      decoders_(std::move(decoders)),
      options_(options),
      views_(plannedViews(options)) {
  assert(!decoders_.empty());
}

BottomUp<float> ReadingSweep::luminanceOf(const ReadingView& view) {
  if (seenTilt_ != view.tiltDeg || seenAzimuth_ != view.azimuthDeg) {
    const ProjectionFrame camera = view.tiltDeg > 0 ? tilted(frame_, view.tiltDeg, view.azimuthDeg) : frame_;
    seen_ = light_->picture(camera, kBakedPixels * (modules_ + 2 * kPictureMarginModules),
                            symbolMm_ / modules_ / kBakedPixels, options_.ink ? &*options_.ink : nullptr);
    seenTilt_ = view.tiltDeg;
    seenAzimuth_ = view.azimuthDeg;
  }
  BottomUp<float> luminance = seen_.sky;
  if (view.lamp)
    for (std::size_t i = 0; i < luminance.size(); ++i) luminance[i] += seen_.added[i];
  return luminance;
}

void ReadingSweep::read(ReadingView& view, const GreyImage& picture) {
  for (const GreyImage& variant : readingVariants(picture, view.pixelsPerModule)) {
    for (const Decoder& decoder : decoders_) {
      // Only frontal pictures count their successes; all others stop at the first one.
      if (view.test != ReadingTest::Frontal && view.read()) return;
      ++view.tries;
      const auto decoded = decoder(variant);
      if (!decoded) continue;
      if (decoded->text != text_) {
        view.otherText = decoded->text;
      } else if (decoded->mirrored) {
        view.mirrored = true;
      } else {
        ++view.reads;
        if (cornerError_ || view.tiltDeg > 0) continue;
        // Corners in modules from the picture's middle, x to the right and y down, clockwise from the top left.
        const double modules = static_cast<double>(picture.width) / view.pixelsPerModule / variant.width;
        double error = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          const Vec2 at = decoded->corners[k] * modules - Vec2(picture.width / view.pixelsPerModule / 2);
          const Vec2 expected =
              Vec2(k == 1 || k == 2 ? 0.5 : -0.5, k >= 2 ? 0.5 : -0.5) * static_cast<double>(modules_);
          error = std::max(error, glm::length(at - expected));
        }
        cornerError_ = error;
      }
    }
  }
}

bool ReadingSweep::step() {
  assert(next_ < views_.size());
  ReadingView& view = views_[next_++];
  const BottomUp<float> luminance = luminanceOf(view);
  const double coarser = kBakedPixels / view.pixelsPerModule;
  const GreyImage picture =
      photograph(resampled(luminance, coarser, view.phase), {.blurPx = view.blurModules * view.pixelsPerModule,
                                                             .noise = view.noise,
                                                             .strayLight = kStrayLight,
                                                             .exposure = view.exposure,
                                                             .seed = next_});
  read(view, picture);
  return next_ == views_.size();
}

ReadingSummary ReadingSweep::summary() const {
  ReadingSummary summary;
  for (const ReadingView& view : views_) {
    summary.mirrored |= view.mirrored;
    if (summary.otherText.empty()) summary.otherText = view.otherText;
    if (view.test != ReadingTest::Frontal) continue;
    summary.frontal.tries += view.tries;
    summary.frontal.reads += view.reads;
  }
  summary.cornerErrorModules = cornerError_;
  if (!options_.ranges) return summary;
  const auto allRead = [&](ReadingTest test, const auto& chosen) {
    return std::all_of(views_.begin(), views_.end(),
                       [&](const ReadingView& v) { return v.test != test || !chosen(v) || v.read(); });
  };
  const auto tilt = [&](bool lamp) -> std::optional<double> {
    const bool frontal =
        lamp ? allRead(ReadingTest::Lamp, [](const ReadingView&) { return true; }) : summary.frontal.enough();
    if (!frontal) return std::nullopt;
    return lastReading(kTiltsDeg,
                       [&](double deg) {
                         return allRead(ReadingTest::Tilt,
                                        [&](const ReadingView& v) { return v.lamp == lamp && v.tiltDeg == deg; });
                       })
        .value_or(0);
  };
  if (!options_.underLamps) summary.tiltDeg = tilt(false);
  summary.tiltDegLamp = tilt(true);
  summary.pixelsPerModule = lastReading(kDistancesPx, [&](double pixels) {
    return allRead(ReadingTest::Distance, [&](const ReadingView& v) { return v.pixelsPerModule == pixels; });
  });
  summary.blurModules = lastReading(kBlurs, [&](double blur) {
    return allRead(ReadingTest::Blur, [&](const ReadingView& v) { return v.blurModules == blur; });
  });
  return summary;
}

Grid<double> submoduleMeans(const BottomUp<float>& picture, int modules, int pixelsPerModule) {
  constexpr int kN = kSubmodulesPerModule;
  assert(pixelsPerModule >= kN);
  const int edge = kN * (modules + 2 * kQuietZoneModules);
  assert(picture.rows() == pixelsPerModule * (modules + 2 * kPictureMarginModules));
  const int margin = pixelsPerModule * (kPictureMarginModules - kQuietZoneModules);
  // A submodule's first pixel from the margin is the first whose middle lies in it.
  const auto first = [&](int submodule) { return (2 * submodule * pixelsPerModule + kN - 1) / (2 * kN); };
  Grid<double> means(edge, edge);
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column) {
      double sum = 0;
      for (int y = first(row); y < first(row + 1); ++y)
        for (int x = first(column); x < first(column + 1); ++x)
          sum += static_cast<double>(picture.at(picture.rows() - 1 - margin - y, margin + x));
      means.at(row, column) = sum / ((first(row + 1) - first(row)) * (first(column + 1) - first(column)));
    }
  return means;
}

Grid<double> submoduleLight(const BakedLight& light, int modules, bool underLamps) {
  const double open = underLamps ? light.openLight() : 1;
  BottomUp<float> picture(light.light().rows(), light.light().columns(), 1);
  for (std::size_t i = 0; i < picture.size(); ++i)
    if (const SurfaceLight& texel = light.light()[i]; texel.sky >= 0)
      picture[i] = static_cast<float>((texel.sky + (underLamps ? texel.lamp : 0)) / open);
  return submoduleMeans(picture, modules);
}

}  // namespace qrelief
