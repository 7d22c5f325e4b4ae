// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace qrelief {

/// Returns the files messages/*.json, which the build compiles in.
std::span<const char* const> catalogues();

/// Returns the file messages/settings/settings.json, also compiled in.
const char* settingCatalogue();

}  // namespace qrelief
