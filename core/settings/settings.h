// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "light/directional_light.h"
#include "math/vec.h"
#include "settings/units.h"

namespace qrelief {

struct DepthRequest;
struct EngraveRequest;
struct MarkRequest;
struct PlacementRequest;
struct PrinterRequest;

/// Value of a setting: nothing (other settings then decide), a switch, a number, a text, a mask or the name of a
/// choice, a vector, or lamps.
using SettingValue = std::variant<std::monostate, bool, double, std::string, Vec3, std::vector<DirectionalLight>>;

/// A part of a request that the user can set. Its words (label, help, names of choices) are in
/// locales/ under its key. Its default is its value in a default request.
struct Setting {
  enum class Kind {
    Text,
    Switch,
    Number,
    Choice,
    ChoiceOrNumber,  ///< the name of a choice, or a number within the range
    ChoiceOrVector,
    Vector,
    Mask,  ///< the carved submodules of a module: qr/module_pattern.h
    Lamps  ///< a list of lamps, see lampParts()
  };

  std::string key;    ///< one name everywhere, with its unit: flag (messages/sentences.h), JSON, report, page
  std::string group;  ///< key of the group; settings of a group are adjacent
  Kind kind = Kind::Number;
  Unit unit = Unit::None;
  double min = 0, max = 1;           ///< range of a number, inclusive
  double step = 0.1;                 ///< step of a control's buttons
  double usual = 0;                  ///< ChoiceOrNumber: the number that a control starts with
  bool isWhole = false;              ///< a number without decimals
  bool mayBeEmpty = false;           ///< may be set to nothing
  std::vector<std::string> choices;  ///< names of the choices
  SettingValue (*read)(const EngraveRequest&) = nullptr;
  void (*write)(EngraveRequest&, const SettingValue&) = nullptr;  ///< needs a value of the right kind, see checkValue()
  /// For a number that may be empty: returns the value used instead; null if it is known only later.
  double (*otherwise)(const EngraveRequest&) = nullptr;

  bool takesNumber() const { return kind == Kind::Number || kind == Kind::ChoiceOrNumber; }
  bool takesChoice() const {
    return kind == Kind::Choice || kind == Kind::ChoiceOrNumber || kind == Kind::ChoiceOrVector;
  }
  bool takesVector() const { return kind == Kind::Vector || kind == Kind::ChoiceOrVector; }
};

/// A numeric property of a lamp.
struct LampPart {
  std::string_view key;
  Unit unit = Unit::None;
  double min = 0, max = 1, step = 1;
  double DirectionalLight::*value = nullptr;
};
std::span<const LampPart> lampParts();

/// Returns all settings in the order in which to write them: the process before the nozzle and layer that it sets.
std::span<const Setting> settings();

/// Finds a setting by its key.
/// @returns null if there is no such setting
const Setting* findSetting(std::string_view key);

/// A change of one setting, by its key; a choice is given by its name.
struct SettingChange {
  std::string setting, value;

  bool operator==(const SettingChange&) const = default;
};

/// Writes a change into a request.
/// @param change  of a setting that takes a text, choices or a number, to a value that it accepts
void apply(const SettingChange& change, EngraveRequest& request);

/// Returns the request before the user sets anything: the initialisers, but with error correction raised where that
/// costs nothing, and carved for the print.
EngraveRequest defaultRequest();

/// Checks that the setting accepts the value.
/// @returns BadUsage naming the setting, the value and the accepted values
Status checkValue(const Setting& setting, const SettingValue& value);

/// Checks every setting of a request, and their combination; computes nothing.
/// @returns BadUsage for the first invalid one, see checkValue()
Status checkSettings(const EngraveRequest& request);

/// Checks every setting of a part of a request.
/// @returns BadUsage for the first invalid one, see checkValue()
Status checkSettings(const PlacementRequest& placement);
Status checkSettings(const MarkRequest& marking);
Status checkSettings(const DepthRequest& depth);
Status checkSettings(const PrinterRequest& print);

/// Returns the error for a value in a file or on a command line that the setting does not accept.
/// @param found  the value as written there
Error wrongKind(const Setting& setting, std::string_view found);

}  // namespace qrelief
