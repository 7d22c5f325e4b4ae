// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/message.h"

namespace qrelief {

/// What was found, in the command's English: its settings are flags. Without full stop.
///
/// The words come from messages/*.json, an object by code:
///
///     "stl-cut-off": {
///       "en": "The file declares {announced} facets, but has room for {room}",   `{name}` is a value
///       "de": "…",
///       "hint": { "en": "Raise {@minWallMm}", "de": "…" }                           `{@key}` is a setting
///     }
///
/// A sentence is a text, or { "one": …, "other": … } chosen by the value `count`. "command" beside "en" is what the
/// command says instead of it, where the page's words do not fit there. The page reads the same files
/// (web/i18n/messages.js).
/// @returns the code and its values, unworded, for a code that is not there: tests find those
std::string sentence(const Message& message);

/// What would help; empty if nothing is known. Without a hint of its own a message has that of its cause.
std::string hint(const Message& message);

/// The same in other words, as tests have them. @param words  by code, like the files
std::string sentence(const Message& message, const nlohmann::json& words);
std::string hint(const Message& message, const nlohmann::json& words);

/// Both in a line, for programs that only report: "The text is empty (Give the text or link to be engraved)".
std::string sentenceAndHint(const Message& message);

/// How long something takes, for programs that report: "85 s", "12 min".
std::string durationInWords(double seconds);

/// The command's name of a setting: "minWallMm" → "--min-wall". The unit is said where the value is asked for.
std::string flagOf(std::string_view key);

}  // namespace qrelief
