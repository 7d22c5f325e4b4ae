// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/read_model.h"
#include "pipeline/verify.h"

namespace qrelief::bench {

/// Returns a point of a report.
inline Vec3 vectorOf(const nlohmann::json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

/// Loads a file's mesh in mm, unrepaired; none if the file cannot be read.
inline std::optional<Mesh> loadEngraved(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
  const auto soup = readModel(bytes, path);
  if (!soup) return std::nullopt;
  auto mesh = meshAsFound(*soup, 1);
  if (!mesh) return std::nullopt;
  return std::move(*mesh);
}

/// Returns the mean luminance of every module, row-major from the symbol's top left.
/// @param picture  kBakedPixels a module, with a picture's margin
inline std::vector<double> moduleMeans(const BottomUp<float>& picture, int modules) {
  std::vector<double> means;
  for (int row = 0; row < modules; ++row)
    for (int column = 0; column < modules; ++column) {
      double sum = 0;
      for (int k = 0; k < kBakedPixels * kBakedPixels; ++k) {
        const int y = picture.rows() - 1 - kBakedPixels * (kPictureMarginModules + row) - k / kBakedPixels;
        const int x = kBakedPixels * (kPictureMarginModules + column) + k % kBakedPixels;
        sum += static_cast<double>(picture.at(y, x));
      }
      means.push_back(sum / (kBakedPixels * kBakedPixels));
    }
  return means;
}

}  // namespace qrelief::bench
