// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "base/result.h"

namespace qrelief {

/// Deepest nesting of arrays and objects that parseJson() accepts.
inline constexpr std::size_t kMaxJsonDepth = 64;

/// Parses a JSON text from outside: a batch row, a report, settings, a request of the page. The result is shallow
/// enough for code that recurses. Cost: O(n log n), without recursion.
/// @returns BadInput with the code json-malformed, json-too-deep or json-key-twice (an object has a key twice)
Result<nlohmann::ordered_json> parseJson(std::string_view text);

}  // namespace qrelief
