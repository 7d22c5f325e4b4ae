// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/message.h"
#include "carving/mark.h"
#include "light/directional_light.h"
#include "math/vec.h"
#include "verdict/verdict.h"
#include "verification/grades.h"
#include "verification/printability.h"

// Pieces that the reports of `engrave` and `verify` share.
namespace qrelief {

struct Ink;
struct Printer;

inline nlohmann::ordered_json triple(Vec3 v) { return nlohmann::ordered_json::array({v.x, v.y, v.z}); }

/// The parts "iso15415" and "iso29158" of a report, marked as simulated.
struct GradeReports {
  nlohmann::ordered_json iso15415, iso29158;
};
GradeReports describeGrades(const SymbolGrades& grades);

/// Functions that put messages into words, for reports that people read. If empty, messages are codes and values alone,
/// for programs that word them.
struct Wording {
  std::function<std::string(const Message&)> sentence = {}, hint = {};
};

/// Describe a message as {"code", "values"}, and with a wording {"message", "hint"}, too.
nlohmann::ordered_json describeMessage(const Message& message, const Wording& wording);
nlohmann::ordered_json describeMessages(const std::vector<Message>& messages, const Wording& wording);

/// Describe a verdict as {"passed", "reads": {"level", "passed", "summary", "warnings", "reasons", "remedies"},
/// "prints", "solid"}. A remedy is a message with {"changes": [{"setting", "value"}]}; "changes" is absent if the
/// remedy is another spot.
nlohmann::ordered_json describeAspect(const Aspect& aspect, const Wording& wording);
nlohmann::ordered_json describeVerdict(const Verdict& verdict, const Wording& wording);

/// Describes lamps as [{"azimuthDeg", "elevationDeg", "strength"}].
nlohmann::ordered_json describeLights(const std::vector<DirectionalLight>& lights);

/// Describes a print as {"process", "facingDeg", "tries", "reads", "readsNeeded", "read"}.
/// @returns null if the print was not simulated
nlohmann::ordered_json describePrinted(const std::optional<PrintedEvidence>& printed);

/// Adds "mark" and "albedo" to a report, and for a code in colour "markDepthMm" and "darkReflectance".
void addMark(nlohmann::ordered_json& report, Mark mark, double markDepthMm, const Ink& ink);

/// Describes the printed features. Lengths that are not finite become null.
nlohmann::ordered_json describeFeatures(const CarvedFeatures& features, const Printer& printer);

}  // namespace qrelief
