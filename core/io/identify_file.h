// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/message.h"

namespace qrelief {

/// Returns what a file is that holds no model we can read, such as a picture, a web page or G-code, for an error; none
/// if the file shows no sign of it.
///
/// Cost: looks at no more than the first kilobytes.
std::optional<Message> identifyFile(std::span<const std::uint8_t> bytes);

}  // namespace qrelief
