// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "settings/settings.h"

namespace qrelief {

/// A setting, or a part of one, that can be tuned as a number: a choice by its index, a switch as 0 or 1, what is set
/// to nothing as 0, or as what counts then.
struct Tunable {
  const Setting* setting = nullptr;
  std::string key;  ///< the setting's, or that and its part's: "contrast", "size.number", "light.1.azimuthDeg"
  double min = 0, max = 1, step = 1;
  /// Names; empty for a number or a switch. Behind the setting's own stands "number" or "vector" where it takes one.
  std::vector<std::string> choices;
  bool isSwitch = false;
  std::function<double(const EngraveRequest&)> read;
  std::function<void(EngraveRequest&, double)> write;
};

/// Everything of a request but its text, centre, up axis and what is recorded; groups stand together.
std::span<const Tunable> tunables();

/// What differs from the page's request on purpose, by index in `tunables()`. The page's own controls stay what they
/// are: what is not overridden follows them.
class RequestOverrides {
 public:
  RequestOverrides();

  /// @param value  is brought into the tunable's range; the page's own value ends the override
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
