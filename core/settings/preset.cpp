// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/preset.h"

#include <array>

namespace qrelief {
namespace {

struct Settings {
  const char* name;
  double contrast;
};
constexpr std::array<Settings, 3> kPresets = {{{"shallow", 0.2}, {"balanced", 0.3}, {"robust", 0.38}}};

}  // namespace

double presetContrast(Preset preset) { return kPresets[static_cast<std::size_t>(preset)].contrast; }

std::optional<Preset> deeperPreset(Preset preset) {
  if (preset == Preset::Robust) return {};
  return preset == Preset::Shallow ? Preset::Balanced : Preset::Robust;
}

const char* presetName(Preset preset) { return kPresets[static_cast<std::size_t>(preset)].name; }

std::optional<Preset> presetByName(std::string_view name) {
  for (const Preset preset : {Preset::Shallow, Preset::Balanced, Preset::Robust})
    if (name == presetName(preset)) return preset;
  return {};
}

}  // namespace qrelief
