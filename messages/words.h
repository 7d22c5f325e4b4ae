// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace qrelief {

/// Returns a part of locales/en.json, which the build compiles in: the words of all messages, by room and code.
const char* messageWordsAsJson();

/// Returns another part: the words of the settings (setting_words.h).
const char* settingWordsAsJson();

}  // namespace qrelief
