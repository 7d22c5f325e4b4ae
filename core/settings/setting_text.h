// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "base/result.h"
#include "settings/settings.h"

namespace qrelief {

/// A value as it is typed: a number with a decimal point, the name of a choice, `X,Y,Z`, `on` or `off`; a lamp is
/// `AZIMUTH,ELEVATION[,STRENGTH]`, in the order of lampParts(), and each text is one.
/// @param texts  one; of lamps any number
/// @returns BadUsage naming the setting, what was found and what was expected; ranges are checkValue()'s business
Result<SettingValue> valueFromText(const Setting& setting, std::span<const std::string> texts);

/// The same way back, in as few digits as give the number again. Empty for nothing and for no lamps.
std::string valueText(const SettingValue& value);

}  // namespace qrelief
