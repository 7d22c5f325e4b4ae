// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace qrelief {

class CarveJob;

/// A map that an engraving job worked on, as numbers; row 0 at the bottom.
struct JobMap {
  int width = 0, height = 0, components = 1;
  std::vector<float> values;
};

/// Returns one of the job's maps.
/// @param name  "surface": facet normal (right, up, normal) and height over the QR plane, four components, all zero off
///              the model; "luminance": under a uniform sky; "depths": mm, one texel per submodule; "search-luminance"
///              and "search-depths": luminance and depths in the newest pass of the depth search, one texel per
///              submodule, without the GPU, the luminance with the quiet zone
/// @returns none for another name, and before the job has that map
std::optional<JobMap> jobMap(const CarveJob& job, std::string_view name);

}  // namespace qrelief
