// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// The whole file; BadInput if it cannot be read or is larger than the readers take.
Result<std::vector<std::uint8_t>> readFile(const std::string& path);

/// Writes under a temporary name beside `path` and renames: there is never half a file.
Status writeFileAtomically(const std::string& path, std::span<const std::uint8_t> bytes);
Status writeFileAtomically(const std::string& path, const std::string& text);

/// The part of a path after the last slash.
std::string fileNameOf(const std::string& path);

}  // namespace qrelief
