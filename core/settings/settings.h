// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "settings/engrave_request.h"

namespace qrelief {

/// What a setting is set to: nothing (what then counts follows from the rest), a switch, a number, a text or the name
/// of a choice, a vector, or lamps.
using SettingValue = std::variant<std::monostate, bool, double, std::string, Vec3, std::vector<DirectionalLight>>;

/// Something of a request that a person can set. Its words (label, help, names of choices) stand by its key in
/// messages/settings/settings.json; its default is what a default request says.
struct Setting {
  enum class Kind {
    Text,
    Switch,
    Number,
    Choice,
    ChoiceOrNumber,  ///< the name of a choice, or a number within the range
    ChoiceOrVector,
    Vector,
    Lamps  ///< a list of them, see lampParts()
  };
  enum class Unit { None, Millimetre, Degree, Module, Sky };

  std::string key;    ///< one name everywhere, with its unit: flag (messages/sentences.h), JSON, report, page
  std::string group;  ///< key of the group; groups stand together
  Kind kind = Kind::Number;
  Unit unit = Unit::None;
  double min = 0, max = 1;           ///< of a number, inclusive
  double step = 0.1;                 ///< of a control's buttons
  double usual = 0;                  ///< ChoiceOrNumber: the number that a control begins with
  bool isWhole = false;              ///< a number without decimals
  bool mayBeEmpty = false;           ///< may be set to nothing
  std::vector<std::string> choices;  ///< their names
  const char* since = "0.1.0";       ///< the program's version that knew it first
  SettingValue (*read)(const EngraveRequest&) = nullptr;
  void (*write)(EngraveRequest&, const SettingValue&) = nullptr;  ///< a value of the right kind, else see checkValue()
  /// Of a number that may be empty: what then counts; null where that is known only later.
  double (*otherwise)(const EngraveRequest&) = nullptr;

  bool takesNumber() const { return kind == Kind::Number || kind == Kind::ChoiceOrNumber; }
  bool takesChoice() const {
    return kind == Kind::Choice || kind == Kind::ChoiceOrNumber || kind == Kind::ChoiceOrVector;
  }
  bool takesVector() const { return kind == Kind::Vector || kind == Kind::ChoiceOrVector; }
};

/// A number of a lamp.
struct LampPart {
  std::string_view key;
  Setting::Unit unit = Setting::Unit::None;
  double min = 0, max = 1, step = 1;
  double DirectionalLight::*value = nullptr;
};
std::span<const LampPart> lampParts();

/// Every setting, in the order in which they are to be written: error correction before whether it is raised.
std::span<const Setting> settings();

/// @returns null if there is no such setting
const Setting* findSetting(std::string_view key);

/// A change of one setting, by its key; a choice by its name.
struct SettingChange {
  std::string setting, value;

  bool operator==(const SettingChange&) const = default;
};

/// @param change  of a setting that takes choices, to one of them
void apply(const SettingChange& change, EngraveRequest& request);

/// What a request is before a person has said anything: that of its initialisers, and error correction is raised where
/// that costs nothing, and the print has to be dark enough.
EngraveRequest defaultRequest();

/// Whether the setting takes the value. @returns BadUsage naming the setting, what it is and what it may be
Status checkValue(const Setting& setting, const SettingValue& value);

/// Whether every setting of a request is one that can be worked with; nothing is computed.
/// @returns BadUsage for the first that is not, see checkValue()
Status checkSettings(const EngraveRequest& request);

/// For readers of settings: that what was found in a file or a command line is nothing that the setting takes.
/// @param found  as it stands there
Error wrongKind(const Setting& setting, std::string_view found);

}  // namespace qrelief
