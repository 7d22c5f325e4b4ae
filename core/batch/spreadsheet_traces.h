// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "base/message.h"
#include "batch/batch_list.h"

namespace qrelief {

/// Returns a warning about a value that a spreadsheet has probably changed: a number shortened to 9,52112E+12 or
/// rounded after 15 digits, a date made of 2-MAR, a number written as 1001.0; or about an error such as `#REF!`.
/// @param line    of the list
/// @param column  name of the cell's column
std::optional<Message> spreadsheetTrace(std::string_view value, std::string_view column, std::size_t line);

/// Returns a warning about a column of numbers of the same length, some of which have probably lost their leading
/// zeros: they are shorter, and follow numbers that are not. Cost: linear.
std::optional<Message> lostZeros(const BatchList& list, std::size_t column);

}  // namespace qrelief
