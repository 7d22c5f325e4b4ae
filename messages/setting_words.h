// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace qrelief {

/// The words of the settings, from messages/settings/settings.json:
///
///     "settings": {
///       "minWallMm": {
///         "label": { "en": "Wall left", "de": "Restwand" },        of a control, without the unit
///         "help":  { "en": "…", "de": "…" },                       `{@key}` is a setting
///         "empty": { "en": "…", "de": "…" },                       what counts where it is not given, if no value says
///         it "without": { "en": "…", "de": "…" },                     help of the flag that switches it off "choices":
///         { "name": { "en": "…", "de": "…" } },         and "number", "vector" where it takes those "parts": {
///         "number": { "en": "…", "de": "…" } }          labels of the parts it is set by
///       }
///     },
///     "groups": { "depth": { "en": "…", "de": "…" } },
///     "units": { "mm": { "en": "…", "de": "…" } }
const nlohmann::json& settingWords();

}  // namespace qrelief
