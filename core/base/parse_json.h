// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace qrelief {

/// Deepest nesting of arrays and objects that parseJson() accepts.
inline constexpr std::size_t kMaxJsonDepth = 64;

/// How numbers come out of parseJson().
enum class JsonNumbers {
  Values,
  AsWritten  ///< as binary values, which JSON itself cannot hold, with the characters of the text (numberText())
};

/// Parses a JSON text from outside: a batch row, a report, settings, a request of the page. The result is shallow
/// enough for code that recurses. Cost: O(n log n), without recursion.
/// @returns BadInput with the code json-malformed, json-too-deep or json-key-twice (an object has a key twice)
Result<nlohmann::ordered_json> parseJson(std::string_view text, JsonNumbers numbers = JsonNumbers::Values);

/// Returns the characters of a number that parseJson() has left as written: 89490200001234567890 keeps its digits, and
/// 1.50 its zero.
std::string numberText(const nlohmann::ordered_json& number);

}  // namespace qrelief
