// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/plate_layout.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace qrelief {
namespace {

double roundedUp(double mm) { return std::ceil(100 * mm) / 100; }

}  // namespace

std::vector<Vec3> plateOffsets(const Box3& box, std::size_t copies, double gapMm) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(copies))));
  const Vec3 size = box.size();
  std::vector<Vec3> offsets;
  for (std::size_t i = 0; i < copies; ++i) {
    const std::size_t column = i % columns, row = i / columns;
    offsets.emplace_back(roundedUp(static_cast<double>(column) * (size.x + gapMm) - box.min.x),
                         roundedUp(static_cast<double>(row) * (size.y + gapMm) - box.min.y), roundedUp(-box.min.z));
  }
  return offsets;
}

std::string plateName(std::size_t plate, std::size_t plates) {
  return fmt::format("plate-{:0{}}.3mf", plate + 1, std::max<std::size_t>(3, std::to_string(plates).size()));
}

}  // namespace qrelief
