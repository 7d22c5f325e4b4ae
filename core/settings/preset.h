// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace qrelief {

/// Named depths of carving. In simulated pictures, more decoders read `thick-plus` modules than `square` ones at the
/// same mean depth, so all presets have the same patterns; they differ in contrast. Codes with whole finder patterns
/// use less contrast, see pipeline/default_patterns.h.
enum class Preset : std::uint8_t {
  Shallow,   ///< little depth, for reading from the front in even light
  Balanced,  ///< also for light from a lamp nearby; the default
  Robust     ///< deeper, for less even light
};

/// Returns the fraction by which carved submodules must be darker than their surroundings.
double presetContrast(Preset preset);

/// Returns the next deeper preset, if there is one.
std::optional<Preset> deeperPreset(Preset preset);

/// Convert a preset to "shallow", "balanced" or "robust", and back; empty if there is no such preset.
const char* presetName(Preset preset);
std::optional<Preset> presetByName(std::string_view name);

}  // namespace qrelief
