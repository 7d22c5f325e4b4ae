// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/message.h"
#include "math/vec.h"
#include "verdict/verdict.h"
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

/// How messages are told, in reports that people read; none: as codes and values alone, for who words them itself.
struct Wording {
  std::function<std::string(const Message&)> sentence = {}, hint = {};
};

/// {"code", "values"}, and with a wording {"message", "hint"}, too.
nlohmann::ordered_json describeMessage(const Message& message, const Wording& wording);
nlohmann::ordered_json describeMessages(const std::vector<Message>& messages, const Wording& wording);

/// {"passed", "reads": {"level", "passed", "summary", "warnings", "reasons", "remedies"}, "prints", "solid"}; a remedy
/// is a message with {"change": {"setting", "value"}}, which is absent where another place has to be chosen.
nlohmann::ordered_json describeAspect(const Aspect& aspect, const Wording& wording);
nlohmann::ordered_json describeVerdict(const Verdict& verdict, const Wording& wording);

/// [{"azimuthDeg", "elevationDeg", "strength"}]
nlohmann::ordered_json describeLights(const std::vector<DirectionalLight>& lights);

/// {"process", "facingDeg", "tries", "reads", "readsNeeded", "read"}. @returns null if it was not found out
nlohmann::ordered_json describePrinted(const std::optional<PrintedEvidence>& printed);

/// @returns null for lengths that are not finite
nlohmann::ordered_json describeFeatures(const CarvedFeatures& features, const Printer& printer);

}  // namespace qrelief
