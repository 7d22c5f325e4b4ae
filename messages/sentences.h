// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/message.h"

namespace qrelief {

/// Returns the problem or fact that a message states, in the command's English: settings are flags. No full stop.
///
/// The words come from locales/en.json, by code:
///
///     "stl-cut-off": {
///       "says": "The file declares {announced} facets, but has room for {room}",   `{name}` is a value
///       "hint": "Raise {@minWallMm}",                                              `{@key}` is a setting
///       "command": { "hint": "Give --min-wall more" }
///     }
///
/// A text may have forms, { "one": …, "other": … }, of which the value `count`, a count or a number, selects one. The
/// command uses the texts in "command" where the page's words do not fit. The page reads the same file
/// (web/i18n/sentences.js).
/// @returns the code and its values without words for an unknown code; tests find such a fault
std::string sentence(const Message& message);

/// Returns the message's hint, or else the hint of its cause; empty if there is none.
std::string hint(const Message& message);

/// Do the same with other words, for tests. @param words  by code
std::string sentence(const Message& message, const nlohmann::json& words);
std::string hint(const Message& message, const nlohmann::json& words);

/// Returns both in one line, for programs that only report: "The text is empty (Enter the text or link to engrave)".
std::string sentenceAndHint(const Message& message);

/// Returns a count with its noun for programs that report: "1 row", "2 rows".
std::string counted(std::size_t count, std::string_view one, std::string_view other);

/// Returns a length for programs that report, as in a sentence: "0.244 mm", "12346 mm"; below a nanometre "0 mm".
/// @param significant  digits, but never fewer than those before the decimal point
std::string lengthInWords(double mm, int significant = 3);

/// Returns the size of a box for programs that report: "100 × 2.54 × 0.05 mm".
std::string extentInWords(double xMm, double yMm, double zMm, int significant = 3);

/// Returns a duration for programs that report: "85 s", "12 min".
std::string durationInWords(double seconds);

/// Returns the command's flag of a setting: "minWallMm" → "--min-wall". The flag's help names the unit.
std::string flagOf(std::string_view key);

}  // namespace qrelief
