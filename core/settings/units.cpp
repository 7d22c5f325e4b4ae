// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/units.h"

#include <array>
#include <cstddef>

namespace qrelief {
namespace {

using Kind = MessageValue::Kind;

constexpr std::array<UnitTraits, 4> kUnits = {{{Unit::None, "", "", "", "", Kind::Number},
                                               {Unit::Millimetre, "mm", "mm", "Mm", "MM", Kind::LengthMm},
                                               {Unit::Degree, "deg", "°", "Deg", "DEG", Kind::AngleDeg},
                                               {Unit::Sky, "skies", "skies", "", "", Kind::Number}}};

}  // namespace

std::span<const UnitTraits> units() { return kUnits; }
const UnitTraits& traitsOf(Unit unit) { return kUnits[static_cast<std::size_t>(unit)]; }

}  // namespace qrelief
