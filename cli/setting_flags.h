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

/// Flags of a command that are settings (settings/settings.h): their names, helps, defaults and checks come from there.
class SettingFlags {
 public:
  /// Adds the flag of a setting. It must outlive the parsing.
  /// @param before  what the help begins with
  CLI::Option& add(CLI::App& command, std::string_view key, std::string_view before = {});
  /// Adds those of a group, but for texts.
  void addGroup(CLI::App& command, std::string_view group);
  /// Adds all, but for texts.
  void addAll(CLI::App& command);

  bool isGiven(std::string_view key) const;

  /// What was given, or what a default request says. @returns BadUsage for a value that is none or is out of its range
  Result<SettingValue> value(std::string_view key) const;

  /// The default request with what was given laid over it.
  /// @returns BadUsage for the first value that is none or is out of its range
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
