// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace qrelief {

/// The double nearest to a decimal number, whatever the locale: an optional sign, digits with an optional point, an
/// optional exponent; also "nan", "inf" and "infinity" in any case, so that a reader can say what it found.
///
/// Cost: about 10 ns up to 15 digits and a small exponent (one exact multiplication or division by a power of ten
/// [Clinger 1990]), else one strtod of a copy.
/// @param token  the whole of it must be the number: no white space, nothing behind it
/// @returns empty if it is none
std::optional<double> parseNumber(std::string_view token);

/// A decimal integer with an optional sign; empty if it is none or does not fit.
std::optional<std::int64_t> parseInteger(std::string_view token);

}  // namespace qrelief
