// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "base/result.h"
#include "settings/settings.h"

namespace qrelief {

/// Parses a value as a person types it: a number with a decimal point, the name of a choice, `X,Y,Z`; `on`, `true` or
/// `yes`, `off`, `false` or `no`, in capitals, too, as spreadsheets write them. A lamp is
/// `AZIMUTH,ELEVATION[,STRENGTH]`, in the order of lampParts(), with one text per lamp.
/// @param texts  a single text; for lamps, any number
/// @returns BadUsage naming the setting, the value found and the expected kind; checkValue() checks ranges
Result<SettingValue> valueFromText(const Setting& setting, std::span<const std::string> texts);

/// Writes a value in the same form, with the fewest digits that give the number again. Empty for no value and for no
/// lamps.
std::string valueText(const SettingValue& value);

}  // namespace qrelief
