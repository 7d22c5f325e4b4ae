// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "math/vec.h"
#include "verification/grades.h"
#include "verification/printability.h"

/// Pieces that the reports of `engrave` and `verify` have in common.
namespace qrelief {

inline nlohmann::ordered_json triple(Vec3 v) { return nlohmann::ordered_json::array({v.x, v.y, v.z}); }

/// "iso15415" and "iso29158" of a report, marked as simulated.
struct GradeReports {
  nlohmann::ordered_json iso15415, iso29158;
};
GradeReports describeGrades(const SymbolGrades& grades);

nlohmann::ordered_json describeAdvice(const std::vector<PrintAdvice>& advice);

/// @returns null for lengths that are not finite
nlohmann::ordered_json describeFeatures(const CarvedFeatures& features, const Printer& printer);

}  // namespace qrelief
