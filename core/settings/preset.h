// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace qrelief {

/// How much is carved so that the code reads, by name. In simulated pictures, `thick-plus` modules were read by more
/// readers than `square` ones at the same mean depth, so no preset changes the patterns; they differ in the contrast.
/// Codes with whole finders take less of it, see pipeline/default_patterns.h.
enum class Preset : std::uint8_t {
  Shallow,   ///< little depth, for reading from the front in even light
  Balanced,  ///< for a lamp beside it, too; the default
  Robust     ///< deeper, for less even light
};

/// How much darker carved submodules must be.
double presetContrast(Preset preset);

/// The next deeper one, if there is one.
std::optional<Preset> deeperPreset(Preset preset);

/// "shallow", "balanced" or "robust", and back; empty if there is no such preset.
const char* presetName(Preset preset);
std::optional<Preset> presetByName(std::string_view name);

}  // namespace qrelief
