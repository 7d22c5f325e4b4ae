// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/facts.h"

#include <utility>

#include "engine/answers.h"
#include "engine/model_file.h"
#include "engine/symbol_facts.h"
#include "qr/link_advice.h"
#include "settings/engrave_request.h"
#include "settings/setting_json.h"

namespace qrelief {

std::string Facts::model(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm) const {
  const auto file = readModelFile(std::move(bytes), fileName, scaleToMm);
  if (!file) return answer(file.error());
  return textOf(
      {{"ok", true}, {"model", describeModel(file->format, file->scaleToMm, file->warnings, file->prepared)}});
}

std::string Facts::symbol(const std::string& settings) const {
  const auto request = requestFromJson(settings);
  return request ? describeSymbol(*request) : answer(request.error());
}

std::string Facts::textAdvice(const std::string& text) const {
  Json advice = Json::array(), shorter = Json::array();
  for (const TextAdvice& one : adviseText(text))
    advice.push_back({{"severity", one.severity == TextAdvice::Severity::Warning ? "warning" : "note"},
                      {"message", jsonOf(one.message)},
                      {"fixed", one.fixed}});
  for (const ShorterForm& form : shorterForms(text))
    shorter.push_back({{"form", shorterFormName(form.kind)}, {"text", form.text}});
  return textOf({{"ok", true}, {"advice", std::move(advice)}, {"shorter", std::move(shorter)}});
}

}  // namespace qrelief
