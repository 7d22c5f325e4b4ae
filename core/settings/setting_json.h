// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "settings/settings.h"

namespace qrelief {

/// Reads a request from a JSON object by key. A missing or null key gives the default (defaultRequest). Numbers and
/// switches are JSON numbers and booleans, a choice is its name, a vector [x, y, z], lamps [{"azimuthDeg",
/// "elevationDeg", "strength"}, …]:
///
///     {"text": "…", "preset": "robust", "size": 35, "minWallMm": 1.2, "quietZone": false}
///
/// The order of the keys does not matter. The centre is not among them.
/// @returns BadUsage naming an unknown key, or the setting whose value is of the wrong kind, and the expected kind;
///          checkSettings() checks ranges
Result<EngraveRequest> requestFromJson(std::string_view json);

/// Writes every setting of a request, so that requestFromJson() gives the same request apart from the centre. An empty
/// setting becomes null.
std::string settingsJson(const EngraveRequest& request);

}  // namespace qrelief
