// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/unit_suggestions.h"

#include <algorithm>
#include <array>

#include "message_codes/model.h"

namespace qrelief {
namespace {

constexpr double kLeastPrintedMm = 15, kMostPrintedMm = 500;
constexpr std::size_t kMostSuggestions = 2;

struct Unit {
  const char* name;
  double mm;
};
/// In the order of suggestions.
constexpr std::array<Unit, 5> kUnits = {{{"m", 1000}, {"in", 25.4}, {"cm", 10}, {"mm", 1}, {"um", 0.001}}};

}  // namespace

std::vector<UnitSuggestion> suggestUnits(Vec3 sizeMm, double scaleToMm) {
  std::vector<UnitSuggestion> suggestions;
  const double largest = std::max({sizeMm.x, sizeMm.y, sizeMm.z});
  for (const auto& [unit, mm] : kUnits) {
    const double factor = mm / scaleToMm;
    if (mm != scaleToMm && largest * factor >= kLeastPrintedMm && largest * factor <= kMostPrintedMm)
      suggestions.push_back({unit, mm, sizeMm * factor});
  }
  if (suggestions.size() > kMostSuggestions) suggestions.resize(kMostSuggestions);
  return suggestions;
}

Message unitAdvice(std::span<const UnitSuggestion> suggestions) {
  if (suggestions.empty()) return message<"unit-may-be-wrong">();
  const UnitSuggestion& first = suggestions[0];
  if (suggestions.size() == 1)
    return message<"unit-that-fits">(with::choice<"unit">("units", first.unit), with::extentMm<"size">(first.sizeMm));
  const UnitSuggestion& second = suggestions[1];
  return message<"units-that-fit">(with::choice<"unit">("units", first.unit), with::extentMm<"size">(first.sizeMm),
                                   with::choice<"otherUnit">("units", second.unit),
                                   with::extentMm<"otherSize">(second.sizeMm));
}

Message smallerUnitAdvice(std::span<const UnitSuggestion> suggestions) {
  if (suggestions.empty()) return message<"unit-may-be-smaller">();
  const UnitSuggestion& first = suggestions[0];
  return message<"smaller-unit-that-fits">(with::choice<"unit">("units", first.unit),
                                           with::extentMm<"size">(first.sizeMm));
}

}  // namespace qrelief
