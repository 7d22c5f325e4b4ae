// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "io/write_model.h"

namespace qrelief {

/// Names of Slicer's values, in order. Scripts rely on them.
inline constexpr std::array<std::string_view, 4> kSlicerNames = {"any", "prusa", "orca", "bambu"};

/// Returns none for an unknown name.
constexpr std::optional<Slicer> slicerByName(std::string_view name) {
  for (std::size_t i = 0; i < kSlicerNames.size(); ++i)
    if (kSlicerNames[i] == name) return static_cast<Slicer>(i);
  return {};
}

}  // namespace qrelief
