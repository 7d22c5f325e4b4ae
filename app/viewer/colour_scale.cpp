// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace qrelief {
namespace {

// Equidistant samples of the published scales: viridis and cividis from matplotlib, RdBu from ColorBrewer.
constexpr Rgb8 kViridis[] = {{68, 1, 84},    {72, 40, 120},  {62, 74, 137},  {49, 104, 142}, {38, 130, 142},
                             {31, 158, 137}, {53, 183, 121}, {109, 205, 89}, {180, 222, 44}, {253, 231, 37}};
constexpr Rgb8 kCividis[] = {{0, 32, 77},     {0, 51, 111},    {57, 72, 107},   {87, 92, 109},  {112, 113, 115},
                             {138, 135, 121}, {166, 157, 117}, {196, 181, 108}, {228, 207, 91}, {255, 234, 70}};
constexpr Rgb8 kGrey[] = {{0, 0, 0}, {255, 255, 255}};
constexpr Rgb8 kBlueRed[] = {{5, 48, 97},     {67, 147, 195}, {209, 229, 240}, {247, 247, 247},
                             {253, 219, 199}, {214, 96, 77},  {103, 0, 31}};

std::span<const Rgb8> samplesOf(ColourScale scale) {
  switch (scale) {
    case ColourScale::Viridis:
      return kViridis;
    case ColourScale::Cividis:
      return kCividis;
    case ColourScale::Grey:
      return kGrey;
    case ColourScale::BlueRed:
      break;
  }
  return kBlueRed;
}

}  // namespace

Rgb8 colourAt(ColourScale scale, double share) {
  const std::span<const Rgb8> samples = samplesOf(scale);
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), samples.size() - 2);
  const double rest = place - static_cast<double>(below);
  Rgb8 colour{};
  for (std::size_t k = 0; k < 3; ++k)
    colour[k] = static_cast<std::uint8_t>(std::lround((1 - rest) * samples[below][k] + rest * samples[below + 1][k]));
  return colour;
}

}  // namespace qrelief
