// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace qrelief {

/// Returns the words of the settings, from messages/settings/settings.json. In a text, `{@key}` names a setting.
///
///     "settings": {
///       "minWallMm": {
///         "label":   { "en": "Minimum wall", "de": "Restwand" },
///         "help":    { "en": "…", "de": "…" },
///         "hint":    { "en": "…", "de": "…" },
///         "empty":   { "en": "…", "de": "…" },
///         "without": { "en": "…", "de": "…" },
///         "choices": { "name": { "en": "…", "de": "…" } },
///         "parts":   { "number": { "en": "…", "de": "…" } }
///       }
///     },
///     "groups": { "depth": { "en": "…", "de": "…" } },
///     "units": { "mm": { "en": "…", "de": "…" } }
///
/// "label" names the control, without the unit. "hint" is a sentence under the control on the page, if it needs one.
/// "empty" describes the effect of an empty setting, if no value does. "without" is the help of the flag that switches
/// the setting off. "choices" also has "number" or "vector" if the setting takes one. "parts" names the parts that have
/// controls of their own.
const nlohmann::json& settingWords();

}  // namespace qrelief
