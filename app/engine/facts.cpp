// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/facts.h"

#include <utility>

#include "engine/model_file.h"
#include "engine/symbol_facts.h"
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

}  // namespace qrelief
