// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "settings/settings.h"

namespace qrelief {

/// A setting, or a part of one, that can be tuned as a number: a choice by its index, a switch as 0 or 1, an empty
/// setting as 0 or as the value used instead.
struct Tunable {
  const Setting* setting = nullptr;
  std::string key;  ///< the setting's key, for a part with the part's: "contrast", "size.number", "light.1.azimuthDeg"
  double min = 0, max = 1, step = 1;
  /// Names of the choices; empty for a number or a switch. Followed by "number" or "vector" if the setting takes one.
  std::vector<std::string> choices;
  bool isSwitch = false;
  std::function<double(const EngraveRequest&)> read;
  std::function<void(EngraveRequest&, double)> write;
};

/// Returns all tunables of a request, that is, all settings except texts and the up axis; groups are adjacent.
std::span<const Tunable> tunables();

/// Deliberate deviations from the page's request, by index in `tunables()`. The page's own controls keep their values,
/// and everything not overridden follows them.
class RequestOverrides {
 public:
  RequestOverrides();

  /// Overrides a value.
  /// @param value  clamped to the tunable's range; the page's own value ends the override
  void set(std::size_t index, double value, const EngraveRequest& page);
  void reset(std::size_t index) { values_[index].reset(); }
  void resetAll();
  bool isSet(std::size_t index) const { return values_[index].has_value(); }
  std::size_t count() const;
  double valueOf(std::size_t index, const EngraveRequest& page) const;
  EngraveRequest appliedTo(EngraveRequest page) const;

 private:
  std::vector<std::optional<double>> values_;
};

}  // namespace qrelief
