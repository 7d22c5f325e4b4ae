// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "base/message_json.h"
#include "base/progress.h"
#include "base/result.h"
#include "math/vec.h"
#include "mesh/prepare.h"

namespace qrelief {

/// What the engine's verbs answer, as JSON text: {"ok": true, …} or {"ok": false, "error": {"kind", "code", "values"}},
/// where code and values are those of a message (base/message_json.h).
using Json = nlohmann::ordered_json;

/// Texts from files may hold bytes that are no UTF-8: they become replacement characters.
std::string textOf(const Json& json);

/// {"ok": true}
std::string done();

std::string answer(const Error& error);
std::string answer(ErrorKind kind, Message message);

/// {"ok": true, stage, fraction, done}
std::string answer(const Progress& progress, const Json& more = Json::object());

Json jsonOf(Vec3 v);

inline const Error kNoModel = {ErrorKind::BadUsage, message("no-model")};

/// The reader's warnings, then what was found out about the model: {"severity", "code", "values"} each.
Json jsonOf(std::span<const Message> warnings, std::span<const Finding> findings);

}  // namespace qrelief
