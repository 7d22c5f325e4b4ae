// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace qrelief {

/// The files messages/*.json, which the build compiles in.
std::span<const char* const> catalogues();

/// The file messages/settings/settings.json, likewise.
const char* settingCatalogue();

}  // namespace qrelief
