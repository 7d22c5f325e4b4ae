// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages/setting_words.h"

#include <nlohmann/json.hpp>

#include "messages/words.h"

namespace qrelief {

const nlohmann::json& settingWords() {
  static const nlohmann::json kWords = nlohmann::json::parse(settingWordsAsJson());
  return kWords;
}

}  // namespace qrelief
