// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/answers.h"

#include <exception>
#include <limits>
#include <new>

#include "message_codes/engine.h"

namespace qrelief {

namespace {

const char* nameOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::BadUsage:
      return "BadUsage";
    case ErrorKind::BadInput:
      return "BadInput";
    case ErrorKind::NoSolution:
      return "NoSolution";
    case ErrorKind::Internal:
      break;
  }
  return "Internal";
}

/// Adds "code" and "values" to an object.
Json besides(Json json, const Message& message) {
  json.update(jsonOf(message));
  return json;
}

}  // namespace

const Error kNoModel = {ErrorKind::BadUsage, message<"no-model">()};
const Error kNoCode = {ErrorKind::BadUsage, message<"no-code-placed">()};
const Error kNoResult = {ErrorKind::BadUsage, message<"nothing-engraved">()};

std::string textOf(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string done() { return textOf({{"ok", true}}); }

std::string answer(const Error& error) {
  return textOf({{"ok", false}, {"error", besides({{"kind", nameOf(error.kind)}}, error.message)}});
}

std::string answer(ErrorKind kind, Message message) { return answer(Error{kind, std::move(message)}); }

std::string answer(const Progress& progress, const Json& more) {
  Json json = {
      {"ok", true}, {"stage", jsonOf(progress.stage)}, {"fraction", progress.fraction}, {"done", progress.done}};
  json.update(more);
  return textOf(json);
}

double numberOf(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Json jsonOf(Vec3 v) { return Json::array({v.x, v.y, v.z}); }

Json jsonOf(std::span<const Message> messages) {
  Json array = Json::array();
  for (const Message& message : messages) array.push_back(jsonOf(message));
  return array;
}

Json jsonOf(std::span<const Message> warnings, std::span<const Finding> findings) {
  Json list = Json::array();
  for (const Message& warning : warnings) list.push_back(besides({{"severity", "warning"}}, warning));
  for (const Finding& finding : findings)
    list.push_back(besides({{"severity", severityName(finding.severity)}}, finding.message));
  return list;
}

std::string guarded(const std::function<std::string()>& verb) {
  try {
    return verb();
  } catch (const std::bad_alloc&) {
    return answer(ErrorKind::Internal, message<"out-of-memory">());
  } catch (const std::exception& exception) {
    return answer(ErrorKind::Internal, message<"internal-fault">(with::term<"detail">(exception.what())));
  }
}

}  // namespace qrelief
