// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/answers.h"

#include "base/message_json.h"

namespace qrelief {
namespace {

const char* nameOf(ErrorKind code) {
  switch (code) {
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

}  // namespace

std::string textOf(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string done() { return textOf({{"ok", true}}); }

std::string answer(const Error& error) {
  return textOf(
      {{"ok", false},
       {"error",
        {{"code", nameOf(error.kind)}, {"message", toldText(error.message)}, {"hint", toldHint(error.message)}}}});
}

std::string answer(ErrorKind code, std::string message, std::string hint) {
  return answer(Error{code, untold(std::move(message), std::move(hint))});
}

std::string answer(const Progress& progress) {
  return textOf(
      {{"ok", true}, {"stage", jsonOf(progress.stage)}, {"fraction", progress.fraction}, {"done", progress.done}});
}

Json jsonOf(Vec3 v) { return Json::array({v.x, v.y, v.z}); }

Json jsonOf(std::span<const Message> warnings, std::span<const Finding> findings) {
  Json list = Json::array();
  const auto add = [&](const char* severity, const Message& message) {
    list.push_back({{"severity", severity}, {"code", message.code}, {"values", jsonOf(message)["values"]}});
  };
  for (const Message& warning : warnings) add("warning", warning);
  for (const Finding& finding : findings) add(severityName(finding.severity), finding.message);
  return list;
}

}  // namespace qrelief
