// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "settings/settings.h"

namespace qrelief {

/// A request from an object by key; what is missing or null has its default (defaultRequest). A number and a switch
/// are such, a choice is its name, a vector [x, y, z], lamps [{"azimuthDeg", "elevationDeg", "strength"}, …]:
///
///     {"text": "…", "preset": "robust", "size": 35, "minWallMm": 1.2, "quietZone": false}
///
/// The order of the keys does not matter. The centre is not among them.
/// @returns BadUsage naming a key that is no setting, or the setting whose value is of the wrong kind, and what was
///          expected; ranges are checkSettings()'s business
Result<EngraveRequest> requestFromJson(std::string_view json);

/// Every setting of a request, so that requestFromJson() gives the same request, centre aside. What is set
/// to nothing is null.
std::string settingsJson(const EngraveRequest& request);

}  // namespace qrelief
