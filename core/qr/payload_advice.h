// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "base/message.h"

namespace qrelief {

/// Checks a text with the data of a Wi-Fi network ("WIFI:T:WPA;S:name;P:password;;") or a contact (vCard) for faults
/// that phones do not forgive: semicolons without a backslash, parts that do not end, a missing name or last line.
///
/// Cost: linear.
/// @returns none for a good one, and for any other text
std::optional<Message> advisePayload(std::string_view text);

}  // namespace qrelief
