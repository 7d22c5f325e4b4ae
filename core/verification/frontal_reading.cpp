// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/frontal_reading.h"

#include <algorithm>

#include "base/parallel.h"
#include "verification/reader_view.h"
#include "verification/reading_variants.h"
#include "verification/resample.h"

namespace qrelief {
namespace {

constexpr double kNoise = 0.02;

}  // namespace

std::vector<GreyImage> frontalPictures(const BottomUp<float>& luminance, double pixelsPerModule) {
  std::array<std::vector<GreyImage>, kFrontalViews.size()> variants;
  parallelFor(kFrontalViews.size(), [&](std::size_t k) {
    const FrontalView& view = kFrontalViews[k];
    const double pixels = pixelsPerModule * view.pixelsPerModule / kFrontalViews.front().pixelsPerModule;
    const double coarser = std::max(1.0, pixelsPerModule / std::min(pixels, view.pixelsPerModule));
    const double drawnPixels = pixelsPerModule / coarser;
    const GreyImage picture = photograph(
        resampled(luminance, coarser, view.phase),
        {.blurPx = view.blurModules * drawnPixels, .noise = kNoise, .strayLight = kStrayLight, .seed = k + 1});
    variants[k] = readingVariants(picture, drawnPixels);
  });
  std::vector<GreyImage> pictures;
  for (std::vector<GreyImage>& ofView : variants)
    for (GreyImage& variant : ofView) pictures.push_back(std::move(variant));
  return pictures;
}

}  // namespace qrelief
