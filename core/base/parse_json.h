// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "base/result.h"

namespace qrelief {

/// Arrays and objects within each other that parseJson() accepts.
inline constexpr std::size_t kMaxJsonDepth = 64;

/// Parses a JSON text from outside: a list's row, a report, settings, a request of the page. Everything read from it is
/// shallow enough for code that recurses. Cost: O(n log n), without recursion.
/// @returns BadInput with the code json-malformed, json-too-deep or json-key-twice (an object has a key twice)
Result<nlohmann::ordered_json> parseJson(std::string_view text);

}  // namespace qrelief
