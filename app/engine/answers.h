// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "base/message_json.h"
#include "base/progress.h"
#include "base/result.h"
#include "math/vec.h"
#include "mesh/prepare.h"

namespace qrelief {

/// Answer of one of the engine's verbs, as JSON text: {"ok": true, …} or {"ok": false, "error": {"kind", "code",
/// "values"}}. Code and values belong to a message (base/message_json.h).
using Json = nlohmann::ordered_json;

/// Serialises JSON. Texts from files may hold bytes that are not UTF-8; each becomes a replacement character.
std::string textOf(const Json& json);

/// Returns {"ok": true}.
std::string done();

std::string answer(const Error& error);
std::string answer(ErrorKind kind, Message message);

/// Returns {"ok": true, stage, fraction, done}.
std::string answer(const Progress& progress, const Json& more = Json::object());

/// Returns a number; NaN for null, which is JSON for a number that is not finite.
double numberOf(const Json& json);

Json jsonOf(Vec3 v);
Json jsonOf(std::span<const Message> messages);

extern const Error kNoModel, kNoCode, kNoResult;

/// Lists the parser's warnings, then the findings about the model, each as {"severity", "code", "values"}.
Json jsonOf(std::span<const Message> warnings, std::span<const Finding> findings);

/// Returns a verb's answer. If an exception ends the verb, returns an error with the code out-of-memory or
/// internal-fault.
std::string guarded(const std::function<std::string()>& verb);

}  // namespace qrelief
