// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace qrelief {

/// web/generated/settings.js: what the page knows of the settings, with types: kinds, units, ranges, defaults, choices,
/// and the labels in both languages.
std::string settingsModule();

}  // namespace qrelief
