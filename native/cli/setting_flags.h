// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <list>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "settings/settings.h"

namespace qrelief {

/// Flags of a command that are settings (settings/settings.h). Names, help, defaults and checks come from there.
class SettingFlags {
 public:
  /// Adds the flag of a setting. SettingFlags must outlive the parsing.
  /// @param before  text to put before the help
  CLI::Option& add(CLI::App& command, std::string_view key, std::string_view before = {});
  /// Adds the settings of a group, except texts.
  void addGroup(CLI::App& command, std::string_view group);
  /// Adds the settings of all groups.
  void addAll(CLI::App& command);

  bool isGiven(std::string_view key) const;

  /// Returns the keys of the given settings.
  std::vector<std::string> given() const;

  /// Returns the given value, or the default. @returns BadUsage for a value that is invalid or out of its range
  Result<SettingValue> value(std::string_view key) const;

  /// Returns the default request with the given values.
  /// @returns BadUsage for the first value that is invalid or out of its range
  Result<EngraveRequest> request() const;

 private:
  struct Flag {
    const Setting* setting = nullptr;
    const CLI::Option* option = nullptr;
    std::vector<std::string> texts;
  };
  const Flag* find(std::string_view key) const;

  std::list<Flag> flags_;  // the parser keeps the address of each one's texts
};

}  // namespace qrelief
