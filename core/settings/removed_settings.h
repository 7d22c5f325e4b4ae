// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/message.h"

namespace qrelief {

/// A setting of earlier versions, or one choice of a setting that is still there. Readers of settings ignore it with a
/// warning, so that old files, addresses, lists and scripts still work.
struct RemovedSetting {
  std::string key;
  std::string flag;       ///< as it was: "--raise-ecc"
  std::string choice;     ///< empty: the whole setting is gone
  std::string group;      ///< group of its flag, see Setting::group; empty for a choice
  bool isSwitch = false;  ///< its flag took no value
  std::string since;      ///< first version without it
  Message why;            ///< reason, or what to use instead
};

/// Returns all removed settings and choices.
std::span<const RemovedSetting> removedSettings();

/// Finds a removed setting by its key.
/// @returns null if no such setting was removed
const RemovedSetting* findRemovedSetting(std::string_view key);

/// Finds a removed choice of a setting that is still there.
/// @returns null if no such choice was removed
const RemovedSetting* findRemovedChoice(std::string_view key, std::string_view choice);

/// Returns the warning that a removed setting is ignored.
/// @param name  as the user wrote it: a flag, a key, a column
Message removedWarning(const RemovedSetting& removed, std::string_view name);

}  // namespace qrelief
