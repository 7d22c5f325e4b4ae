// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/frontal_reading.h"

#include <algorithm>

#include "verification/reader_view.h"
#include "verification/reading_variants.h"
#include "verification/resample.h"

namespace qrelief {
namespace {

constexpr double kNoise = 0.02;

}  // namespace

std::vector<GreyImage> frontalPictures(const std::vector<float>& luminance, int width, double pixelsPerModule) {
  std::vector<GreyImage> pictures;
  std::uint64_t seed = 0;
  for (const FrontalView& view : kFrontalViews) {
    const double pixels = pixelsPerModule * view.pixelsPerModule / kFrontalViews.front().pixelsPerModule;
    const double coarser = std::max(1.0, pixelsPerModule / std::min(pixels, view.pixelsPerModule));
    const double made = pixelsPerModule / coarser;
    const GreyImage picture =
        photograph(resampled(luminance, width, coarser, view.phase), resampledWidth(width, coarser),
                   {.blurPx = view.blurModules * made, .noise = kNoise, .strayLight = kStrayLight, .seed = ++seed});
    for (GreyImage& variant : readingVariants(picture, made)) pictures.push_back(std::move(variant));
  }
  return pictures;
}

}  // namespace qrelief
