// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace qrelief {

/// Returns web/generated/settings.js, the page's description of the settings, with types: kinds, units, ranges,
/// defaults and choices.
std::string settingsModule();

}  // namespace qrelief
