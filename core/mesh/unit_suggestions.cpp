// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/unit_suggestions.h"

#include <algorithm>

namespace qrelief {
namespace {

constexpr double kLeastPrintedMm = 15, kMostPrintedMm = 500;

}  // namespace

std::vector<UnitSuggestion> suggestUnits(Vec3 sizeMm, double scaleToMm) {
  std::vector<UnitSuggestion> suggestions;
  const double largest = std::max({sizeMm.x, sizeMm.y, sizeMm.z});
  for (const auto& [unit, mm] : {std::pair("m", 1000.0), std::pair("in", 25.4), std::pair("cm", 10.0)}) {
    const double factor = mm / scaleToMm;
    if (mm != scaleToMm && largest * factor >= kLeastPrintedMm && largest * factor <= kMostPrintedMm)
      suggestions.push_back({unit, mm, sizeMm * factor});
  }
  return suggestions;
}

Message unitAdvice(std::span<const UnitSuggestion> suggestions) {
  if (suggestions.empty()) return message("unit-may-be-wrong");
  const UnitSuggestion& first = suggestions[0];
  if (suggestions.size() == 1)
    return message("unit-that-fits", with::choice<"unit">("units", first.unit), with::extentMm<"size">(first.sizeMm));
  // Inches and centimetres can both fit; metres fit only alone, as 15 mm in centimetres is 1500 mm in metres.
  const UnitSuggestion& second = suggestions[1];
  return message("units-that-fit", with::choice<"unit">("units", first.unit), with::extentMm<"size">(first.sizeMm),
                 with::choice<"otherUnit">("units", second.unit), with::extentMm<"otherSize">(second.sizeMm));
}

}  // namespace qrelief
