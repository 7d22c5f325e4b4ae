// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace qrelief {

/// Returns lower-case hexadecimal digits [FIPS 180-4, by OpenSSL].
std::string sha256(std::span<const std::uint8_t> bytes);
std::string sha256(std::string_view text);

/// Hashes a file piece by piece. @returns BadInput if it cannot be read
Result<std::string> sha256OfFile(const std::string& path);

}  // namespace qrelief
