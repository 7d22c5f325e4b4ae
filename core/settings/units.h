// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "base/message.h"

namespace qrelief {

/// Unit of a number that users set.
enum class Unit { None, Millimetre, Degree, Sky };

/// How a unit is written. Its words in each language are in locales/ under its name.
struct UnitTraits {
  Unit unit = Unit::None;
  std::string_view name;       ///< key of the unit in the page and in locales/: "mm"; empty: no unit
  std::string_view symbol;     ///< English label: "mm"
  std::string_view keySuffix;  ///< end of a setting's key, left out of its flag: "Mm"; may be empty
  std::string_view valueName;  ///< name of a value in `--help`: "MM"; empty: N or NUMBER
  MessageValue::Kind kind = MessageValue::Kind::Number;  ///< of a value in a message
};

/// Returns all units, in the order of the enumeration.
std::span<const UnitTraits> units();
const UnitTraits& traitsOf(Unit unit);

}  // namespace qrelief
