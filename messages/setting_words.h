// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace qrelief {

/// Returns the English words of the settings, from locales/en.json. In a text, `{@key}` names a setting.
///
///     "settings": {
///       "minWallMm": {
///         "label": "Minimum wall", "help": "…", "hint": "…", "empty": "…", "without": "…",
///         "choices": { "name": "…" },
///         "parts": { "number": "…" }
///       }
///     },
///     "groups": { "depth": "…" },
///     "units": { "mm": "…" }
///
/// "label" names the control, without the unit. "hint" is a sentence under the control on the page, if it needs one.
/// "empty" describes the effect of an empty setting, if no value does. "without" is the help of the flag that switches
/// the setting off. "choices" also has "number" or "vector" if the setting takes one. "parts" names the parts that have
/// controls of their own.
const nlohmann::json& settingWords();

}  // namespace qrelief
